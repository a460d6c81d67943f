// SPDX-License-Identifier: MIT
import { toFiles } from './input.js';
import { type FoundModel, modelIn } from './input/read_model.js';
import type { ModelFile, ModelFiles } from './types.js';

export type { FoundModel };

/** The model among files, found as `mesh` finds it, with what it names; none of its content is checked. */
export async function findModel(files: ModelFile | ModelFiles): Promise<FoundModel> {
  return modelIn(toFiles(files));
}
