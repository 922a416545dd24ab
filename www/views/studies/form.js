import { h, write } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { renamed } from '../../studies/draft.js';
import { SIZES } from '../../studies/types.js';
import { createCells } from './cells.js';
import { choiceField, labelled, read, textField } from './fields.js';
import { createSettings } from './settings.js';

/** @import { Path } from '../../studies/draft.js' */
/** @import { StudySession } from '../../studies/session.js' */

/**
 * The study as a form. It is built anew from the study whenever that has changed, with focus and folds where they were; a
 * fault is told under the field it is about.
 *
 * @param {{ pane: HTMLElement, session: StudySession, presets: Record<string, string> }} parts
 */
export function createStudyForm({ pane, session, presets }) {
  const choices = Object.entries(presets).map(([value, json]) => ({ value, label: JSON.parse(json).title || value }));
  let shown = '';
  let waiting = false;

  /** @param {Path} path @param {any} value */
  const change = (path, value) => session.change(path, value);

  /** @param {Path} path @param {string} from @param {string} to @param {any} value */
  const rename = (path, from, to, value) => session.replace(renamed(session.draft, path, from, to, value));

  function build() {
    const { draft } = session;
    const open = new Set([...pane.querySelectorAll('details[open]')].map(({ id }) => id));
    const first = pane.childElementCount === 0;
    const focused = pane.contains(document.activeElement) ? document.activeElement?.id : '';
    pane.replaceChildren(...(draft ? parts(draft) : [h('p', { class: 'secondary form-missing' }, text.form.noJson)]));
    for (const details of pane.querySelectorAll('details')) details.open = first ? details.classList.contains('unfolded') : open.has(details.id);
    if (focused) document.getElementById(focused)?.focus();
  }

  /** @param {any} draft */
  function parts(draft) {
    return [
      part('words', text.form.words, false, [
        labelled(['study'], text.form.name, textField(draft.study, (typed) => change(['study'], typed))),
        labelled(['title'], text.form.title, textField(draft.title, (typed) => change(['title'], typed === '' ? undefined : typed))),
        labelled(['about'], text.form.about, textField(draft.about, (typed) => change(['about'], typed === '' ? undefined : typed), { long: true })),
      ]),
      part('scenario', text.form.scenario, true, scenario(draft.scenario)),
      part('grid', text.form.grid, true, [createSettings({ path: ['grid'], values: draft.grid, schema: session.parameters(), legend: text.form.gridLong, grid: true, change })]),
      part('cells', text.form.cells, false, createCells({ session, presets: choices, change: (path, value) => change(path, path.length === 2 && value === undefined && draft.cells.length === 1 ? undefined : value), rename })),
      part('runs', text.form.runs, true, runs(draft)),
      part('metrics', text.form.metrics, false, metrics(draft.metrics)),
      part('figure', text.form.figure, false, figure(draft)),
    ];
  }

  /** @param {string} name @param {string} label @param {boolean} unfolded @param {(Node | null)[]} fields */
  function part(name, label, unfolded, fields) {
    return h('details', { class: `group ${unfolded ? 'unfolded' : ''}`, id: `studies-part-${name}` }, h('summary', {}, label), ...fields);
  }

  /** @param {any} value */
  function scenario(value) {
    const path = ['scenario'];
    const settings = (/** @type {Path} */ inside, /** @type {any} */ values, prefix = '') => createSettings({ path: inside, values, schema: session.parameters(), legend: text.form.settings, prefix, change });
    if (value === undefined || value?.preset !== undefined) {
      const own = value === undefined ? [{ value: '', label: text.form.noScenario }, ...choices] : choices;
      const preset = choiceField(own, value?.preset ?? '', (chosen) => change([...path, 'preset'], chosen === '' ? undefined : chosen));
      return [labelled([...path, 'preset'], text.form.preset, preset), value === undefined ? null : settings([...path, 'set'], value.set)];
    }
    return [h('p', { class: 'secondary' }, text.form.whole), settings(path, value, `${value?.world}.`)];
  }

  /** @param {any} draft */
  function runs(draft) {
    /** @param {Path} path @param {any} value @param {string} label */
    const number = (path, value, label) => labelled(path, label, textField(value, (typed) => change(path, typed.trim() === '' ? undefined : read(typed)), { numeric: true }));
    const wide = (/** @type {HTMLElement} */ field) => h('div', { class: 'whole-row' }, field);
    const sizes = SIZES.slice(0, 2).flatMap((size) => [
      number(['sizes', size, 'seeds'], draft.sizes?.[size]?.seeds, text.form.sizeSeeds(text.list.sizes[size])),
      number(['sizes', size, 'steps'], draft.sizes?.[size]?.steps, text.form.sizeSteps(text.list.sizes[size])),
    ]);
    const fields = [number(['seeds', 'first'], draft.seeds?.first, text.form.first), number(['seeds', 'count'], draft.seeds?.count, text.form.count), wide(number(['steps'], draft.steps, text.form.steps)), ...sizes];
    return [h('div', { class: 'numbers' }, ...fields), h('div', { 'data-path': 'sizes' }, h('p', { class: 'field-error' }))];
  }

  /** @param {any} chosen */
  function metrics(chosen) {
    const list = Array.isArray(chosen) ? chosen : [];
    const boxes = session.metrics().map(({ name, label, help }) => {
      const box = h('input', { type: 'checkbox', id: `study-metric-${name}`, checked: list.includes(name) });
      box.addEventListener('change', () => change(['metrics'], box.checked ? [...list, name] : list.filter((other) => other !== name)));
      return h('label', { class: 'check', title: help }, box, label);
    });
    return [h('fieldset', { class: 'control', 'data-path': 'metrics' }, h('legend', { class: 'unseen' }, text.form.metrics), ...boxes, h('p', { class: 'field-error' }))];
  }

  /** @param {any} draft */
  function figure(draft) {
    const value = draft.figure;
    const kinds = [{ value: '', label: text.form.noFigure }, ...Object.entries(text.form.kinds).map(([kind, label]) => ({ value: kind, label }))];
    const measured = session.metrics().filter(({ name }) => draft.metrics?.includes?.(name)).map(({ name, label }) => ({ value: name, label }));
    const factors = [{ value: '', label: text.form.nothing }, ...(session.outline?.factors ?? []).map((factor) => ({ value: factor, label: session.parameters().find(({ key }) => key === factor)?.label ?? factor }))];
    const drawn = (/** @type {string} */ kind) => change(['figure'], kind === '' ? undefined : { metric: measured[0]?.value, ...value, kind });
    const one = (/** @type {string} */ field, /** @type {string} */ label, /** @type {{ value: string, label: string }[]} */ list) =>
      labelled(['figure', field], label, choiceField(list, value?.[field] ?? '', (chosen) => change(['figure', field], chosen === '' ? undefined : chosen)));
    const fields = [labelled(['figure', 'kind'], text.form.kind, choiceField(kinds, value?.kind ?? '', drawn))];
    if (value) fields.push(one('metric', text.form.metric, measured), one('x', text.form.x, factors), one('group', text.form.group, factors));
    const values = Object.values(draft.paper ?? {}).reduce((/** @type {number} */ sum, cell) => sum + Object.keys(cell ?? {}).length, 0);
    return [...fields, h('p', { class: 'secondary' }, text.form.inText(draft.tests?.length ?? 0, values))];
  }

  /** Tells the fault under the field that is nearest to it. */
  function showFault() {
    for (const place of pane.querySelectorAll('.field-error')) write(place, '');
    for (const field of pane.querySelectorAll('[aria-invalid]')) field.removeAttribute('aria-invalid');
    const { fault } = session;
    if (!fault) return;
    const above = (/** @type {string} */ path) => fault.path === path || fault.path.startsWith(`${path}.`) || fault.path.startsWith(`${path}[`);
    const places = /** @type {HTMLElement[]} */ ([...pane.querySelectorAll('[data-path]')]).filter(({ dataset }) => above(dataset.path ?? ''));
    const place = places.sort((a, b) => (b.dataset.path ?? '').length - (a.dataset.path ?? '').length)[0];
    if (!place) return;
    const line = place.querySelector(':scope > .field-error');
    if (line) write(line, place.dataset.path === fault.path ? fault.message : text.fault.at(fault.path, fault.message));
    place.querySelector('input, select, textarea')?.setAttribute('aria-invalid', 'true');
    for (let details = place.closest('details'); details; details = details.parentElement?.closest('details') ?? null) details.open = true;
  }

  session.on(() => {
    if (waiting) return;
    waiting = true;
    // After the event that changed the study: focus has moved on by then, and is kept.
    setTimeout(() => {
      waiting = false;
      const next = `${session.list} ${JSON.stringify(session.draft)} ${session.outline?.world} ${session.outline?.factors.join(' ')}`;
      if (next !== shown && !session.list) build();
      shown = next;
      showFault();
    });
  });
}
