const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param {Element} element
 * @param {Record<string, any>} props functions named `on...` become listeners, booleans become present or absent
 */
export function assign(element, props) {
  for (const [name, value] of Object.entries(props)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value === false || value === null || value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
}

/**
 * An HTML element.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, any>} [props] attributes and `on...` listeners
 * @param {...(Node | string | number | null)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function h(tag, props = {}, ...children) {
  const element = document.createElement(tag);
  assign(element, props);
  for (const child of children) if (child !== null) element.append(typeof child === 'number' ? String(child) : child);
  return element;
}

/**
 * An SVG element.
 *
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, any>} [props]
 * @param {...(Node | string)} children
 * @returns {SVGElementTagNameMap[K]}
 */
export function s(tag, props = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  assign(element, props);
  element.append(...children);
  return element;
}

/**
 * A push button.
 *
 * @param {string} label what it does; also the accessible name when `glyph` is given
 * @param {() => void} press
 * @param {{ glyph?: string, action?: string, class?: string, title?: string }} [options] `action` names a row of the keys table
 */
export function button(label, press, options = {}) {
  return h(
    'button',
    {
      type: 'button',
      class: options.class,
      'data-action': options.action,
      'aria-label': options.glyph ? label : undefined,
      title: options.title ?? (options.glyph ? label : undefined),
      onclick: press,
    },
    options.glyph ?? label,
  );
}

/**
 * Writes only what changed, so that nothing is laid out again in vain.
 *
 * @param {Element} element
 * @param {string | number} text
 */
export function write(element, text) {
  const string = String(text);
  if (element.textContent !== string) element.textContent = string;
}

/** Pixels on the page for one of an element's own: an embedded page is enlarged. @param {Element} element */
export const zoomOf = (element) => element.currentCSSZoom || 1;

/** @param {string} selector */
export function find(selector) {
  const element = document.querySelector(selector);
  if (!(element instanceof HTMLElement)) throw new Error(`the page has no ${selector}`);
  return element;
}
