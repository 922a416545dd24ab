import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { letterOf, statusMark } from './status.js';

/** @import { BenchNode, Moment } from '../../trees/types.js' */

const MOST = 500;

/**
 * What happened in the tick on screen: every return in order, what was halted, the error that ended it.
 *
 * @param {{ select: (id: number) => void }} parts
 */
export function createLogTab({ select }) {
  const head = h('h2', {});
  const facts = h('p', { class: 'said small' });
  const error = h('div', { class: 'tick-error', hidden: true });
  const trace = h('ol', { class: 'trace', id: 'trees-trace' });
  const more = h('p', { class: 'said small' });
  const haltedHead = h('h2', {}, benchText.log.halted);
  const noneHalted = h('p', { class: 'said small' }, benchText.log.noneHalted);
  const halted = h('ol', { class: 'trace', id: 'trees-halted' });
  const none = h('p', { class: 'empty' }, benchText.log.none);
  const body = h('div', { class: 'log-body' }, head, facts, error, trace, more, noneHalted, haltedHead, halted);
  const element = h('div', { class: 'tab-body' }, none, body);

  /** @type {Moment | null} */
  let shown = null;

  /** @param {BenchNode | undefined} node @param {string} letter */
  function row(node, letter) {
    const name = node?.name ?? '';
    return h('li', {}, button(name, () => node && select(node.id), { class: 'link', title: node && node.type !== name ? node.type : undefined }), statusMark(letter));
  }

  return {
    element,
    /** @param {Moment | null} moment @param {BenchNode[]} nodes */
    show(moment, nodes) {
      const nothing = !moment || (moment.tick === 0 && moment.halted.length === 0 && !moment.error);
      none.hidden = !nothing;
      body.hidden = nothing;
      if (!moment || nothing || moment === shown) return;
      shown = moment;
      write(head, benchText.log.caption(moment.tick));
      write(facts, `${benchText.log.passes(moment.passes)}, ${benchText.log.time(moment.now)}`);
      error.hidden = moment.error === null;
      if (moment.error) {
        const { node, message } = moment.error;
        error.replaceChildren(h('p', {}, benchText.log.error), h('p', {}, button(nodes[node]?.name ?? '', () => select(node), { class: 'link' }), `: ${message}`));
      }
      trace.replaceChildren(...moment.trace.slice(0, MOST).map(([node, status]) => row(nodes[node], letterOf(status))));
      write(more, moment.trace.length > MOST ? benchText.log.more(moment.trace.length - MOST) : '');
      haltedHead.hidden = moment.halted.length === 0;
      noneHalted.hidden = !haltedHead.hidden;
      halted.replaceChildren(...moment.halted.map((node) => row(nodes[node], 'H')));
    },
  };
}
