// SPDX-License-Identifier: MIT
//
// What the scripts beside this file are made of: commands, and steps that are skipped when nothing
// they read has changed. Only what Node itself brings: nothing is installed yet when these run.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));

/** The path of something in the repository. */
export const at = (...path) => join(root, ...path);

/** Where what goes on is told: a file descriptor. */
let progress = 1;

/** Tells what goes on on standard error from now on: standard output is for the script's result. */
export function keepStandardOutput() {
  progress = 2;
}

/** Runs a command in the repository and returns its exit status. */
export function status(command, args, options = {}) {
  const stdio = ['inherit', progress, 'inherit'];
  const result = spawnSync(command, args, { cwd: root, stdio, ...options });
  if (result.error) throw result.error;
  return result.status ?? 1;
}

/** Runs a command that has to succeed. */
export function run(command, args, options) {
  const code = status(command, args, options);
  if (code !== 0) throw new Error(`${[command, ...args].join(' ')} ended with status ${code}`);
}

/** Runs a command, showing what it writes; resolves with that text and the exit status. */
export function runShowing(command, args, options = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      cwd: root,
      stdio: ['ignore', 'pipe', 'inherit'],
      ...options,
    });
    let text = '';
    child.stdout.setEncoding('utf8').on('data', (chunk) => {
      process.stdout.write(chunk);
      text += chunk;
    });
    child.on('error', reject).on('close', (code) => resolve({ code: code ?? 1, text }));
  });
}

/** Whether a command is on the PATH. */
export function hasCommand(name) {
  return spawnSync('sh', ['-c', `command -v "${name}"`], { stdio: 'ignore' }).status === 0;
}

/** Says what comes next. */
export function announce(text) {
  (progress === 1 ? console.log : console.error)(`\n— ${text}`);
}

/**
 * Does `work` unless it was done after everything in `inputs` (files and folders, of the
 * repository) last changed and all `outputs` are still there.
 */
export async function step(name, { inputs, outputs }, work) {
  const stamp = at('build', 'stamps', name);
  const changed = Math.max(...inputs.map((input) => modified(at(input))));
  if (outputs.every((output) => existsSync(at(output))) && modified(stamp) > changed) return;
  announce(name);
  const started = new Date();
  await work();
  mkdirSync(dirname(stamp), { recursive: true });
  // Dated from the start: what changed meanwhile may have been read before or after.
  writeFileSync(stamp, '');
  utimesSync(stamp, started, started);
}

/** When a file, or anything in a folder, last changed; 0 if it does not exist. */
function modified(path) {
  const entry = statSync(path, { throwIfNoEntry: false });
  if (!entry) return 0;
  if (!entry.isDirectory()) return entry.mtimeMs;
  // A folder's own time changes when something in it appears or goes.
  const inside = readdirSync(path)
    .filter((name) => name !== 'node_modules')
    .map((name) => modified(join(path, name)));
  return Math.max(entry.mtimeMs, ...inside);
}

/** Whether a module is the script that was started. */
export function isScript(url) {
  return process.argv[1] === fileURLToPath(url);
}

/** Runs a script's main function; a failure is one line and status 1, or what the error says. */
export async function main(script) {
  try {
    await script();
  } catch (error) {
    if (error.message) console.error(error.message);
    process.exitCode = error.exitCode ?? 1;
  }
}
