import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { letterOf, showStatus, statusMark } from './status.js';

/** @import { BenchNode, Moment } from '../../trees/types.js' */
/** @import { Answer } from '../../trees/script.js' */

const STATUSES = /** @type {const} */ (['SUCCESS', 'FAILURE', 'RUNNING', 'SKIPPED']);
const MOST_RUNNING = 1_000_000;

/** @typedef {{ node: BenchNode, moment: Moment | null, letters: string, answer: Answer | null, sharing: number, progress: number | null }} ShownNode
 *   `answer` of a scripted leaf, `sharing` nodes have its name, `progress` ticks it has been RUNNING */

/**
 * The selected node: what it is, what it returned, what it answers, and where to pause.
 *
 * @param {{ answer: (leaf: string, answer: Answer) => void, pauseAt: (id: number, letters: string) => void, goTo: (line: number, column: number) => void }} parts
 */
export function createNodeTab({ answer, pauseAt, goTo }) {
  const empty = h('p', { class: 'empty' }, benchText.node.none);
  const body = h('div', { class: 'node-body' });
  const element = h('div', { class: 'tab-body' }, empty, body);
  let shape = '';
  /** @type {((shown: ShownNode) => void)[]} what changes while the node stays */
  let parts = [];

  /** @param {ShownNode} shown */
  function build({ node, sharing }) {
    /** @type {{ element: HTMLElement, show: (shown: ShownNode) => void }[]} */
    const nodeParts = [createFacts(node, goTo)];
    if (node.scripted) nodeParts.push(createAnswer(node, sharing, answer));
    nodeParts.push(createPauses(node, pauseAt));
    body.replaceChildren(h('h2', {}, node.name), ...nodeParts.map((part) => part.element));
    parts = nodeParts.map((part) => part.show);
  }

  return {
    element,

    /** @param {ShownNode | null} shown */
    show(shown) {
      empty.hidden = shown !== null;
      body.hidden = shown === null;
      if (!shown) return;
      const next = JSON.stringify([shown.node, shown.sharing]);
      if (next !== shape) build(shown);
      shape = next;
      for (const part of parts) part(shown);
    },
  };
}

/** @param {BenchNode} node @param {(line: number, column: number) => void} goTo */
function createFacts(node, goTo) {
  const now = statusMark('.');
  const last = statusMark('.');
  const facts = h('dl', { class: 'facts-list' });
  const { type, category, scripted, definition, line, column, ports, conditions } = node;
  /** @type {[string, Node | string][]} */
  const rows = [
    [benchText.node.now, now],
    [benchText.node.last, last],
    [benchText.node.type, type],
    [benchText.node.kind, scripted ? `${benchText.node.kinds[category]}, ${benchText.node.scripted}` : benchText.node.kinds[category]],
    ...(definition ? [/** @type {[string, string]} */ ([benchText.node.tree, definition])] : []),
    [benchText.node.line, button(benchText.node.goTo(line), () => goTo(line, column), { class: 'link' })],
  ];
  for (const [name, value] of rows) facts.append(h('dt', {}, name), h('dd', {}, value));
  const element = h('div', {}, facts, ...table(benchText.node.ports, ports), ...table(benchText.node.conditions, conditions));

  return {
    element,
    /** @param {ShownNode} shown */
    show({ node: { id }, moment }) {
      const ticked = moment?.ticked[id] ?? '.';
      const kept = moment?.kept[id] ?? 'I';
      if (moment?.error?.node === id) showStatus(now, 'E', `ERROR: ${moment.error.message}`);
      else if (ticked !== '.') showStatus(now, ticked);
      else if (kept !== 'I') showStatus(now, kept, benchText.node.kept(benchText.status[kept]));
      else showStatus(now, '.', benchText.node.notTicked);
      const tick = moment?.last[id] ?? null;
      if (tick === null) showStatus(last, '.', benchText.node.never);
      else showStatus(last, moment?.lastStatus[id] ?? '.', `${benchText.status[moment?.lastStatus[id] ?? ''] ?? ''} ${benchText.node.tick(tick)}`);
    },
  };
}

