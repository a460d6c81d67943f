// SPDX-License-Identifier: MIT

/** What the viewer does at a key. */
export type Command =
  | 'undo'
  | 'redo'
  | 'remove'
  | 'refit'
  | 'cancel'
  | 'place'
  | 'play-cvt'
  | 'next-site'
  | 'previous-site'
  | 'turn-left'
  | 'turn-right'
  | 'turn-up'
  | 'turn-down'
  | 'nearer'
  | 'farther';

const ofKey: Readonly<Record<string, Command>> = {
  Delete: 'remove',
  Backspace: 'remove',
  f: 'refit',
  Escape: 'cancel',
  Enter: 'place',
  ' ': 'play-cvt',
  n: 'next-site',
  p: 'previous-site',
  ArrowLeft: 'turn-left',
  ArrowRight: 'turn-right',
  ArrowUp: 'turn-up',
  ArrowDown: 'turn-down',
  '+': 'nearer',
  '=': 'nearer',
  '-': 'farther',
};

export function commandOf(event: KeyboardEvent): Command | undefined {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.altKey) return undefined;
  if (event.ctrlKey || event.metaKey) {
    if (key === 'z') return event.shiftKey ? 'redo' : 'undo';
    return key === 'y' ? 'redo' : undefined;
  }
  return ofKey[key];
}
