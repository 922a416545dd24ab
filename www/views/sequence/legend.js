import { h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Scene } from '../../draw/sequence.js' */

/** @typedef {Scene['layers']} Layers */

const NAMES = /** @type {const} */ (['robots', 'plan', 'frontier', 'fan']);

/**
 * The layers of the map as switches, and the moment in words for those who do not see it.
 *
 * @param {{ layers: Layers, changed: () => void }} parts
 */
export function createSequenceLegend({ layers, changed }) {
  const counts = new Map();
  /** @type {Map<string, HTMLElement>} */
  const labels = new Map();
  const switches = NAMES.map((name) => {
    const box = h('input', { type: 'checkbox', checked: layers[name] });
    box.addEventListener('change', () => {
      layers[name] = box.checked;
      changed();
    });
    const count = h('output', {});
    counts.set(name, count);
    const label = h('label', { class: 'layer', 'data-layer': `plan-${name}` }, box, h('span', { class: 'swatch', 'aria-hidden': 'true' }), sequenceText.layers[name], count);
    labels.set(name, label);
    return label;
  });
  const summary = h('p', { class: 'unseen', id: 'sequence-summary' });
  const element = h('div', { class: 'legend' }, h('div', { class: 'layers', role: 'group', 'aria-label': sequenceText.layers.label }, ...switches), summary);
  return {
    element,
    /** @param {Partial<Record<typeof NAMES[number], string>>} numbers @param {boolean} fan whether there is one @param {string} words */
    show(numbers, fan, words) {
      labels.get('fan')?.toggleAttribute('hidden', !fan);
      for (const [name, count] of counts) write(count, numbers[/** @type {typeof NAMES[number]} */ (name)] ?? '');
      write(summary, words);
    },
  };
}
