import '../style/learn.css';
import { createExaminer } from '../learn/examiner.js';
import { readLessons, worldHash } from '../learn/lessons.js';
import { done, finish, forget } from '../learn/progress.js';
import { createState } from '../state.js';
import { learnText } from '../ui/strings.learn.en.js';
import { createLesson } from '../views/learn/lesson.js';
import { createLessonList } from '../views/learn/list.js';
import { createWorksheet } from '../views/learn/worksheet.js';

/** @import { Address, Beside, Tab } from '../router.js' */
/** @import { Lesson } from '../learn/lessons.js' */

const SHEETS = /** @type {const} */ (['worksheet', 'answers']);

/**
 * The tab Learn: a list of lessons, each beside the real tab it is about, and sheets for printing.
 *
 * @param {{ element: HTMLElement, address: Address, beside: Beside, built: () => void, live: HTMLElement }} parts
 * @returns {Tab}
 */
export function createLearn({ element, address, beside, built, live }) {
  const state = createState(element);
  const lessons = readLessons();
  /** @type {Tab | null} the tab beside the lesson */
  let guest = null;
  /** @type {Lesson | null} */
  let open = null;
  let full = false; // whether all controls are shown
  const examiner = createExaminer((now, all) => view.progress(now, all));
  const list = createLessonList({ lessons, done, forget });
  const view = createLesson({
    lessons,
    live,
    examine: (lesson) => examiner.examine(lesson, screen),
    solved: (lesson) => finish(lesson.name),
    restart: () => void (open && show(open)),
    controls() {
      full = !full;
      void beside.furnish(full || !open ? '' : `ui=${open.show.join(',') || 'none'}`);
      view.controls(full);
    },
  });
  const sheet = createWorksheet({ lessons, examiner: () => createExaminer(() => {}) });
  element.append(list.element, view.element, sheet.element);
  built();

  /** What the visitor has on screen beside the lesson. */
  async function screen() {
    if (!guest?.share) throw new Error(learnText.noWorld);
    return guest.share();
  }

  /** @param {Lesson} lesson */
  async function show(lesson) {
    examiner.end();
    open = lesson;
    full = false;
    view.show(lesson);
    view.controls(false);
    guest = null;
    const tab = await beside.open(lesson.world.tab, worldHash(lesson));
    if (open === lesson) guest = tab; // else another lesson was opened meanwhile
  }

  state.to('paused');
  return {
    state,
    actions: {},
    regions: [],
    pause: () => void examiner.end(),
    async open(hash) {
      const [, where = ''] = hash.replace(/[?].*$/, '').split('/').slice(1);
      const lesson = lessons.find(({ number }) => String(number) === where);
      const kind = SHEETS.find((name) => name === where);
      address.write(lesson || kind ? `#/learn/${where}` : '#/learn');
      list.element.hidden = lesson !== undefined || kind !== undefined;
      view.element.hidden = lesson === undefined;
      sheet.element.hidden = kind === undefined;
      if (lesson) await show(lesson);
      else {
        open = null;
        beside.close();
        if (kind) await sheet.show(kind);
        else list.show(where === '' ? '' : where);
      }
    },
  };
}
