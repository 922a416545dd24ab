import { h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { SoccerPlayback } from '../../soccer/playback.js' */

const words = soccerText.pitch;

/**
 * What is drawn and whether waits are shown, as switches, and the moment in words for those who do not see it.
 *
 * @param {{ layers: { names: boolean, trail: boolean }, playback: SoccerPlayback, changed: () => void }} parts
 */
export function createPitchLegend({ layers, playback, changed }) {
  /** @param {string} label @param {boolean} checked @param {(on: boolean) => void} turn */
  const choice = (label, checked, turn) => {
    const box = h('input', { type: 'checkbox', checked });
    box.addEventListener('change', () => turn(box.checked));
    return h('label', { class: 'layer' }, box, label);
  };
  const summary = h('p', { class: 'unseen', id: 'soccer-summary' });
  const element = h(
    'div',
    { class: 'legend' },
    h(
      'div',
      { class: 'layers', role: 'group', 'aria-label': words.layers },
      choice(words.labels, layers.names, (on) => ((layers.names = on), changed())),
      choice(words.trail, layers.trail, (on) => ((layers.trail = on), changed())),
      choice(words.waits, !playback.skips, (on) => void (playback.skips = !on)),
    ),
    summary,
  );
  let told = -Infinity;

  return {
    element,
    /** @param {string} text */
    show(text) {
      const now = performance.now();
      if (playback.playing && now - told < 5000) return; // read out when it rests, and now and then
      told = now;
      write(summary, text);
    },
  };
}
