import { wordsOf } from '../../learn/lessons.js';
import { button, h, write } from '../../ui/dom.js';
import { learnText } from '../../ui/strings.learn.en.js';

/** @import { Lesson } from '../../learn/lessons.js' */

/**
 * All lessons, in order, and which are done.
 *
 * @param {{ lessons: Lesson[], done: () => Set<string>, forget: () => void }} parts
 */
export function createLessonList({ lessons, done, forget }) {
  const unknown = h('p', { class: 'learn-unknown', role: 'alert' });
  const items = lessons.map((lesson) => {
    const mark = h('span', { class: 'learn-mark' });
    const link = h('a', { href: `#/learn/${lesson.number}` }, wordsOf(lesson).title);
    return { lesson, mark, row: h('li', {}, link, ' ', mark) };
  });
  const again = button(learnText.list.forget, () => {
    forget();
    show('');
  });
  const element = h(
    'main',
    { class: 'learn-list' },
    h('h2', {}, learnText.list.title),
    unknown,
    h('p', {}, learnText.list.about),
    h('ol', { class: 'learn-lessons' }, ...items.map(({ row }) => row)),
    h('p', { class: 'learn-teachers' }, learnText.list.teachers, ' ', h('a', { href: '#/learn/worksheet' }, learnText.list.worksheet), ' ', h('a', { href: '#/learn/answers' }, learnText.list.answers)),
    again,
  );

  /** @param {string} asked a lesson that does not exist; empty when none was asked for */
  function show(asked) {
    const known = done();
    for (const { lesson, mark } of items) write(mark, known.has(lesson.name) ? learnText.list.done : '');
    again.hidden = known.size === 0;
    write(unknown, asked ? learnText.list.unknown(asked, lessons.length) : '');
  }

  return { element, show };
}
