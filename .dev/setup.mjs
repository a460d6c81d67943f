// SPDX-License-Identifier: MIT
//
// npm run setup: what building and testing need, where it is missing. The other scripts call it too.

import { existsSync, readFileSync } from 'node:fs';
import { announce, at, hasCommand, isScript, main, run, status } from './tasks.mjs';

/** Commands, with the Debian packages that bring them: for a page, and for the tests besides. */
const commands = {
  build: { emcc: 'emscripten', cmake: 'cmake', ninja: 'ninja-build' },
  test: {
    'c++': 'g++',
    'clang++': 'clang',
    'clang-format': 'clang-format',
    'clang-tidy': 'clang-tidy',
  },
};

/** Libraries by one of their headers. What is not there, CMake fetches; without CGAL, it does less. */
const libraries = {
  build: {
    'eigen3/Eigen/Core': 'libeigen3-dev',
    'tiny_gltf.h': 'libtinygltf-dev',
    'nlohmann/json.hpp': 'nlohmann-json3-dev',
  },
  test: {
    'gtest/gtest.h': 'libgtest-dev',
    'CGAL/Surface_mesh_shortest_path.h': 'libcgal-dev',
    'fuzzer/FuzzedDataProvider.h': 'libclang-rt-14-dev',
  },
};

/** The browser that the tests drive; without windows of its own, Chromium opens pages faster. */
export function chromium() {
  if (process.env.CHROME_PATH) return process.env.CHROME_PATH;
  return [
    '/usr/bin/chromium-headless-shell',
    '/usr/bin/chromium',
    '/usr/bin/chromium-browser',
    '/usr/bin/google-chrome',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  ].find(existsSync);
}

/** Makes everything for `purpose` available: 'build', or 'test', which is more. */
export function setUp(purpose) {
  const wanted = ({ build, test }) =>
    Object.entries(purpose === 'test' ? { ...build, ...test } : build);
  const missing = wanted(commands).filter(([name]) => !hasCommand(name));
  if (purpose === 'test' && !chromium())
    missing.push(['Chromium (or CHROME_PATH)', 'chromium-headless-shell']);
  const fetched = wanted(libraries).filter(([header]) => !hasHeader(header));
  if (missing.length + fetched.length > 0) install(missing, fetched);
  installModules();
}

function hasHeader(header) {
  const folders = ['/usr/include', '/usr/local/include', '/opt/homebrew/include'];
  folders.push('/usr/lib/clang/14/include'); // of Debian's compiler
  return folders.some((folder) => existsSync(`${folder}/${header}`));
}

function install(missing, fetched) {
  const apt = aptCommand();
  const packages = (requirements) => requirements.map(([, name]) => name);
  if (apt) {
    announce(`Install ${packages([...missing, ...fetched]).join(', ')}`);
    // An old list of packages may do as well: what counts is whether they can be installed.
    status(...apt('update', '-qq'));
    const command = ['install', '-y', '--no-install-recommends'];
    if (missing.length > 0) run(...apt(...command, ...packages(missing)));
    if (fetched.length > 0) status(...apt(...command, ...packages(fetched)));
  } else if (missing.length > 0) {
    throw new Error(
      `Please install ${missing.map(([name]) => name).join(', ')}. On Debian or Ubuntu:\n` +
        `apt-get install ${packages([...missing, ...fetched]).join(' ')}`,
    );
  }
}

/** How to call apt-get here, if one may. */
function aptCommand() {
  if (!hasCommand('apt-get')) return undefined;
  const environment = 'DEBIAN_FRONTEND=noninteractive';
  if (process.getuid() === 0) return (...args) => ['env', [environment, 'apt-get', ...args]];
  const maySudo =
    hasCommand('sudo') &&
    (process.stdin.isTTY || status('sudo', ['-n', 'true'], { stdio: 'ignore' }) === 0);
  return maySudo ? (...args) => ['sudo', [environment, 'apt-get', ...args]] : undefined;
}

/** By the lock file, unless all that it asks for is there. */
function installModules() {
  if (areModulesInstalled()) return;
  announce('Install the npm packages');
  // Nothing here needs an install script; one of the sample meshes would unpack itself for a minute.
  run('npm', ['ci', '--ignore-scripts']);
}

/**
 * Whether npm's record of what it installed has every package of the lock file. Not by their times: a new
 * clone, or another branch, would replace what is there, also where a link leads to that of another clone.
 */
function areModulesInstalled() {
  const record = at('node_modules', '.package-lock.json');
  if (!existsSync(record)) return false;
  const packagesIn = (path) => JSON.parse(readFileSync(path, 'utf8')).packages;
  const installed = packagesIn(record);
  const { '': own, ...wanted } = packagesIn(at('package-lock.json'));
  // Optional ones are those of other systems.
  return Object.entries(wanted).every(
    ([path, { version, optional }]) => optional || installed[path]?.version === version,
  );
}

if (isScript(import.meta.url)) await main(() => setUp('test'));
