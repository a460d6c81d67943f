// SPDX-License-Identifier: MIT
//
// Making elements of a page.

/** An element with these properties and this content. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  properties: Partial<HTMLElementTagNameMap[Tag]>,
  ...content: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...content);
  return element;
}

/** Of elements with sentences of the viewer, which are in English in every page. */
export const english = { lang: 'en', dir: 'ltr' } as const;
