// SPDX-License-Identifier: MIT
//
// Finds the models among files.
import { toTask, toTaskOptions } from '../base/checks.js';
import { toFileName, toFiles } from './arguments.js';
import { type FoundModel, modelIn, modelsIn } from '../input/read_model.js';
import type { MeshOptions, ModelFile, ModelFiles, TaskOptions } from '../api/options.js';

export type { FoundModel };

export interface FindModelOptions extends TaskOptions, Pick<MeshOptions, 'file'> {}

/** Finds the model among files as `mesh` does, without checking its content. */
export async function findModel(
  files: ModelFile | ModelFiles,
  options?: FindModelOptions,
): Promise<FoundModel> {
  const { file, ...task } = toTaskOptions(options, { file: undefined });
  return modelIn(toFiles(files), toFileName(file), task);
}

/**
 * The paths of all models among files, recognised by their names; for a single .zip, of those in
 * it. Each can be the option `file` of `mesh`, which has to choose one where there are several.
 */
export async function listModels(
  files: ModelFile | ModelFiles,
  options?: TaskOptions,
): Promise<string[]> {
  return modelsIn(toFiles(files), toTask(options));
}
