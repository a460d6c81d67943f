// SPDX-License-Identifier: MIT
//
// Choosing a model: a sample, files, a folder, or any of them dropped on the page.

import type { ModelFiles } from 'geodesic-voronoi';
import type { GeodesicVoronoiElement } from '../../viewer/element.js';
import { chosenFiles, droppedFiles, lastSegment } from '../../viewer/session/model_files.js';
import { make } from '../../viewer/stage/make.js';
import { byId, listen, onClick } from '../base/dom.js';
import { showError, showNote } from '../base/messages.js';
import { fetched } from '../base/scripts.js';
import { modelOf, sampleAddress } from '../samples/first_model.js';
import type { Edits } from '../state/edits.js';
import { ofOneModel } from '../state/page_state.js';
import samples from '../samples/samples.json' with { type: 'json' };

/**
 * How a model gets into the page: the menu of models, the pickers of files and folders, and
 * dropping them on it.
 */
export function setUpModelChoice(viewer: GeodesicVoronoiElement, edits: Edits): void {
  // Without WebGL nothing can be opened; the view says so.
  if (viewer.status === 'failed') {
    byId('samples', HTMLSelectElement).options[0].text = 'None';
    return;
  }
  const menu = new ModelMenu(viewer, edits);
  /** Dropped ones come with what is in their folders. */
  const open = async (files: readonly File[], dropped?: Promise<ModelFiles>) => {
    try {
      const { isSitesFile, openSites } = await fetched(import('./sites_file.js'));
      const areSites = await Promise.all(files.map(isSitesFile));
      const sites = files.filter((_, i) => areSites[i]);
      if (files.length > sites.length) {
        const all = dropped ? await dropped : chosenFiles(files);
        if (!(await menu.openFiles(without(sites, all)))) return;
      }
      for (const file of sites) await openSites(viewer, file);
    } catch (error) {
      showError((error as Error).message);
    }
  };
  setUpPicker((files) => void open(files));
  setUpDrop((dropped) => {
    void open([...dropped.files], droppedFiles(dropped));
  });
}

/** A model that can be chosen. */
interface Choice {
  option: HTMLOptionElement;
  open(): Promise<boolean>;
  credit: string;
}

/** The samples, and the models among the files that a person has opened. */
class ModelMenu {
  readonly #viewer: GeodesicVoronoiElement;
  readonly #edits: Edits;
  readonly #menu = byId('samples', HTMLSelectElement);
  readonly #ownFiles = make('optgroup', { label: 'Your files' });
  readonly #choices = new WeakMap<HTMLOptionElement, Choice>();
  #shown: Choice;
  /** The model that was chosen last: being opened, or shown already. */
  #asked: Choice;
  /** The settings of the model that is shown, taken away while another is opened. */
  #settings: [string, string][] = [];

