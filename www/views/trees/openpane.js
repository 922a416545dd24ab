import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @import { Draft } from '../../trees/drafts.js' */
/** @import { Entry } from '../../trees/library.js' */

const LARGEST_MB = 8;

/**
 * Where a tree comes from: the library, what was typed before, a file.
 *
 * @param {{ library: Entry[], drafts: () => Draft[], openEntry: (name: string) => void, restore: (draft: Draft) => void,
 *   openFile: (name: string, content: string) => void, refused: (message: string) => void }} parts
 */
export function createOpenPane({ library, drafts, openEntry, restore, openFile, refused }) {
  const select = h('select', { id: 'trees-entry' });
  const file = h('input', { type: 'file', accept: '.xml,.json,text/xml,application/xml,application/json', hidden: true, tabindex: -1, 'aria-label': benchText.open.fileLong });
  const again = button(benchText.open.restore, () => drafts()[0] && restore(drafts()[0]), { class: 'restore' });
  const element = h(
    'div',
    { class: 'trees-open' },
    h('div', { class: 'row' }, h('label', { for: 'trees-entry', class: 'unseen' }, benchText.open.choose), select, button(benchText.open.file, () => file.click(), { title: benchText.open.fileLong }), file),
    again,
  );

  select.addEventListener('change', () => {
    const draft = drafts().find(({ id }) => select.value === `draft:${id}`);
    if (draft) restore(draft);
    else if (select.value.startsWith('entry:')) openEntry(select.value.slice('entry:'.length));
  });
  file.addEventListener('change', () => {
    void take(file.files?.[0]);
    file.value = '';
  });

  /** @param {File | undefined} chosen */
  async function take(chosen) {
    if (!chosen) return;
    if (chosen.size > LARGEST_MB * 1_000_000) refused(benchText.fileRefused(chosen.name, benchText.tooLarge(LARGEST_MB)));
    else openFile(chosen.name, await chosen.text());
  }

  /** @param {Draft} draft */
  function nameOf({ entry, title, xml }) {
    const known = library.find(({ name }) => name === entry)?.title;
    return benchText.open.draft(known ? benchText.open.edited(known) : title || benchText.open.own, xml.split('\n').length);
  }

  return {
    element,

    /** Takes files that are dropped on a part of the page. @param {HTMLElement} target */
    dropOn(target) {
      target.addEventListener('dragover', (event) => {
        if (!event.dataTransfer?.types.includes('Files')) return;
        event.preventDefault();
        target.classList.add('dropping');
      }, true);
      for (const type of ['dragleave', 'drop']) target.addEventListener(type, () => target.classList.remove('dropping'), true);
      target.addEventListener('drop', (event) => {
        const [dropped] = event.dataTransfer?.files ?? [];
        if (!dropped) return;
        event.preventDefault();
        event.stopPropagation(); // the editor would type the file
        void take(dropped);
      }, true);
    },

    /** @param {string | null} entry name of the library entry on screen @param {string} title of a tree of the visitor's own */
    show(entry, title) {
      const others = drafts();
      const key = JSON.stringify([entry, title, others.map(({ id, xml }) => [id, xml.length])]);
      if (select.dataset.key !== key) {
        select.dataset.key = key;
        const typed = others.map((draft) => h('option', { value: `draft:${draft.id}` }, nameOf(draft)));
        select.replaceChildren(
          ...(entry === null ? [h('option', { value: 'own' }, title || benchText.open.own)] : []),
          h('optgroup', { label: benchText.open.library }, ...library.map(({ name, title }) => h('option', { value: `entry:${name}` }, title))),
          ...(typed.length > 0 ? [h('optgroup', { label: benchText.open.drafts }, ...typed)] : []),
        );
      }
      select.value = entry === null ? 'own' : `entry:${entry}`;
      again.hidden = others.length === 0;
      if (others[0]) write(again, benchText.open.restore);
    },
  };
}
