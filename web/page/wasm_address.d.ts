// SPDX-License-Identifier: MIT

/** The address at which a WebAssembly module is served: Vite's. */
declare module '*.wasm?url' {
  const address: string;
  export default address;
}
