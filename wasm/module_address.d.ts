// SPDX-License-Identifier: MIT

/** The address of this WebAssembly module, as bundlers hand it over for a file that is imported. */
declare const address: string;
export default address;
