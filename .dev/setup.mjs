// SPDX-License-Identifier: MIT
//
// npm run setup: what building and testing need, where it is missing. The other scripts call it too.

import { statSync } from 'node:fs';
import { announce, at, exists, hasCommand, isScript, main, root, run, status } from './tasks.mjs';

const command = (...names) => () => names.some(hasCommand);
const header = (path) => () =>
  ['/usr/include', '/usr/local/include', '/opt/homebrew/include'].some((folder) => exists(`${folder}/${path}`));

/**
 * What has to be there for a page ('build') and for the tests ('test'), and the Debian packages
 * that bring it. Libraries are `fetched` by CMake where no package manager of ours can bring them.
 */
const requirements = [
  { name: 'Emscripten (emcc)', for: 'build', packages: ['emscripten'], found: command('emcc') },
  { name: 'CMake', for: 'build', packages: ['cmake'], found: command('cmake') },
  { name: 'Ninja', for: 'build', packages: ['ninja-build'], found: command('ninja') },
  { name: 'Eigen', for: 'build', packages: ['libeigen3-dev'], found: header('eigen3/Eigen/Core'), fetched: true },
  { name: 'tinygltf', for: 'build', packages: ['libtinygltf-dev'], found: header('tiny_gltf.h'), fetched: true },
  { name: 'JSON for Modern C++', for: 'build', packages: ['nlohmann-json3-dev'], found: header('nlohmann/json.hpp'), fetched: true },
  { name: 'a C++ compiler', for: 'test', packages: ['g++'], found: command('c++') },
  { name: 'GoogleTest', for: 'test', packages: ['libgtest-dev'], found: header('gtest/gtest.h'), fetched: true },
  { name: 'Google Benchmark', for: 'test', packages: ['libbenchmark-dev'], found: header('benchmark/benchmark.h'), fetched: true },
  { name: 'CGAL', for: 'test', packages: ['libcgal-dev'], found: header('CGAL/version.h'), fetched: true },
  { name: 'Chromium (or CHROME_PATH, the path of a browser of its kind)', for: 'test', packages: ['chromium'], found: () => chromium() !== undefined },
];

/** The browser that the tests drive. */
export function chromium() {
  if (process.env.CHROME_PATH) return process.env.CHROME_PATH;
  return [
    '/usr/bin/chromium',
    '/usr/bin/chromium-browser',
    '/usr/bin/google-chrome',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  ].find(exists);
}

/** Makes everything for `purpose` available: 'build', or 'test', which is more. */
export function setUp(purpose) {
  const missing = requirements.filter((r) => (purpose === 'test' || r.for === purpose) && !r.found());
  if (missing.length > 0) install(missing);
  installModules();
}

function install(missing) {
  const packages = missing.flatMap((requirement) => requirement.packages);
  const apt = aptCommand();
  if (!apt) {
    const needed = missing.filter((requirement) => !requirement.fetched);
    if (needed.length === 0) return;
    throw new Error(
      `Please install ${needed.map(({ name }) => name).join(', ')}.\n` +
        `On Debian or Ubuntu: apt-get install ${packages.join(' ')}`,
    );
  }
  announce(`Install ${packages.join(', ')}`);
  // A stale list of packages is often good enough: what matters is whether they can be installed.
  status(...apt('update', '-qq'));
  run(...apt('install', '-y', '--no-install-recommends', ...packages));
}

/** How to call apt-get here, if one may. */
function aptCommand() {
  if (!hasCommand('apt-get')) return undefined;
  const environment = 'DEBIAN_FRONTEND=noninteractive';
  if (process.getuid() === 0) return (...args) => ['env', [environment, 'apt-get', ...args]];
  const maySudo =
    hasCommand('sudo') && (process.stdin.isTTY || status('sudo', ['-n', 'true'], { stdio: 'ignore' }) === 0);
  return maySudo ? (...args) => ['sudo', [environment, 'apt-get', ...args]] : undefined;
}

/** By the lock file, unless what it asks for is there. */
function installModules() {
  const time = (path) => statSync(path, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  // npm's record of what it installed.
  if (time(at('node_modules', '.package-lock.json')) >= time(at('package-lock.json'))) return;
  announce('Install the npm packages');
  // Nothing here needs an install script; one of the sample meshes would unpack itself for a minute.
  run('npm', ['ci', '--ignore-scripts'], { cwd: root });
}

if (isScript(import.meta.url)) await main(() => setUp('test'));
