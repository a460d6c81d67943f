// SPDX-License-Identifier: MIT
//
// The help of the command, from the table of commands and options.

import {
  commands,
  isCommand,
  options,
  type CommandName,
  type CommandSpec,
  type OptionName,
  type OptionSpec,
} from './options.js';
import { UsageError } from './values.js';

/** The width of the text, in columns. */
const helpWidth = 100;

/** `help COMMAND` is `COMMAND --help`. */
export function help([command, ...more]: string[]): string {
  if (command === undefined) return overview();
  if (!isCommand(command) || more.length > 0)
    throw new UsageError(
      `help of '${[command, ...more].join(' ')}': there is one of ${Object.keys(commands).join(', ')}`,
    );
  return commandHelp(command);
}

export function overview(): string {
  return `Geodesic Voronoi diagrams on triangle meshes

Usage: geodesic-voronoi COMMAND MESH [OPTIONS]

${table(Object.entries(commands).map(([name, { summary }]) => [name, summary]))}

MESH is a glTF (.glb, or .gltf with its buffers in its folder; also with Draco or meshopt), an OBJ,
OFF, PLY or STL file, a .zip or a folder with one of them (of several: parts.zip#wheel.obj), or -
for standard input.
geodesic-voronoi COMMAND --help shows a command's options, geodesic-voronoi --version the version.

A file of sites or points is {"face": [i, …], "bary": [b0, b1, b2, …]} or {"vertex": [i, …]}; faces
count the mesh's triangles, vertices its positions, both in scene order. Or it is {"position": [x,
y, z, …]} or [[x, y, z], …], in the model's own coordinates: the points of the surface closest to
these places. The vertices of a .ply are such places, too, and so are the columns x, y and z of a
.csv or .xyz. A result of this command that has sites will do, too.

Exit status: 0 done, 1 bad input, 2 a wrong command line.
`;
}

export function commandHelp(command: CommandName): string {
  const { summary, result, examples, options: taken }: CommandSpec = commands[command];
  const names = Object.keys(options) as OptionName[];
  const rows = names
    .filter((name) => taken.includes(name))
    .map((name): [string, string] => {
      const { short, value, default: otherwise, help }: OptionSpec = options[name];
      return [
        `${short ? `-${short}, ` : '    '}--${name}${value ? ` ${value}` : ''}`,
        !otherwise ? help : `${help} (default: ${otherwise})`,
      ];
    });
  const choice = "By FILE's ending or --format, by default .json: ";
  const output = `Output: ${taken.includes('format') ? choice : ''}${result}`;
  return `${summary}

Usage: geodesic-voronoi ${command} MESH${command === 'info' ? '...' : ''} [OPTIONS]

${table(rows)}

${wrapped(output)}

Examples:
${examples.map((example) => `  geodesic-voronoi ${command} ${example}`).join('\n')}

Exit status: 0 done, 1 bad input, 2 a wrong command line.
`;
}

function table(rows: [string, string][]): string {
  const width = Math.max(...rows.map(([name]) => name.length));
  return rows
    .map(([name, text]) => `  ${name.padEnd(width)}  ${wrapped(text, width + 4)}`)
    .join('\n');
}

/** A text broken into lines, which all begin as far from the left margin as the first one does. */
function wrapped(text: string, indent = 0): string {
  const lines = [''];
  for (const word of text.split(' ')) {
    const line = lines.at(-1)!;
    if (line !== '' && indent + line.length + 1 + word.length > helpWidth) lines.push(word);
    else lines[lines.length - 1] = line === '' ? word : `${line} ${word}`;
  }
  return lines.join(`\n${' '.repeat(indent)}`);
}
