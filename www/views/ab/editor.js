import { COMPARISONS } from '../../ab/pairs.js';
import { fieldOf, readValue } from '../../link.js';
import { messageOf } from '../../session.js';
import { valueName } from '../../ui/control.js';
import { button, h, write } from '../../ui/dom.js';
import { abText } from '../../ui/strings.ab.en.js';

/** @import { Difference } from '../../ab/differences.js' */
/** @import { Comparison } from '../../ab/pairs.js' */
/** @import { Session } from '../../session.js' */
/** @import { Parameter, Scenario, Value } from '../../types.js' */

/**
 * @typedef {object} EditorShown
 * @property {Scenario} a
 * @property {Difference[]} differences
 * @property {string} preset B's preset; empty when B is A with differences
 * @property {string} comparison name of the comparison on screen; empty where it is none of the offered
 * @property {number} steps
 *
 * @typedef {object} EditorActs
 * @property {(comparison: Comparison) => void} compare
 * @property {(preset: string) => void} choose B is a preset; when empty, A with the differences there are
 * @property {(differences: Difference[]) => Promise<string>} change gives what is wrong; empty when nothing
 * @property {() => void} swap
 * @property {() => void} same
 * @property {() => void} save
 */

/**
 * The differences of B: chosen as a whole, or one parameter at a time.
 *
 * @param {Session} session
 * @param {EditorActs} acts
 */
