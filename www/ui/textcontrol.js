import { button, h } from './dom.js';
import { text } from './strings.en.js';
import { recall, remember } from './storage.js';

/** @import { Parameter } from '../types.js' */
/** @import { Field, Wiring } from './control.js' */

/**
 * An editor for a long text such as the grammar: line numbers, Apply, and the place of an error marked. What was typed
 * and not applied is kept and offered again.
 *
 * @param {Parameter} parameter
 * @param {string} id
 * @param {Wiring} wiring
 * @param {(message: string) => void} say
 * @returns {Field}
 */
export function createTextControl(parameter, id, { change, check, inFull }, say) {
  const area = h('textarea', { id, rows: 12, wrap: 'off', spellcheck: 'false', autocapitalize: 'off', 'aria-describedby': `${id}-error` });
  const gutter = h('ol', { class: 'gutter', 'aria-hidden': 'true' });
  const mark = h('div', { class: 'line-mark', hidden: true });
  const draft = `draft.${parameter.key}`;
  let shown = '';
  /** @type {import('../types.js').Value} the value that is shown, perhaps in full */
  let stated = '';

  const apply = button(text.controls.apply, () => void applyText());
  const restore = button(text.controls.restoreDraft, () => {
    area.value = recall(draft) ?? area.value;
    edited();
    restore.hidden = true;
  });
  const body = h('div', { class: 'editor' }, h('div', { class: 'lines' }, gutter, mark, area), h('div', { class: 'row' }, apply, restore));

  async function applyText() {
    const value = area.value;
    const problem = await check(parameter, value);
    showProblem(problem);
    if (problem) return;
    shown = value;
    stated = value;
    remember(draft, null);
    change(parameter, value);
  }

  /** @param {string} message */
  function showProblem(message) {
    say(message);
    area.toggleAttribute('aria-invalid', message !== '');
    const place = /line (\d+)(?:, column (\d+))?/.exec(message);
    mark.hidden = !place;
    for (const line of gutter.children) line.classList.remove('bad');
    if (!place) return;
    area.setAttribute('aria-invalid', 'true');
    const line = Number(place[1]);
    gutter.children[line - 1]?.classList.add('bad');
    const start = area.value.split('\n').slice(0, line - 1).reduce((sum, row) => sum + row.length + 1, 0);
    area.focus();
    area.setSelectionRange(start + Number(place[2] ?? 1) - 1, start + (area.value.split('\n')[line - 1]?.length ?? 0));
    mark.style.setProperty('--line', String(line - 1));
    const lineHeight = Number.parseFloat(getComputedStyle(area).lineHeight);
    area.scrollTop = Math.max(0, (line - 4) * lineHeight);
    follow();
    area.closest('.control')?.querySelector('.field-error')?.scrollIntoView({ block: 'nearest' });
  }

  function number() {
    const lines = area.value.split('\n').length;
    while (gutter.children.length < lines) gutter.append(h('li', {}, gutter.children.length + 1));
    while (gutter.children.length > lines) gutter.lastElementChild?.remove();
  }

  function follow() {
    gutter.style.transform = `translateY(${-area.scrollTop}px)`;
    mark.style.setProperty('--scroll', `${area.scrollTop}px`);
  }

  function edited() {
    number();
    const different = area.value !== shown;
    remember(draft, different ? area.value : null);
    apply.disabled = !different;
  }

  area.addEventListener('scroll', follow);
  area.addEventListener('input', () => {
    if (!mark.hidden) showProblemGone();
    edited();
  });
  area.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') apply.focus(); // a way out for the keyboard
  });

  function showProblemGone() {
    mark.hidden = true;
    say('');
    area.removeAttribute('aria-invalid');
    for (const line of gutter.children) line.classList.remove('bad');
  }

  return {
    label: h('label', { for: id }, parameter.label),
    aside: h('span'),
    body,
    async show(value) {
      const full = await inFull(parameter, value);
      if (value === stated && full === shown && area.value !== '') return; // what is being typed stays
      stated = value;
      shown = full;
      area.value = shown;
      number();
      showProblemGone();
      apply.disabled = true;
      const kept = recall(draft);
      restore.hidden = kept === null || kept === shown;
    },
  };
}
