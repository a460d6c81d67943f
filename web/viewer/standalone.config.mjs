// SPDX-License-Identifier: MIT
import { defineConfig } from 'rolldown';

/** Workers are to run the one file there is, which knows by a worker's name what it is to be. */
const workersInOneFile = {
  name: 'workers-in-one-file',
  transform(code) {
    return code.replace(
      /new Worker\(new URL\('[^']+', import\.meta\.url\)/,
      'new Worker(new URL(import.meta.url)',
    );
  },
};

export default defineConfig({
  input: 'dist/viewer/standalone.js',
  platform: 'browser',
  plugins: [workersInOneFile],
  output: {
    file: 'dist/standalone.js',
    format: 'esm',
    codeSplitting: false,
    minify: true,
    sourcemap: false,
  },
});