/** @param {string} caption @param {[string, string][]} pairs */
function table(caption, pairs) {
  if (pairs.length === 0) return [];
  const rows = pairs.map(([name, value]) => h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, h('code', {}, value))));
  return [h('table', { class: 'pairs' }, h('caption', {}, caption), h('tbody', {}, ...rows))];
}

/** @param {BenchNode} node @param {number} sharing @param {(leaf: string, answer: Answer) => void} change */
function createAnswer(node, sharing, change) {
  const legend = h('legend', {});
  /** @type {Answer} */
  let present = { running: 0, then: 'SUCCESS', writes: {} };
  const radios = STATUSES.map((status) => {
    const input = h('input', { type: 'radio', name: 'trees-answer', value: status });
    input.addEventListener('change', () => change(node.name, { ...present, then: status, running: status === 'RUNNING' ? 0 : present.running }));
    return { status, input, label: h('label', { class: 'check' }, input, statusMark(letterOf(status))) };
  });
  const running = h('input', { type: 'number', id: 'trees-running', 'aria-label': benchText.node.afterLong, min: 0, max: MOST_RUNNING, step: 1, inputmode: 'numeric' });
  running.addEventListener('change', () => {
    const ticks = Math.min(Math.max(Math.round(Number(running.value) || 0), 0), MOST_RUNNING);
    running.value = String(ticks);
    change(node.name, { ...present, running: ticks });
  });
  const outputs = node.outputs.map((port) => {
    const id = `trees-output-${port}`;
    const input = h('input', { type: 'text', id, autocomplete: 'off', spellcheck: 'false' });
    input.addEventListener('change', () => {
      const { [port]: _, ...others } = present.writes;
      change(node.name, { ...present, writes: input.value === '' ? others : { ...others, [port]: input.value } });
    });
    return { port, input, row: h('div', { class: 'field' }, h('label', { for: id }, benchText.node.output(port)), input) };
  });
  const progress = h('p', { class: 'said small' });
  const element = h(
    'fieldset',
    { class: 'answer' },
    legend,
    h('div', { class: 'choices' }, ...radios.map(({ label }) => label)),
    h('div', { class: 'field' }, h('span', { 'aria-hidden': 'true' }, benchText.node.after), running, h('span', { 'aria-hidden': 'true' }, benchText.node.runningUnit)),
    ...outputs.map(({ row }) => row),
    progress,
    ...(sharing > 1 ? [h('p', { class: 'said small' }, benchText.node.shared(sharing))] : []),
  );

  return {
    element,
    /** @param {ShownNode} shown */
    show({ moment, answer, progress: done }) {
      if (!answer) return;
      present = answer;
      write(legend, benchText.node.returns(moment?.tick ?? 0));
      for (const { status, input } of radios) input.checked = status === answer.then;
      running.disabled = answer.then === 'RUNNING';
      if (document.activeElement !== running) running.value = String(answer.running);
      for (const { port, input } of outputs) if (document.activeElement !== input) input.value = answer.writes[port] ?? '';
      write(progress, done === null ? '' : benchText.node.progress(done));
    },
  };
}

/** @param {BenchNode} node @param {(id: number, letters: string) => void} pauseAt */
function createPauses({ id }, pauseAt) {
  const boxes = ['S', 'F', 'R', 'K', 'H'].map((letter) => {
    const input = h('input', { type: 'checkbox', value: letter });
    input.addEventListener('change', () => pauseAt(id, boxes.filter((box) => box.input.checked).map((box) => box.letter).join('')));
    const label = letter === 'H' ? benchText.node.pauseHalted : benchText.node.pauseOn(benchText.status[letter]);
    return { letter, input, label: h('label', { class: 'check' }, input, label) };
  });
  const element = h('fieldset', { class: 'pauses' }, h('legend', {}, benchText.node.pause), h('div', { class: 'choices' }, ...boxes.map(({ label }) => label)));

  return {
    element,
    /** @param {ShownNode} shown */
    show({ letters }) {
      for (const { letter, input } of boxes) input.checked = letters.includes(letter);
    },
  };
}

