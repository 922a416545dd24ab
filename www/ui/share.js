/** Saves a blob under a name. @param {string} name @param {Blob} blob */
export function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Puts a text on the clipboard; false when the browser does not let us. @param {string} string */
export async function copy(string) {
  try {
    await navigator.clipboard.writeText(string);
    return true;
  } catch {
    return false;
  }
}

const STYLES = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'font-family', 'font-size', 'font-weight', 'text-anchor', 'paint-order', 'dominant-baseline', 'visibility', 'display'];

/**
 * A drawing of the page as a file of its own: computed styles become attributes, hidden parts go.
 *
 * @param {SVGSVGElement} drawing
 * @param {{ title: string, width: number, height: number, ground: string }} what
 */
export function standalone(drawing, { title, width, height, ground }) {
  const copied = /** @type {SVGSVGElement} */ (drawing.cloneNode(true));
  const originals = drawing.querySelectorAll('*');
  copied.querySelectorAll('*').forEach((element, index) => {
    const style = getComputedStyle(originals[index]);
    for (const name of STYLES) element.setAttribute(name, style.getPropertyValue(name));
    for (const name of ['class', 'tabindex', 'role']) element.removeAttribute(name);
  });
  for (const [name, value] of Object.entries({ xmlns: 'http://www.w3.org/2000/svg', width, height, viewBox: `0 0 ${width} ${height}` })) copied.setAttribute(name, String(value));
  copied.removeAttribute('class');
  const back = document.createElementNS(copied.namespaceURI, 'rect');
  for (const [name, value] of Object.entries({ width, height, fill: ground })) back.setAttribute(name, String(value));
  const heading = document.createElementNS(copied.namespaceURI, 'title');
  heading.textContent = title;
  copied.prepend(heading, back);
  return new XMLSerializer().serializeToString(copied);
}
