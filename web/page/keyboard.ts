// SPDX-License-Identifier: MIT
//
// Keys that work anywhere in the page, and the dialogue that lists all keys.

import { type Command, commandOf, type GeodesicVoronoiElement } from '../viewer/element.js';
import { byId, onClick } from './dom.js';

/** Commands of keys anywhere in the page; with the view in focus, the viewer handles all keys. */
const everywhere: ReadonlySet<Command> = new Set(['undo', 'redo', 'remove', 'refit', 'cancel']);
/** Those of keys that elsewhere press the button or open the menu in focus. */
const withoutFocus: ReadonlySet<Command> = new Set(['play-cvt']);

/** Keys that press a button of the toolbar. */
const ofButtons: Readonly<Record<string, string>> = { u: 'up', h: 'hide-panel' };

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
  const help = byId('help', HTMLDialogElement);
  const showHelp = () => help.showModal();
  onClick('help-button', showHelp);
  // A click on the backdrop has the dialog itself as its target, not its content.
  help.addEventListener('click', (event) => {
    if (event.target === help) help.close();
  });

  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || help.open || isTyping(event)) return;
    if (event.key === '?') {
      showHelp();
      return;
    }
    const button = ofButtons[event.key.toLowerCase()];
    if (button && !event.ctrlKey && !event.metaKey && !event.altKey) {
      byId(button, HTMLButtonElement).click();
      return;
    }
    const command = commandOf(event);
    const hasFocus = document.activeElement !== null && document.activeElement !== document.body;
    if (command === undefined) return;
    if (!everywhere.has(command) && (hasFocus || !withoutFocus.has(command))) return;
    // The browser closes the menu that is open.
    if (command === 'cancel' && document.querySelector(':popover-open')) return;
    event.preventDefault();
    viewer.perform(command);
  });
}

/** Whether the key goes to a field that takes text or keys. */
function isTyping({ target }: Event): boolean {
  if (target instanceof HTMLInputElement)
    return !['checkbox', 'radio', 'button'].includes(target.type);
  // The list of sites is no field: Delete there removes the selected site.
  return target instanceof HTMLSelectElement && target.size <= 1;
}
