import { things } from '../../sequence/edit.js';
import { button, h } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Hold } from '../../sequence/hold.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */
/** @import { Form, Task } from '../../sequence/types.js' */
/** @import { Tool } from './handles.js' */

const DEGREES = 180 / Math.PI;
const NEW_SIZE = 0.05; // of the map's width: radius or half side of an obstacle added without drawing it
const FIELDS = /** @type {const} */ (['x', 'y', 'heading', 'radius', 'width', 'height']);
const TOOLS = /** @type {const} */ (['disc', 'box', 'polygon']);

/**
 * The bar over the map: undo and redo, obstacles to draw, and the chosen thing with its coordinates to be typed.
 *
 * @param {{ hold: Hold, session: SequenceSession, task: () => Task | null, finish: () => void, changed: () => void }} parts `finish` closes a polygon
 */
export function createTools({ hold, session, task, finish, changed }) {
  /** @type {Tool | null} */
  let tool = null;
  /** @type {HTMLInputElement | null} what is being typed into stays as it is */
  let typing = null;
  const undo = button(sequenceText.tools.undo, () => void session.undo(), { glyph: '↶', action: 'undo' });
  const redo = button(sequenceText.tools.redo, () => void session.redo(), { glyph: '↷', action: 'redo' });
  const draws = TOOLS.map((kind) => {
    const key = button(sequenceText.tools[kind], () => {}, { title: sequenceText.tools.draw(kind) });
    // A press by keyboard has no pointer to draw with: it puts one down.
    key.addEventListener('click', (event) => (event.detail === 0 ? add(kind) : choose(tool === kind ? null : kind)));
    return { kind, key };
  });
  const close = button(sequenceText.tools.close, finish, { class: 'quiet' });
  const which = h('select', { id: 'sequence-thing' });
  which.addEventListener('change', () => {
    const [kind, index] = which.value.split('-');
    hold.choose(kind ? /** @type {any} */ ({ kind, index: Number(index) }) : null);
  });
  const fields = FIELDS.map((name) => {
    const box = h('input', { type: 'text', inputmode: 'decimal', id: `sequence-${name}`, autocomplete: 'off', size: 6 });
    box.addEventListener('input', () => (typing = box));
    box.addEventListener('change', () => {
      typing = null;
      const number = Number(box.value.trim().replace('−', '-'));
      const fits = box.value.trim() !== '' && Number.isFinite(number) && (name === 'x' || name === 'y' || name === 'heading' || number > 0);
      box.toggleAttribute('aria-invalid', !fits);
      if (!fits) box.setAttribute('aria-invalid', 'true');
      else void hold.put({ [name]: name === 'heading' ? number / DEGREES : number });
    });
    return { name, box, label: h('label', { class: 'place-field' }, sequenceText.tools.field[name], box) };
  });
  const remove = button(sequenceText.tools.remove, () => void hold.remove());
  const hint = h('p', { class: 'secondary small' }, sequenceText.tools.hint);
  const element = h(
    'div',
    { class: 'sequence-tools', role: 'group', 'aria-label': sequenceText.tools.label },
    h('div', { class: 'joined' }, undo, redo),
    h('div', { class: 'joined', role: 'group', 'aria-label': sequenceText.tools.drawing }, ...draws.map(({ key }) => key)),
    close,
    h('label', { class: 'unseen', for: which.id }, sequenceText.tools.chosen),
    which,
    h('div', { class: 'place', role: 'group', 'aria-label': sequenceText.tools.place }, hint, ...fields.map(({ label }) => label), remove),
  );

  /** @param {Tool | null} next */
  function choose(next) {
    tool = next;
    if (tool) hold.choose(null);
    changed();
    show();
  }

  /** Puts an obstacle into the middle of the map. @param {Tool} kind */
  function add(kind) {
    const now = task();
    if (!now) return;
    const [left, right, bottom, top] = now.map;
    const [x, y] = [(left + right) / 2, (bottom + top) / 2];
    const size = (right - left) * NEW_SIZE;
    /** @type {Record<Tool, Form>} */
    const forms = {
      disc: { disc: [x, y, size] },
      box: { box: [x - size, y - size, x + size, y + size] },
      polygon: { polygon: [[x - size, y - size], [x + size, y - size], [x, y + size]] },
    };
    void hold.add(forms[kind]);
  }

  let listed = '';
  function show() {
    undo.disabled = !session.canUndo();
    redo.disabled = !session.canRedo();
    for (const { kind, key } of draws) key.setAttribute('aria-pressed', String(tool === kind));
    close.hidden = tool !== 'polygon';
    const now = task();
    if (!now) return;
    const all = things(now);
    const list = all.map(({ kind }) => kind).join();
    if (list !== listed) {
      listed = list;
      which.replaceChildren(h('option', { value: '' }, sequenceText.tools.none), ...all.map(({ kind, index }) => h('option', { value: `${kind}-${index}` }, sequenceText.tools.thing(kind, index))));
    }
    which.value = hold.chosen ? `${hold.chosen.kind}-${hold.chosen.index}` : '';
    const place = hold.place();
    for (const { name, box, label } of fields) {
      const value = place?.[name];
      label.hidden = value === undefined;
      if (value === undefined || typing === box || (document.activeElement === box && box.getAttribute('aria-invalid'))) continue;
      box.removeAttribute('aria-invalid');
      box.value = String(Math.round((name === 'heading' ? value * DEGREES : value) * 100) / 100);
    }
    hint.hidden = place !== null;
    remove.hidden = hold.chosen?.kind !== 'obstacle';
  }

  return { element, show, tool: () => tool, choose };
}

/** @typedef {ReturnType<typeof createTools>} Tools */

/** Keys on the map: choose, move, remove. @param {HTMLElement} canvas @param {Hold} hold @param {{ escape: () => void }} parts */
export function bindMapKeys(canvas, hold, { escape }) {
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const by = event.shiftKey ? 0.1 : 1;
    const moves = /** @type {Record<string, [number, number]>} */ ({ ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, by], ArrowDown: [0, -by] });
    const steps = /** @type {Record<string, 1 | -1 | 'first' | 'last'>} */ ({ PageDown: 1, PageUp: -1, Home: 'first', End: 'last' });
    if (event.key in moves) {
      if (hold.chosen) void hold.nudge(...moves[event.key]);
      else hold.step('first');
    } else if (event.key in steps) hold.step(steps[event.key]);
    else if (event.key === 'Delete' || event.key === 'Backspace') void hold.remove();
    else if (event.key === 'Escape' && hold.chosen) escape();
    else return;
    event.preventDefault();
  });
}
