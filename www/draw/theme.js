const NAMES = /** @type {const} */ (['ground', 'ink', 'secondary', 'hairline', 'accent', 'robot', 'load', 'food', 'debris', 'running', 'selection']);

/** @typedef {Record<typeof NAMES[number], string> & { font: string }} Theme */

/**
 * The colours in force, from the custom properties that CSS and SVG use too.
 *
 * @param {Element} element
 * @returns {Theme}
 */
export function readTheme(element) {
  const style = getComputedStyle(element);
  const colours = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  return /** @type {Theme} */ ({ ...colours, font: style.fontFamily });
}