export function createEditor(session, acts) {
  const parameters = new Map(session.schema.map((parameter) => [parameter.key, parameter]));
  const offered = COMPARISONS.filter(({ a, b }) => [a, b ?? a].every((name) => session.presets.some((preset) => preset.name === name)));
  const pairs = h('select', { id: 'ab-pair' }, h('option', { value: '' }, abText.editor.ownPair), ...offered.map(({ name }) => h('option', { value: name }, abText.editor.pair[name])));
  const whole = h('select', { id: 'ab-from' }, h('option', { value: '' }, abText.editor.likeA), ...session.presets.map(({ name, title }) => h('option', { value: name }, title)));
  const added = h('select', { id: 'ab-add', 'aria-label': abText.editor.parameter });
  const add = button(abText.editor.add, () => void addChosen());
  const count = h('span', { class: 'count' });
  const list = h('ol', { class: 'ab-list' });
  const none = h('p', { class: 'empty' }, abText.editor.none);
  const problem = h('p', { class: 'field-error', role: 'alert' });
  const element = h(
    'details',
    { class: 'group ab-editor', open: true },
    h('summary', {}, abText.editor.title, count),
    h('div', { class: 'control' }, h('label', { for: 'ab-pair' }, abText.editor.pairs), pairs),
    h('div', { class: 'control' }, h('label', { for: 'ab-from' }, abText.editor.from), whole),
    none,
    list,
    problem,
    h('div', { class: 'row ab-add' }, added, add),
    h('div', { class: 'row' }, button(abText.editor.swap, acts.swap), button(abText.editor.same, acts.same), button(abText.editor.saveB, acts.save)),
    h('p', { class: 'help' }, abText.editor.memory),
  );
  /** @type {EditorShown} */
  let shown = { a: { world: 'geese', seed: 0 }, differences: [], preset: '', comparison: '', steps: 0 };

  pairs.addEventListener('change', () => {
    const comparison = offered.find(({ name }) => name === pairs.value);
    if (comparison) acts.compare(comparison);
    else pairs.value = shown.comparison; // what is on screen is never thrown away by a heading
  });
  whole.addEventListener('change', () => acts.choose(whole.value));

  /** @param {Difference[]} differences */
  async function change(differences) {
    write(problem, await acts.change(differences));
    if (problem.textContent) show(shown); // the fields go back to what holds
  }

  async function addChosen() {
    const parameter = parameters.get(added.value);
    if (!parameter) return;
    await change([...shown.differences, { key: parameter.key, value: another(parameter, shown.a[fieldOf(parameter.key)]), from: 0 }]);
    const field = list.lastElementChild?.querySelector('select, input, textarea');
    if (field instanceof HTMLElement) field.focus();
  }

  /** @param {number} index @param {Partial<Difference>} what */
  const put = (index, what) => change(shown.differences.map((difference, at) => (at === index ? { ...difference, ...what } : difference)));

  /** @param {Difference} difference @param {number} index */
  function row({ key, value, from }, index) {
    const parameter = parameters.get(key);
    if (!parameter) return h('li', {}, key);
    const { label } = parameter;
    const inA = shown.a[fieldOf(key)];
    const field = fieldFor(parameter, value, (next) => put(index, { value: next }));
    field.setAttribute('aria-label', abText.editor.inB(label));
    const remove = button(abText.editor.remove(label), () => void change(shown.differences.filter((_, at) => at !== index)), { glyph: '×', class: 'quiet' });
    return h(
      'li',
      { 'data-difference': key },
      h('div', { class: 'ab-row-head' }, h('span', {}, label), remove),
      h('p', { class: 'ab-in-a' }, abText.editor.inA(named(parameter, inA)), value === inA ? h('em', {}, ` (${abText.editor.alike})`) : null),
      h('div', { class: 'ab-in-b' }, h('span', { 'aria-hidden': 'true' }, abText.editor.b), field, ...(parameter.apply === 'live' ? fromField(parameter, from, index) : [])),
    );
  }

  /** From which tick on a live parameter differs. @param {Parameter} parameter @param {number} from @param {number} index */
  function fromField(parameter, from, index) {
    const box = h('input', { type: 'text', inputmode: 'numeric', size: 5, value: from, 'aria-label': abText.editor.fromTickOf(parameter.label) });
    box.addEventListener('change', () => {
      try {
        void put(index, { from: Number(readValue({ ...parameter, type: 'int', min: 0, hard_max: shown.steps }, box.value)) });
      } catch (fault) {
        write(problem, `${abText.editor.fromTickOf(parameter.label)}: ${messageOf(fault)}`);
        box.setAttribute('aria-invalid', 'true');
      }
    });
    return [h('div', { class: 'ab-from' }, h('span', { 'aria-hidden': 'true' }, abText.editor.fromTick), box)];
  }

  /**
   * @param {Parameter} parameter
   * @param {Value} value
   * @param {(value: Value) => void} take
   */
  function fieldFor(parameter, value, take) {
    const choices = parameter.type === 'bool' ? ['true', 'false'].map((choice) => ({ value: choice, label: named(parameter, choice === 'true') })) : parameter.choices;
    if (choices) {
      const select = h('select', {}, ...choices.map((choice) => h('option', { value: choice.value }, choice.label)));
      select.value = String(value);
      select.addEventListener('change', () => take(readValue(parameter, select.value)));
      return select;
    }
    const box = parameter.type === 'text' ? h('textarea', { rows: 2, spellcheck: 'false' }) : h('input', { type: 'text', inputmode: 'decimal', size: 8 });
    box.value = String(value);
    box.addEventListener('change', () => {
      try {
        take(readValue(parameter, box.value));
      } catch (fault) {
        write(problem, `${parameter.label}: ${messageOf(fault)}`);
        box.setAttribute('aria-invalid', 'true');
      }
    });
    return box;
  }

  /** Written out anew only when something changed: a field keeps the focus. */
  let written = '';

  /** @param {EditorShown} next */
  function show(next) {
    shown = next;
    const { differences, a } = next;
    const said = JSON.stringify([differences, differences.map(({ key }) => a[fieldOf(key)]), problem.textContent]);
    pairs.value = next.comparison;
    whole.value = next.preset;
    write(count, abText.editor.list(differences.length));
    none.hidden = differences.length > 0;
    if (said === written) return;
    const focused = document.activeElement?.closest('[data-difference]')?.getAttribute('data-difference');
    const label = document.activeElement?.getAttribute('aria-label');
    written = said;
    list.replaceChildren(...differences.map(row));
    if (focused) [.../** @type {NodeListOf<HTMLElement>} */ (list.querySelectorAll('[aria-label]'))].find((field) => field.getAttribute('aria-label') === label)?.focus();
    offer(differences);
  }

  /** Parameters that may be added: a live one again, for another tick. @param {Difference[]} differences */
  function offer(differences) {
    const free = session.schema.filter(({ key, type, apply }) => type !== 'seed' && key !== 'geese.population' && (apply === 'live' || !differences.some((difference) => difference.key === key)));
    const chosen = added.value;
    const groups = [...new Set(free.map(({ group }) => group))];
    added.replaceChildren(...groups.map((group) => h('optgroup', { label: group }, ...free.filter((parameter) => parameter.group === group).map(({ key, label }) => h('option', { value: key }, label)))));
    if (free.some(({ key }) => key === chosen)) added.value = chosen;
  }

  return { element, show, say: (/** @type {string} */ message) => write(problem, message) };
}

/** Another value, where there are few. @param {Parameter} parameter @param {Value} value */
function another({ type, choices }, value) {
  if (type === 'bool') return value !== true;
  return choices?.find((choice) => choice.value !== value)?.value ?? value;
}

/** @param {Parameter} parameter @param {Value} value */
const named = (parameter, value) => (parameter.type === 'text' ? abText.editor.text(String(value)) : valueName(parameter, value));
