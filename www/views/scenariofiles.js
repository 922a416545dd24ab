import { h } from '../ui/dom.js';
import { filesText } from '../ui/strings.files.en.js';

const LARGEST = 10_000_000;

/**
 * Scenarios and what else a tab keeps in files: chosen, or dropped on the page.
 *
 * @param {{ element: HTMLElement, id: string, open: (name: string, json: string) => Promise<void>, say: (message: string, kind?: 'note' | 'problem') => void }} parts
 *   `element` is the tab, `id` the field's
 */
export function createScenarioFiles({ element, id, open, say }) {
  const input = h('input', { type: 'file', accept: '.json,application/json', hidden: true, id, tabindex: -1 });
  element.append(input);
  input.addEventListener('change', () => {
    const file = input.files?.[0];
    input.value = ''; // the same file may be chosen again
    if (file) void read(file);
  });
  const holds = (/** @type {DragEvent} */ event) => !element.hidden && (event.dataTransfer?.types.includes('Files') ?? false);
  document.addEventListener('dragover', (event) => {
    if (holds(event)) event.preventDefault();
  });
  document.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    if (!holds(event) || !file) return;
    event.preventDefault();
    void read(file);
  });

  /** @param {File} file */
  async function read(file) {
    if (file.size > LARGEST) say(filesText.tooLarge(file.name, file.size), 'problem');
    else await open(file.name, await file.text());
  }

  return { choose: () => input.click() };
}
