// SPDX-License-Identifier: MIT
//
// Keys and the commands of the viewer that they give.

import type { Attributes } from '../attributes/attribute_values.js';
import type { SiteSelection } from './site_selection.js';
import type { SurfaceTools, Workpiece } from './surface_tools.js';

/** A command of the viewer, given by a key. */
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
  | 'farther'
  | 'move-left'
  | 'move-right'
  | 'move-up'
  | 'move-down';

/** The object that carries commands out. */
interface Commanded extends Workpiece {
  readonly selection: SiteSelection;
  readonly tools: SurfaceTools;
  removeSite(index: number): void;
  refit(): void;
  cancel(): void;
}

/** Steps of the keys, in radians and as a factor. */
const turnStep = Math.PI / 24;
const dollyStep = 1.15;
/** In CSS pixels. */
const moveStep = 8;

const actions: Readonly<Record<Command, (viewer: Commanded) => void>> = {
  undo: ({ session }) => session.undo(),
  redo: ({ session }) => session.redo(),
  remove: (viewer) => {
    const { selection, tools } = viewer;
    if (selection.index >= 0 && tools.mayEdit()) viewer.removeSite(selection.index);
  },
  refit: (viewer) => viewer.refit(),
  cancel: (viewer) => viewer.cancel(),
  place: ({ tools }) => tools.useAtCentre(),
  'play-cvt': (viewer) =>
    viewer.session.cvtStatus === 'running' ? viewer.session.pauseCvt() : viewer.playCvt(),
  'next-site': ({ selection }) => selection.step(1),
  'previous-site': ({ selection }) => selection.step(-1),
  'turn-left': ({ stage }) => stage.camera.turn(-turnStep, 0),
  'turn-right': ({ stage }) => stage.camera.turn(turnStep, 0),
  'turn-up': ({ stage }) => stage.camera.turn(0, turnStep),
  'turn-down': ({ stage }) => stage.camera.turn(0, -turnStep),
  nearer: (viewer) => dolly(viewer, 1 / dollyStep),
  farther: (viewer) => dolly(viewer, dollyStep),
  'move-left': ({ selection }) => selection.nudge(-moveStep, 0),
  'move-right': ({ selection }) => selection.nudge(moveStep, 0),
  'move-up': ({ selection }) => selection.nudge(0, -moveStep),
  'move-down': ({ selection }) => selection.nudge(0, moveStep),
};

function dolly({ stage, tools }: Commanded, factor: number): void {
  tools.approachAt(stage.camera.middle);
  stage.camera.dolly(factor);
}

/** What the keys do, for those who do not see the view; empty if they do nothing. */
export function instructionsOf({ interactive, isPainting }: Attributes): string {
  const ofCamera = 'Arrow keys turn the model, plus and minus zoom, F makes it fill the view.';
  const ofEdit =
    `Enter ${isPainting ? 'paints density' : 'adds a site'} at the centre of the view. ` +
    'N and P select a site, Shift with arrow keys moves it, Delete removes it. ' +
    'Control Z undoes, Control Y redoes. Space evens out the regions, or pauses. ' +
    'Escape gives up what is under way.';
  if (interactive === 'none') return '';
  return interactive === 'camera' ? ofCamera : `${ofCamera} ${ofEdit}`;
}

/** Commands that change nothing but the view. */
const ofView: ReadonlySet<Command> = new Set<Command>([
  'refit',
  'turn-left',
  'turn-right',
  'turn-up',
  'turn-down',
  'nearer',
  'farther',
]);

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

const ofShiftedKey: Readonly<Record<string, Command>> = {
  ArrowLeft: 'move-left',
  ArrowRight: 'move-right',
  ArrowUp: 'move-up',
  ArrowDown: 'move-down',
};

export function commandOf(event: KeyboardEvent): Command | undefined {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.altKey) return undefined;
  if (event.ctrlKey || event.metaKey) {
    if (key === 'z') return event.shiftKey ? 'redo' : 'undo';
    return key === 'y' ? 'redo' : undefined;
  }
  const known = event.shiftKey && key.startsWith('Arrow') ? ofShiftedKey : ofKey;
  return Object.hasOwn(known, key) ? known[key] : undefined;
}

export function isOfView(command: Command): boolean {
  return ofView.has(command);
}

export function perform(command: Command, viewer: Commanded): void {
  if (!Object.hasOwn(actions, command)) throw new TypeError(`There is no command “${command}”.`);
  actions[command](viewer);
}
