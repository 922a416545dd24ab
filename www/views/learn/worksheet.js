import { wordsOf } from '../../learn/lessons.js';
import { button, h, write } from '../../ui/dom.js';
import { learnText } from '../../ui/strings.learn.en.js';
import { tableOf } from './findings.js';

/** @import { Examiner } from '../../learn/examiner.js' */
/** @import { Lesson } from '../../learn/lessons.js' */

const TASKS = ['goal', 'plan']; // nothing to be answered before somebody has done something

/**
 * Sheets for printing, a page for each lesson: with room to write, or with what the engine answers. Both are of the same
 * lessons, and the answers are made by the engine when the sheet is opened.
 *
 * @param {{ lessons: Lesson[], examiner: () => Examiner }} parts
 */
export function createWorksheet({ lessons, examiner }) {
  const title = h('h2', {});
  const about = h('p', { class: 'secondary' });
  const pages = h('div', { class: 'sheet-pages' });
  const print = button(learnText.sheet.print, () => window.print(), { class: 'primary' });
  const element = h(
    'main',
    { class: 'worksheet', hidden: true },
    h('nav', { class: 'learn-top', 'aria-label': learnText.lesson.nav }, h('a', { href: '#/learn' }, learnText.lesson.all), print),
    title,
    about,
    pages,
  );
  let shown = 0;

  return {
    element,

    /** @param {'worksheet' | 'answers'} kind */
    async show(kind) {
      const mine = ++shown;
      write(title, learnText.sheet[kind]);
      write(about, learnText.sheet.about[kind]);
      const sheets = lessons.map((lesson) => {
        const room = h('div', { class: kind === 'answers' ? 'sheet-answer' : 'sheet-room' });
        return { lesson, room, page: pageOf(lesson, room, kind) };
      });
      pages.replaceChildren(...sheets.map(({ page }) => page));
      if (kind === 'worksheet') return;
      const engine = examiner();
      try {
        for (const { lesson, room } of sheets) {
          if (TASKS.includes(lesson.check.kind)) {
            write(room, learnText.sheet.task(lesson.check));
            continue;
          }
          write(room, learnText.lesson.running);
          const finding = await engine.examine(lesson, () => Promise.reject(new Error(learnText.noWorld)));
          if (mine !== shown || element.hidden) return;
          room.replaceChildren(tableOf(lesson, finding));
        }
        element.dataset.answered = 'true';
      } catch (error) {
        write(about, learnText.lesson.failed(error instanceof Error ? error.message : String(error)));
      } finally {
        engine.end();
      }
    },
  };
}

/** @param {Lesson} lesson @param {HTMLElement} room @param {'worksheet' | 'answers'} kind */
function pageOf(lesson, room, kind) {
  const words = wordsOf(lesson);
  const options = Object.values(words.options);
  return h(
    'section',
    { class: 'sheet-page' },
    h('h3', {}, learnText.sheet.heading(lesson.number, words.title)),
    kind === 'worksheet' ? h('p', { class: 'sheet-name' }, learnText.sheet.name) : null,
    ...words.body.map((paragraph) => h('p', {}, paragraph)),
    h('p', { class: 'sheet-ask' }, words.ask),
    options.length > 0 ? h('ul', { class: 'sheet-options' }, ...options.map((option) => h('li', {}, option))) : null,
    room,
    h('p', { class: 'secondary sheet-link' }, new URL(`#/learn/${lesson.number}`, location.href).href),
  );
}
