import { wordsOf } from '../../learn/lessons.js';
import { button, h, write } from '../../ui/dom.js';
import { learnText } from '../../ui/strings.learn.en.js';
import { createFindings } from './findings.js';

/** @import { Lesson } from '../../learn/lessons.js' */
/** @import { Finding } from '../../learn/examiner.js' */

/**
 * A lesson: its words, its question, and what the engine found. Skipping, starting anew and all controls are always there.
 *
 * @param {{ lessons: Lesson[], live: HTMLElement, examine: (lesson: Lesson) => Promise<Finding>, solved: (lesson: Lesson) => void,
 *   restart: () => void, controls: () => void }} parts `controls` shows all controls, or the lesson's again
 */
export function createLesson({ lessons, live, examine, solved, restart, controls }) {
  const place = h('p', { class: 'learn-place' });
  const title = h('h2', { tabindex: -1 });
  const body = h('div', { class: 'learn-body' });
  const choices = h('div', { class: 'learn-choices' });
  const legend = h('legend', {});
  const ask = h('button', { type: 'submit', class: 'primary', id: 'learn-ask' });
  const waiting = h('p', { class: 'learn-progress', 'aria-hidden': 'true' });
  const form = h('form', { class: 'learn-question' }, h('fieldset', {}, legend, choices), h('div', { class: 'row' }, ask), waiting);
  const findings = createFindings();
  const skip = h('a', { class: 'learn-next', id: 'learn-next' });
  const all = button(learnText.lesson.controls, controls, { class: 'learn-controls' });
  all.setAttribute('aria-pressed', 'false');
  const element = h(
    'section',
    { class: 'lesson', 'aria-label': learnText.lesson.region, hidden: true },
    h('nav', { class: 'learn-top', 'aria-label': learnText.lesson.nav }, h('a', { href: '#/learn' }, learnText.lesson.all), place),
    title,
    body,
    form,
    findings.element,
    h('div', { class: 'learn-ways' }, button(learnText.lesson.restart, restart), all, skip),
  );
  /** @type {Lesson} */
  let lesson = lessons[0];
  let asking = 0;

  form.addEventListener('submit', (event) => {
    event.preventDefault();
    void answer();
  });

  async function answer() {
    const mine = ++asking;
    const options = Object.keys(wordsOf(lesson).options);
    const picked = choices.querySelector('input:checked');
    const choice = picked instanceof HTMLInputElement ? picked.value : '';
    if (options.length > 0 && choice === '') {
      findings.say(learnText.lesson.choose);
      write(live, learnText.lesson.choose);
      return;
    }
    ask.disabled = true;
    write(live, learnText.lesson.running);
    try {
      const finding = await examine(lesson);
      if (mine !== asking) return;
      const row = options.length > 0 ? finding.rows.find(({ option }) => option === choice) : finding.rows[0];
      const right = row?.right === true;
      if (right) solved(lesson);
      findings.show(lesson, finding, choice);
      write(live, findings.verdict());
      write(skip, nextText(right));
    } catch (error) {
      if (mine === asking) findings.say(learnText.lesson.failed(error instanceof Error ? error.message : String(error)));
    } finally {
      if (mine === asking) {
        ask.disabled = false;
        write(waiting, '');
      }
    }
  }

  /** @param {boolean} right */
  function nextText(right) {
    if (lesson.number === lessons.length) return learnText.lesson.last;
    return right ? learnText.lesson.next : learnText.lesson.skip;
  }

  return {
    element,

    /** @param {Lesson} next */
    show(next) {
      asking += 1;
      lesson = next;
      const words = wordsOf(lesson);
      write(place, learnText.lesson.place(lesson.number, lessons.length));
      write(title, words.title);
      body.replaceChildren(...words.body.map((paragraph) => h('p', {}, paragraph)));
      write(legend, words.ask);
      const options = Object.entries(words.options);
      choices.replaceChildren(
        ...options.map(([name, label]) => {
          const input = h('input', { type: 'radio', name: 'learn-option', value: name, id: `learn-option-${name}` });
          return h('label', { class: 'check', for: input.id }, input, label);
        }),
      );
      write(ask, options.length > 0 ? learnText.lesson.ask : learnText.lesson.check);
      ask.disabled = false;
      write(waiting, '');
      findings.clear();
      skip.href = lesson.number < lessons.length ? `#/learn/${lesson.number + 1}` : '#/learn';
      write(skip, nextText(false));
      element.scrollTop = 0;
      scrollTo(0, 0);
      title.focus({ preventScroll: true });
    },

    /** @param {boolean} shown whether all controls are */
    controls: (shown) => all.setAttribute('aria-pressed', String(shown)),

    /** @param {number} now @param {number} of */
    progress(now, of) {
      if (ask.disabled) write(waiting, learnText.lesson.progress(now, of));
    },
  };
}
