// SPDX-License-Identifier: MIT
//
// Keys outside the viewer, and the dialogue that lists all keys.

import { type Command, commandOf, type GeodesicVoronoiElement } from '../../viewer/element.js';
import { byId, onClick } from '../base/dom.js';
import { hideError } from '../base/messages.js';

/** Commands of keys outside the viewer; with the focus in it, the viewer handles all its keys. */
const everywhere: ReadonlySet<Command> = new Set(['undo', 'redo', 'remove', 'refit', 'cancel']);

/** Keys that press a button. */
const ofButtons: Readonly<Record<string, string>> = {
  '?': 'help-button',
  h: 'hide-panel',
  u: 'up',
};

/** On Apple's keyboards, the key of commands is another one. */
function nameAppleKeys(): void {
  if (!/^(Mac|iP)/.test(navigator.platform)) return;
  byId('history-keys', HTMLElement).innerHTML =
    '<kbd>⌘</kbd> <kbd>Z</kbd>, <kbd>⇧</kbd> <kbd>⌘</kbd> <kbd>Z</kbd>';
  byId('undo', HTMLButtonElement).title = 'Undo (⌘ Z)';
  byId('redo', HTMLButtonElement).title = 'Redo (⇧ ⌘ Z)';
}

export function setUpKeyboard(viewer: GeodesicVoronoiElement): void {
  nameAppleKeys();
  const view = byId('view', HTMLElement);
  const help = byId('help', HTMLDialogElement);
  onClick('help-button', () => help.showModal());
  // A click on the backdrop has the dialog itself as its target, not its content.
  help.addEventListener('click', (event) => {
    if (event.target === help) help.close();
  });

  document.addEventListener('keydown', (event) => {
    // Escape closes the error when there is no work to cancel.
    if (event.key === 'Escape' && viewer.status === 'ready' && !help.open) hideError();
    if (event.defaultPrevented || help.open || isTyping(event)) return;
    // A key that types a character acts in the view only: dictation types such keys (WCAG 2.1.4).
    const isCharacter = event.key.length === 1 && !(event.ctrlKey || event.metaKey || event.altKey);
    if (isCharacter && !view.contains(document.activeElement)) return;
    const button = ofButtons[event.key.toLowerCase()];
    if (isCharacter && button) {
      press(byId(button, HTMLButtonElement));
      return;
    }
    const command = commandOf(event);
    if (command === undefined || !everywhere.has(command)) return;
    // The browser closes the menu that is open.
    if (command === 'cancel' && document.querySelector(':popover-open')) return;
    event.preventDefault();
    viewer.perform(command);
  });
}

/** Presses a button, and has screen readers say what they would say if it had the focus. */
function press(button: HTMLButtonElement): void {
  button.click();
  // Once it has followed the attributes that it has changed.
  queueMicrotask(() => {
    const state = { true: ', pressed', false: ', not pressed' }[button.ariaPressed ?? ''] ?? '';
    byId('told', HTMLElement).textContent = button.ariaLabel + state;
  });
}

/** Whether the key goes to a field that takes text or keys. */
function isTyping({ target }: Event): boolean {
  if (target instanceof HTMLInputElement)
    return !['checkbox', 'radio', 'button', 'range'].includes(target.type);
  // The list of sites is no field: Delete there removes the selected site.
  return target instanceof HTMLSelectElement && target.size <= 1;
}
