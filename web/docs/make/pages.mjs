// SPDX-License-Identifier: MIT
//
// The documents as static pages: Markdown in a small frame. A link that leads nowhere is an error.

import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Marked } from 'marked';
import { escaped } from './markup.mjs';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const folder = here('..');

/** In the order of the navigation. */
export const documents = [
  { source: here('../../../README.md'), target: 'index.html', title: 'Overview' },
  { source: here('../guide.md'), target: 'guide.html', title: 'Guide' },
  { source: here('../files.md'), target: 'files.html', title: 'Files' },
  { source: here('../element.md'), target: 'element.html', title: 'The element' },
  { source: here('../how-it-works.md'), target: 'how-it-works.html', title: 'How it works' },
  { source: here('../gallery.md'), target: 'gallery.html', title: 'Gallery' },
  { source: here('../performance.md'), target: 'performance.html', title: 'Accuracy and speed' },
  { source: here('../glossary.md'), target: 'glossary.html', title: 'Glossary' },
  {
    source: here('../../../.github/CONTRIBUTING.md'),
    target: 'contributing.html',
    title: 'Contributing',
  },
  { source: here('../changelog.md'), target: 'changelog.html', title: 'Changes' },
];
/** Made by other tools, into the same folder. */
const references = [
  { target: 'api/typescript/index.html', title: 'TypeScript' },
  { target: 'api/cpp/index.html', title: 'C++' },
];
const assets = ['style.css', 'figures', 'plots', 'pictures', 'examples', 'bench.json'];

/** Writes all pages into a folder. `hasReference` says which of the API references will be there. */
export function writePages(output, hasReference = () => true) {
  mkdirSync(output, { recursive: true });
  for (const name of assets) cpSync(join(folder, name), join(output, name), { recursive: true });
  cpSync(join(folder, '../page/icon.svg'), join(output, 'icon.svg'));
  const shown = references.filter(({ target }) => hasReference(target));
  for (const document of documents) {
    const navigation = [...documents, ...shown];
    writeFileSync(join(output, document.target), pageOf(document, navigation));
  }
}

/** As GitHub names headings: so links work in both. */
export function anchorOf(heading) {
  const words = heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '');
  return words.trim().replace(/\s/g, '-');
}

/** The headings and links of a Markdown text. */
export function outlineOf(text) {
  const anchors = [];
  const links = [];
  const marked = new Marked();
  marked.walkTokens(marked.lexer(text), (token) => {
    if (token.type === 'heading') anchors.push(anchorOf(plainText(token)));
    if (token.type === 'link' || token.type === 'image') links.push(token.href);
    if (token.type === 'html')
      links.push(...[...token.text.matchAll(/(?:src|href)="([^"]+)"/g)].map(([, href]) => href));
  });
  return { anchors, links };
}

const plainText = ({ tokens, text }) =>
  tokens ? tokens.map(plainText).join('') : text.replace(/<[^>]*>/g, '');

function pageOf({ source, target, title }, navigation) {
  const sections = [];
  const marked = new Marked({
    renderer: {
      heading({ tokens, depth }) {
        const id = anchorOf(tokens.map(plainText).join(''));
        if (depth === 2)
          sections.push(`<a href="#${id}">${escaped(tokens.map(plainText).join(''))}</a>`);
        return `<h${depth} id="${id}"><a class="anchor" href="#${id}">${this.parser.parseInline(tokens)}</a></h${depth}>\n`;
      },
      table(token) {
        // Wide ones scroll by themselves.
        const row = (cells, tag) =>
          `<tr>${cells.map((cell) => `<${tag}${cell.align ? ` class="${cell.align}"` : ''}>${this.parser.parseInline(cell.tokens)}</${tag}>`).join('')}</tr>`;
        const body = token.rows.map((cells) => row(cells, 'td')).join('\n');
        return `<div class="wide" ${scrollable('Table')}><table><thead>${row(token.header, 'th')}</thead><tbody>\n${body}</tbody></table></div>\n`;
      },
      paragraph(token) {
        const example = exampleOf(token, source);
        const text = `<p>${this.parser.parseInline(token.tokens)}</p>\n`;
        return example === undefined ? text : text + codeBlock(example);
      },
      code({ text }) {
        return codeBlock(text);
      },
      link({ href, tokens }) {
        // Examples are files to save: a page among them runs in a folder of its own, not here.
        const saved = href.startsWith('examples/') ? ' download' : '';
        return `<a href="${escaped(href)}"${saved}>${this.parser.parseInline(tokens)}</a>`;
      },
    },
    walkTokens(token) {
      if (token.type !== 'link' && token.type !== 'image') return;
      token.href = addressOf(token.href, source, dirname(target));
      const isReference = references.some((reference) => reference.target === token.href);
      if (!isReference || navigation.some((item) => item.target === token.href)) return;
      // A reference that was not made here is only named.
      token.type = 'text';
      token.tokens.push({ type: 'text', text: ' (not built here)' });
    },
  });
  const content = marked.parse(readFileSync(source, 'utf8'));
  return framed({ title, target, navigation, content: withSections(content, sections) });
}

/** Adds the links to a page's sections, below its title, if they are many. */
function withSections(content, sections) {
  const few = 5;
  if (sections.length <= few) return content;
  const links = `<nav class="sections" aria-label="On this page">${sections.join('\n')}</nav>`;
  return content.replace('</h1>', (end) => `${end}\n${links}`);
}

/** The code that a paragraph names, if that is all it says. */
function exampleOf({ tokens }, source) {
  if (tokens.length !== 1 || tokens[0].type !== 'link') return undefined;
  const href = tokens[0].href;
  return href.startsWith('examples/')
    ? readFileSync(join(dirname(source), href), 'utf8')
    : undefined;
}

/** Where a link of a document leads among the pages. */
function addressOf(href, source, from) {
  if (/^[a-z]+:/.test(href) || href.startsWith('#')) return href;
  const [path, anchor] = href.split('#');
  const suffix = anchor ? `#${anchor}` : '';
  const file = resolve(dirname(source), path);
  const document = documents.find((other) => other.source === file);
  if (document) return relative(from, document.target) + suffix;
  if (references.some(({ target }) => target === path)) return path;
  const asset = relative(folder, file);
  if (existsSync(file) && assets.includes(asset.split('/')[0])) return asset + suffix;
  throw new Error(`${relative(process.cwd(), source)} links to ${href}, which is no page`);
}

/** What is wider than its page is scrolled by keys once it has the focus. */
const scrollable = (label) => `tabindex="0" role="group" aria-label="${label}"`;

const codeBlock = (text) => `<pre ${scrollable('Code')}><code>${escaped(text)}</code></pre>\n`;

function framed({ title, target, navigation, content }) {
  const items = navigation.map((item) => {
    const current = item.target === target ? ' aria-current="page"' : '';
    return `<a href="${item.target}"${current}>${item.title}</a>`;
  });
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${title} · geodesic-voronoi</title>
    <link rel="icon" href="icon.svg" type="image/svg+xml" />
    <link rel="stylesheet" href="style.css" />
  </head>
  <body>
    <header>
      <a class="home" href="../index.html">Geodesic Voronoi</a>
      <nav aria-label="Documents">${items.join('\n')}</nav>
    </header>
    <main>
${content}
    </main>
  </body>
</html>
`;
}
