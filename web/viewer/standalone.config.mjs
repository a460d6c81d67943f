// SPDX-License-Identifier: MIT
import { defineConfig } from 'rolldown';

/**
 * Workers are to run the one file there is, which knows by a worker's name what it is to be. Browsers start workers
 * from the page's own origin only, so those of a file from elsewhere begin with a script that imports it.
 */
const workersInOneFile = {
  name: 'workers-in-one-file',
  transform(code) {
    return code.replace(
      /new Worker\(new URL\('[^']+', import\.meta\.url\)/,
      `new Worker(new URL(import.meta.url).origin === self.origin ? import.meta.url : URL.createObjectURL(
        new Blob(['import ' + JSON.stringify(import.meta.url)], { type: 'text/javascript' }))`,
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
