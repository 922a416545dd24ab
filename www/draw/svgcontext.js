/**
 * A canvas context that writes SVG: the part of the interface that `drawWorld` uses, so that picture and screen are
 * drawn by the same lines.
 *
 * @param {number} width
 * @param {number} height
 */
export function createSvgContext(width, height) {
  /** @type {string[]} */
  const marks = [];
  let path = '';
  /** @type {number[]} */
  let dashes = [];
  const round = (/** @type {number} */ value) => String(Math.round(value * 100) / 100);
  const point = (/** @type {number} */ x, /** @type {number} */ y) => `${round(x)} ${round(y)}`;

  const context = {
    fillStyle: '#000',
    strokeStyle: '#000',
    lineWidth: 1,
    globalAlpha: 1,
    font: '12px sans-serif',
    textAlign: 'start',
    clearRect() {},
    beginPath: () => void (path = ''),
    moveTo: (/** @type {number} */ x, /** @type {number} */ y) => void (path += `M${point(x, y)}`),
    lineTo: (/** @type {number} */ x, /** @type {number} */ y) => void (path += `L${point(x, y)}`),
    setLineDash: (/** @type {number[]} */ lengths) => void (dashes = lengths),

    /** @param {number} x @param {number} y @param {number} radius @param {number} from @param {number} to */
    arc(x, y, radius, from, to) {
      const middle = (from + to) / 2; // a full circle needs two arcs
      const at = (/** @type {number} */ angle) => point(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      const large = to - from > 2 * Math.PI ? 1 : 0;
      path += `M${at(from)}A${point(radius, radius)} 0 ${large} 1 ${at(middle)}A${point(radius, radius)} 0 ${large} 1 ${at(to)}`;
    },
    fill: () => void mark(`<path d="${path}" fill="${context.fillStyle}"`),
    stroke: () => void mark(`<path d="${path}" fill="none" ${stroke()}`),

    /** @param {number} x @param {number} y @param {number} w @param {number} h */
    fillRect: (x, y, w, h) => void mark(`<rect ${box(x, y, w, h)} fill="${context.fillStyle}"`),

    /** @param {number} x @param {number} y @param {number} w @param {number} h */
    strokeRect: (x, y, w, h) => void mark(`<rect ${box(x, y, w, h)} fill="none" ${stroke()}`),

    /** @param {string} string @param {number} x @param {number} y */
    fillText(string, x, y) {
      const anchor = context.textAlign === 'center' ? ' text-anchor="middle"' : '';
      const [size, family] = context.font.split(/ (.*)/);
      marks.push(`<text x="${round(x)}" y="${round(y)}" font-size="${size}" font-family="${escape(family)}" fill="${context.fillStyle}"${anchor}>${escape(string)}</text>`);
    },

    /** @param {string} title @param {string} ground */
    toString: (title = '', ground = '#fff') =>
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">` +
      `<title>${escape(title)}</title><rect width="${width}" height="${height}" fill="${ground}"/>${marks.join('')}</svg>`,
  };

  const stroke = () => `stroke="${context.strokeStyle}" stroke-width="${round(context.lineWidth)}"${dashes.length ? ` stroke-dasharray="${dashes.join(' ')}"` : ''}`;

  /** @param {number} x @param {number} y @param {number} w @param {number} h */
  const box = (x, y, w, h) => `x="${round(x)}" y="${round(y)}" width="${round(w)}" height="${round(h)}"`;

  /** @param {string} start */
  function mark(start) {
    marks.push(`${start}${context.globalAlpha < 1 ? ` opacity="${round(context.globalAlpha)}"` : ''}/>`);
  }

  return context;
}

/** @param {string} string */
function escape(string) {
  return string.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}
