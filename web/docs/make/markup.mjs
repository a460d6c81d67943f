// SPDX-License-Identifier: MIT
//
// Texts in HTML and SVG.

const references = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };

/** A text as content or as the value of an attribute. */
export const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => references[c]);
