import { createEngine } from '../engine.js';
import { fieldOf } from '../link.js';
import { button, h, write } from '../ui/dom.js';
import { sequenceText } from '../ui/strings.sequence.en.js';
import { createMap } from '../views/sequence/map.js';
import { createFacts } from '../views/sequence/searchtab.js';
import { createPlanner } from './planner.js';
import { kindOf, verdictOf } from './words.js';

/** @import { PlanTheme } from '../draw/sequence.js' */
/** @import { SequenceFrame } from '../views/sequence/frame.js' */
/** @import { Layers } from '../views/sequence/legend.js' */
/** @import { Playback } from './playback.js' */
/** @import { SequenceSession } from './session.js' */
/** @import { Scenario } from './types.js' */

const words = sequenceText.compare;

const FACTS = ['ratio', 'integrated', 'expanded', 'open', 'time'];

/** @type {Record<string, [Record<string, any>, Record<string, any>]>} what A and B differ in */
const PAIRS = {
  literal: [{ method: 'literal' }, { method: 'exact' }],
  weight: [
    { method: 'exact', weight: 2 },
    { method: 'exact', weight: 10 },
  ],
  geodesic: [
    { method: 'exact', geodesic: false },
    { method: 'exact', geodesic: true },
  ],
};

/**
 * A | B: one layout, two ways to search, a worker and a map each.
 *
 * @param {{ frame: SequenceFrame, session: SequenceSession, playback: Playback, layers: Layers, spawn: () => Worker, theme: () => PlanTheme,
 *   onTheme: (listener: () => void) => void, broke: (message: string) => void, announce: (message: string) => void }} parts
 */
export function createCompare({ frame, session, playback, layers, spawn, theme, onTheme, broke, announce }) {
  let on = false;
  let told = '';
  const sides = /** @type {const} */ (['a', 'b']).map((letter, index) => {
    const engine = createEngine(broke, spawn);
    const planner = createPlanner(engine);
    const map = createMap({
      label: words.map(letter.toUpperCase()),
      scene() {
        const { task, found, stale } = planner;
        return task && { task, path: found, step: Math.min(playback.step, Math.max((found?.frames ?? 1) - 1, 0)), stale, start: task.start, layers: { ...layers, fan: false } };
      },
      frontier: () => planner,
      fan: () => null,
      theme,
    });
    const name = h('span', { class: 'side-name' });
    const facts = createFacts(FACTS);
    const said = h('p', { class: 'side-said' });
    const element = h('section', { class: 'sequence-side', 'data-side': letter, 'aria-label': letter.toUpperCase() }, h('h3', {}, h('b', {}, letter.toUpperCase()), ' ', name), map.stage, said, facts.element);
    planner.on('slice', () => {
      map.invalidate();
      facts.show(planner);
      write(said, verdictOf(planner));
      element.dataset.result = kindOf(planner);
    });
    planner.on('ended', finish);
    onTheme(map.invalidate);
    return { index, engine, planner, map, name, element };
  });

  const pair = h('select', { id: 'sequence-pair' }, ...words.pairs.map(([value, label]) => h('option', { value }, label)));
  pair.addEventListener('change', () => {
    session.compare(pair.value);
    void run();
  });
  const status = h('p', { class: 'compare-said', id: 'sequence-compare' });
  const bar = h('div', { class: 'compare-bar' }, h('label', { for: pair.id }, words.pair), pair, button(words.again, () => void run()), status);
  const element = h('div', { class: 'sequence-sides' }, ...sides.map((side) => side.element));

  /** Both search the present layout from the start. */
  async function run() {
    if (!on) return;
    const [a, b] = PAIRS[pair.value];
    told = '';
    write(status, words.running);
    /** @type {[Record<string, any>, Record<string, any>]} */
    const both = [a, b];
    for (const { name, index } of sides) write(name, words.side(both[index], labelOf));
    await Promise.all(sides.map(({ planner, index }) => planner.open(/** @type {Scenario} */ ({ ...session.scenario, ...both[index] }))));
  }

  /** @param {string} field @param {any} value */
  function labelOf(field, value) {
    const parameter = session.schema.find(({ key }) => fieldOf(key) === field);
    const said = parameter?.choices?.find((choice) => choice.value === value)?.label ?? (typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value));
    return parameter?.choices ? said : `${parameter?.label ?? field} ${said}`;
  }

  function finish() {
    const [a, b] = sides.map(({ planner }) => planner);
    if (a.status !== 'ended' || b.status !== 'ended' || !a.progress || !b.progress) return;
    const said = words.ended(a.progress, b.progress);
    write(status, said);
    if (said !== told) announce(said);
    told = said;
  }

  session.on('change', () => void run());
  playback.on(() => on && sides.forEach(({ map }) => map.invalidate()));

  return {
    bar,
    element,
    on: () => on,

    /** @param {string | null} wanted in what A and B differ; null for what was compared last */
    open(wanted) {
      const same = wanted === null || wanted === pair.value;
      pair.value = wanted ?? pair.value;
      session.compare(pair.value);
      if (on) return void (same || run());
      on = true;
      frame.stages.prepend(element);
      frame.head.prepend(bar);
      for (const { engine } of sides) engine.start();
      void run();
    },

    /** Ends both searches; whether the session still asks for them is not decided here. */
    close() {
      on = false;
      for (const { planner, engine } of sides) {
        planner.abandon();
        engine.end();
      }
      element.remove();
      bar.remove();
    },

    redraw: () => sides.forEach(({ map }) => map.invalidate()),
    hold: () => sides.forEach(({ planner }) => planner.hold()),
  };
}

/** @typedef {ReturnType<typeof createCompare>} SequenceCompare */