  constructor(viewer: GeodesicVoronoiElement, edits: Edits) {
    this.#viewer = viewer;
    this.#edits = edits;
    const choices = samples.map(({ title, file, credit }) => ({
      option: new Option(title, file),
      open: () => viewer.load(sampleAddress(file)),
      credit,
    }));
    this.#menu.replaceChildren();
    for (const choice of choices) this.#add(choice, this.#menu);
    const first = lastSegment(modelOf(location.hash)); // which is on its way
    this.#shown = this.#asked = choices.find(({ option }) => option.value === first) ?? choices[0];
    this.#shown.option.selected = true;
    this.#menu.disabled = false;

    this.#menu.addEventListener('change', () => {
      void this.#open(this.#choices.get(this.#menu.selectedOptions[0])!);
    });
    listen(viewer, 'load', () => {
      this.#settings = [];
      this.#show(this.#asked);
    });
  }

  /**
   * Opens the first of the models among files; all are in the menu then. Resolves to whether it is
   * there.
   */
  async openFiles(files: ModelFiles): Promise<boolean> {
    const { ownModels } = await fetched(import('./own_models.js'));
    const paths = await ownModels(files);
    const choices = paths.map((path) => ({
      option: new Option(
        paths.length > 1 ? path : lastSegment(path),
        `${path} ${sizeOf(files[path])}`,
      ),
      open: () => this.#viewer.loadFiles(files, path),
      credit: '',
    }));
    if (choices.length === 0) return this.#viewer.loadFiles(files);
    if (choices.length > 1) for (const choice of choices) this.#addOwn(choice);
    const isOpen = await this.#open(choices[0]);
    if (isOpen && choices.length > 1) {
      showNote(`This is one of ${choices.length} models: choose another in the menu “Model”.`);
    }
    return isOpen;
  }

  /** A model that cannot be opened leaves the one before, which is then what the menu says. */
  async #open(choice: Choice): Promise<boolean> {
    if (!this.#edits.mayBeLeft()) {
      this.#asked.option.selected = true;
      return false;
    }
    const asked = { ...choice }; // the same model may be asked for once more meanwhile
    this.#asked = asked;
    if (choice.option === this.#shown.option) this.#returnSettings();
    else this.#takeSettings();
    // The element applies attributes at the end of the task. It may begin to build this model anew, which
    // opening the next one then ends; in the other order, it would end that.
    await Promise.resolve();
    const isOpen = await choice.open();
    if (isOpen) this.#edits.forget();
    else if (this.#asked === asked) {
      this.#show(this.#shown);
      this.#returnSettings();
    }
    return isOpen;
  }

  #takeSettings(): void {
    for (const name of ofOneModel) {
      const value = this.#viewer.getAttribute(name);
      if (value !== null) this.#settings.push([name, value]);
      this.#viewer.removeAttribute(name);
    }
  }

  #returnSettings(): void {
    for (const [name, value] of this.#settings.splice(0)) this.#viewer.setAttribute(name, value);
  }

  #show(choice: Choice): void {
    this.#shown = this.#asked = choice;
    if (!choice.option.isConnected) this.#addOwn(choice);
    choice.option.selected = true;
    byId('credit', HTMLElement).textContent = choice.credit;
  }

  /** Adds a model; replaces the same file. Another one of the same name gets a number. */
  #addOwn(choice: Choice): void {
    const { option } = choice;
    const own = [...this.#ownFiles.children] as HTMLOptionElement[];
    own.find(({ value }) => value === option.value)?.remove();
    const isTaken = (text: string) => own.some((each) => each.isConnected && each.text === text);
    const { text } = option;
    for (let number = 2; isTaken(option.text); ++number) option.text = `${text} (${number})`;
    this.#add(choice, this.#ownFiles);
    this.#menu.prepend(this.#ownFiles);
  }

  #add(choice: Choice, list: HTMLElement): void {
    this.#choices.set(choice.option, choice);
    list.append(choice.option);
  }
}

/** In bytes; it tells files of the same path apart. Unknown within a zip, and zero there. */
function sizeOf(file: ModelFiles[string] | undefined): number {
  return file instanceof File ? file.size : 0;
}

function without(some: readonly File[], files: ModelFiles): ModelFiles {
  const gone = new Set(some.map(({ name }) => name));
  return Object.fromEntries(Object.entries(files).filter(([path]) => !gone.has(path)));
}

function setUpPicker(open: (files: readonly File[]) => void): void {
  for (const [button, files] of [
    ['open', 'files'],
    ['open-folder', 'folder'],
  ]) {
    const input = byId(files, HTMLInputElement);
    onClick(button, () => input.click()).disabled = false;
    input.addEventListener('change', () => {
      if (input.files?.length) open([...input.files]);
      // Emptied, so that choosing the same file again is a change.
      input.value = '';
    });
  }
}

function setUpDrop(open: (dropped: DataTransfer) => void): void {
  const overlay = byId('drop', HTMLElement);
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    overlay.hidden = false;
  });
  addEventListener('dragleave', (event) => {
    // Without a related target, the drag has left the page, not just an element.
    if (event.relatedTarget === null) overlay.hidden = true;
  });
  addEventListener('drop', (event) => {
    overlay.hidden = true;
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) open(event.dataTransfer);
  });
}
