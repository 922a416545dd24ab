import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { createMachineSlot } from './machineslot.js';
import { createTreeFigure } from './treefigure.js';

/** @import { Engine } from '../engine.js' */
/** @import { SeenRun } from '../lens.js' */
/** @import { Selection } from '../selection.js' */
/** @import { Derivation, Derived, Detail } from '../types.js' */

const LESSON = '#/learn/5';

/**
 * Codons, grammar rules and tree nodes, linked. Changing a codon is a what-if: it never touches the run.
 *
 * @param {{ pane: HTMLElement, engine: Pick<Engine, 'request'>, run: SeenRun, selection: Selection }} parts
 */
export function createGenomeTab({ pane, engine, run, selection }) {
  const largest = () => Number(run.scenario['codon-max'] ?? 255);
  const said = h('p', { class: 'said' });
  const cells = h('div', { class: 'codons', role: 'group', 'aria-label': text.genome.codons });
  const rule = h('p', { class: 'rule' }, text.genome.hint);
  const verdict = h('p', { class: 'verdict' });
  const whatIf = h('div', { class: 'what-if', hidden: true }, h('p', {}, text.genome.whatIf), button(text.genome.reset, reset));
  const figure = createTreeFigure({ label: text.genome.tree, select: pointFromTree });
  const frame = h('div', { class: 'tree-frame' }, figure.svg);
  const machine = createMachineSlot({ plain: true });
  const empty = h('p', { class: 'empty' }, text.agent.none);
  const body = h('div', {}, said, cells, rule, whatIf, verdict, frame, machine.element);
  const about = h('p', { class: 'about-genome' }, text.genome.about, ' ', h('a', { href: LESSON }, text.genome.lesson));
  pane.append(about, empty, body);

  /** @type {number[]} genome of the robot in the run */
  let own = [];
  /** @type {number[]} genome on screen */
  let codons = [];
  /** @type {Map<number, Derivation[]>} steps by codon; a wrapped genome reads one codon more than once */
  let steps = new Map();
  let robot = -1;
  let current = 0;
  let asked = 0;

  /** @param {Detail} detail */
  function show({ agent }) {
    empty.hidden = agent !== null;
    body.hidden = agent === null;
    if (!agent) return;
    const changed = agent.id !== robot || agent.genome.join() !== own.join();
    const edited = codons.join() !== own.join();
    if (!changed || (edited && agent.id === robot)) return; // an edited genome stays until it is reset
    robot = agent.id;
    own = agent.genome;
    codons = [...own];
    build();
    void derive();
  }

  function reset() {
    codons = [...own];
    build();
    void derive();
  }

  function build() {
    whatIf.hidden = codons.join() === own.join();
    if (cells.children.length !== codons.length) cells.replaceChildren(...codons.map((_, index) => cell(index)));
    current = Math.min(current, codons.length - 1);
    codons.forEach((value, index) => {
      const element = cells.children[index];
      write(element, value);
      element.setAttribute('aria-valuenow', String(value));
      element.setAttribute('tabindex', index === current ? '0' : '-1');
      element.classList.toggle('edited', value !== own[index]);
    });
  }

  /** @param {number} index */
  function cell(index) {
    const point = () => pointFromCodon(index);
    const take = () => {
      cells.children[current]?.setAttribute('tabindex', '-1');
      current = index;
      cells.children[current].setAttribute('tabindex', '0');
      point();
    };
    return h('span', { role: 'spinbutton', class: 'codon', 'data-index': index, 'aria-valuemin': 0, 'aria-valuemax': largest(), onpointerenter: point, onfocus: take, onclick: () => focus(index) });
  }

  async function derive() {
    const ticket = ++asked;
    /** @type {Derived} */
    let derived;
    try {
      derived = (await engine.request('derive', { codons })).derived;
    } catch (error) {
      write(verdict, error instanceof Error ? error.message : String(error));
      return;
    }
    if (ticket !== asked) return;
    steps = new Map();
    for (const step of derived.steps) steps.set(step.codon, [...(steps.get(step.codon) ?? []), step]);
    codons.forEach((value, index) => {
      const read = steps.get(index);
      const element = cells.children[index];
      element.classList.toggle('unused', !read);
      element.setAttribute('aria-label', text.genome.codon(index, read ? text.genome.step(read[0]) : text.genome.unused));
      element.setAttribute('aria-valuetext', String(value));
    });
    write(said, text.genome.said(robot, derived.used, codons.length));
    write(verdict, derived.valid ? text.genome.valid(derived.depth, derived.diversity ?? 0) : text.genome.invalid(derived.reason ?? ''));
    verdict.classList.toggle('bad', !derived.valid);
    const how = { shape: derived.phenotype ?? 'none', group: true };
    figure.show(derived.nodes, how);
    machine.show(derived.machine, how);
    pointFromCodon(current);
  }

  /** @param {number} index */
  function pointFromCodon(index) {
    const read = steps.get(index);
    write(rule, text.genome.rule(index, codons[index], read ?? []));
    const made = read?.find((step) => step.node !== null)?.node ?? null;
    figure.point(made);
    machine.point(made);
    light(new Set([index]));
  }

  /** @param {number | null} id */
  function pointFromTree(id) {
    const made = new Set([...steps].filter(([, read]) => read.some((step) => step.node === id)).map(([codon]) => codon));
    figure.point(id);
    light(made);
    const first = Math.min(...made);
    if (made.size > 0) write(rule, text.genome.rule(first, codons[first], steps.get(first) ?? []));
  }

  /** @param {Set<number>} lit */
  function light(lit) {
    for (let index = 0; index < cells.children.length; index += 1) cells.children[index].classList.toggle('lit', lit.has(index));
  }

  /** @param {number} index */
  function focus(index) {
    /** @type {HTMLElement} */ (cells.children[Math.min(Math.max(index, 0), codons.length - 1)]).focus();
  }

  /** @param {number} by */
  function turn(by) {
    const values = largest() + 1;
    codons[current] = (codons[current] + by + values) % values;
    build();
    void derive();
  }

  cells.addEventListener('keydown', (event) => {
    /** @type {Record<string, () => void>} */
    const moves = {
      ArrowLeft: () => focus(current - 1),
      ArrowRight: () => focus(current + 1),
      ArrowUp: () => turn(1),
      ArrowDown: () => turn(-1),
      PageUp: () => turn(10),
      PageDown: () => turn(-10),
      Home: () => focus(0),
      End: () => focus(codons.length - 1),
    };
    if (event.ctrlKey || event.altKey || event.metaKey || !moves[event.key]) return;
    event.preventDefault();
    moves[event.key]();
  });
  selection.on(() => {
    if (selection.agent === robot) return;
    own = [];
    codons = [];
    robot = -1;
  });

  new ResizeObserver(() => figure.fit(frame.clientWidth)).observe(frame);
  return { show };
}
