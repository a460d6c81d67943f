// SPDX-License-Identifier: MIT

const style = `
  :host {
    display: block;
    position: relative;
    width: 300px;
    height: 200px;
    overflow: hidden;
    contain: strict;
    touch-action: none;
  }
  :host([hidden]) { display: none; }
  canvas { display: block; width: 100%; height: 100%; outline: none; touch-action: none; }
  canvas:focus-visible { box-shadow: inset 0 0 0 3px Highlight; }
  .aim {
    position: absolute; inset: 50% auto auto 50%; width: 28px; height: 28px;
    margin: -14px; pointer-events: none; opacity: 0;
    background:
      linear-gradient(#1f2933 0 0) 50% 50% / 2px 100% no-repeat,
      linear-gradient(#1f2933 0 0) 50% 50% / 100% 2px no-repeat;
    mask: radial-gradient(circle, transparent 5px, #000 5.5px);
    filter: drop-shadow(0 0 1px #fff) drop-shadow(0 0 1px #fff);
  }
  canvas:focus-visible + .aim { opacity: 1; }
  .message {
    position: absolute; inset: auto 0 50%; margin: auto; max-width: 28em; padding: 1em 1.25em;
    text-align: center;
  }
  .poster { position: absolute; inset: 0; pointer-events: none; }
  :host([status='ready']) .poster, :host([status='computing']) .poster,
  :host([status='iterating']) .poster { display: none; }
  .instructions { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
`;

const instructions =
  'Arrow keys turn the model, plus and minus zoom. Enter adds a site at the centre of the view; ' +
  'N and P choose a site, Delete removes it. Control Z undoes. ' +
  'Space plays and pauses the centroidal tessellation.';

/**
 * Fills the element's shadow with its canvas and what lies on it. Made by DOM calls and a constructed
 * style sheet, which a strict content security policy allows.
 */
export function fillShadow(host: HTMLElement): { canvas: HTMLCanvasElement; message: HTMLElement } {
  const shadow = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style);
  shadow.adoptedStyleSheets = [sheet];

  const canvas = make('canvas', { tabIndex: 0 });
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-describedby', 'instructions');
  canvas.setAttribute('part', 'canvas');
  const aim = make('div', { className: 'aim' });
  const message = make('p', { className: 'message', hidden: true });
  message.setAttribute('role', 'alert');
  message.setAttribute('part', 'message');
  const poster = make('div', { className: 'poster' });
  poster.append(make('slot', { name: 'poster' }));
  shadow.replaceChildren(
    canvas,
    aim,
    poster,
    message,
    make('p', { className: 'instructions', id: 'instructions', textContent: instructions }),
  );
  return { canvas, message };
}

function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  properties: Partial<HTMLElementTagNameMap[Tag]>,
): HTMLElementTagNameMap[Tag] {
  return Object.assign(document.createElement(tag), properties);
}
