// SPDX-License-Identifier: MIT
//
// Which of several files is the model.
import { toTaskOptions } from './checks.js';
import { toFileName, toFiles } from './input.js';
import { type FoundModel, modelIn } from './input/read_model.js';
import type { MeshOptions, ModelFile, ModelFiles, TaskOptions } from './types.js';

export type { FoundModel };

export interface FindModelOptions extends TaskOptions, Pick<MeshOptions, 'file'> {}

/** The model among files, found as `mesh` finds it, with what it names; none of its content is checked. */
export async function findModel(
  files: ModelFile | ModelFiles,
  options?: FindModelOptions,
): Promise<FoundModel> {
  const { file, ...task } = toTaskOptions(options, { file: undefined });
  return modelIn(toFiles(files), toFileName(file), task);
}
