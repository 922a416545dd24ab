import { describe } from '../files/population.js';
import { button, h, write } from './dom.js';
import { filesText } from './strings.files.en.js';

/** @import { Files } from '../files/files.js' */
/** @import { Field } from './control.js' */

/**
 * The population a run starts with: what it is, and the ways to another one. Its text is far too long to be shown.
 *
 * @param {string} label
 * @param {string} id
 * @param {Files} files
 * @returns {Field}
 */
export function createPopulationControl(label, id, files) {
  const said = h('p', { class: 'help population-said' });
  const remove = button(filesText.remove, files.removePopulation);
  const area = h('textarea', { id, rows: 4, spellcheck: 'false', autocapitalize: 'off', 'aria-label': filesText.paste });
  const take = button(filesText.pasted, () => void openPasted());
  const paste = h('details', { class: 'paste' }, h('summary', {}, filesText.paste), area, h('div', { class: 'row' }, take));
  const save = button(filesText.populationSave, () => void files.savePopulation().catch(() => {}), { title: filesText.populationSaveLong });
  const body = h('div', { class: 'population' }, said, h('div', { class: 'row' }, button(filesText.populationOpen, files.choose), save, remove), paste);

  async function openPasted() {
    if (await files.openPopulation(filesText.pastedName, area.value)) area.value = '';
  }

  return {
    label: h('span', { class: 'control-name' }, label),
    aside: h('span'),
    body,
    show(value) {
      const written = String(value);
      const found = written.trim() === '' ? null : describe(written);
      write(said, found ? filesText.loaded(found.count, found) : filesText.none);
      remove.hidden = found === null;
    },
  };
}
