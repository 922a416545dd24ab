import { metres, ratioOf } from '../../sequence/words.js';
import { h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { createCurve } from './curve.js';

/** @import { PlanTheme } from '../../draw/sequence.js' */
/** @import { Planner } from '../../sequence/planner.js' */

/**
 * Counters of the search, and incumbent and bound over its integrations.
 *
 * @param {{ planner: Planner, theme: () => PlanTheme, onTheme: (listener: () => void) => void }} parts
 */
export function createSearchTab({ planner, theme, onTheme }) {
  const facts = createFacts();
  const curve = createCurve({ curve: () => planner.curve, theme });
  onTheme(curve.restyle);
  const element = h('div', { class: 'tab-body' }, facts.element, curve.element);
  return {
    element,
    show() {
      facts.show(planner);
      curve.refresh();
    },
  };
}

/** A list of counters, each with its meaning. @param {string[]} [only] those that are wanted */
export function createFacts(only) {
  const rows = sequenceText.search.facts.filter(([name]) => only?.includes(name) ?? true).map(([name, label, help]) => {
    const value = h('dd', { 'data-fact': name });
    return { name, value, parts: [h('dt', { title: help }, label), value] };
  });
  const element = h('dl', { class: 'facts-list' }, ...rows.flatMap(({ parts }) => parts));
  return {
    element,
    /** @param {Pick<Planner, 'progress' | 'ms' | 'status'>} search */
    show({ progress, ms }) {
      const said = /** @type {Record<string, string>} */ (
        progress
          ? {
              cost: progress.cost === null ? '–' : metres(progress.cost),
              bound: progress.lower_bound === null ? '–' : metres(progress.lower_bound),
              ratio: progress.proven_ratio === null ? '–' : ratioOf(progress.proven_ratio),
              weight: progress.proven_weight === null ? sequenceText.search.weight(progress.weight) : sequenceText.search.proven(progress.weight, progress.proven_weight),
              integrated: String(progress.integrated),
              collided: String(progress.collided),
              expanded: String(progress.expanded),
              open: String(progress.open),
              dropped: String(progress.late + progress.missed + progress.alike),
              memory: `${(progress.bytes / 1e6).toFixed(1)} MB`,
              time: sequenceText.search.seconds(ms / 1000),
            }
          : {}
      );
      for (const { name, value } of rows) write(value, said[name] ?? '–');
    },
  };
}
