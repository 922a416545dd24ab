import { h } from '../ui/dom.js';
import { save } from '../ui/share.js';
import { filesText } from '../ui/strings.files.en.js';
import { describe, looksLikePopulation } from './population.js';

/** @import { Engine } from '../engine.js' */
/** @import { Lens } from '../lens.js' */
/** @import { Run } from '../run.js' */
/** @import { Session } from '../session.js' */

const LARGEST = 10_000_000;

/**
 * Populations and scenarios as files: chosen, pasted or dropped on the page, and saved.
 *
 * @param {{ element: HTMLElement, engine: Pick<Engine, 'request'>, lens: Lens, run: Run, session: Session,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `element` is where files may be dropped
 */
export function createFiles({ element, engine, lens, run, session, say }) {
  const input = h('input', { type: 'file', accept: '.json,application/json', hidden: true, id: 'open-file', tabindex: -1 });
  const veil = h('p', { class: 'drop-veil', hidden: true }, filesText.drop);
  element.append(input, veil);

  input.addEventListener('change', () => {
    const file = input.files?.[0];
    input.value = ''; // the same file may be chosen again
    if (file) void read(file);
  });
  const holdsFiles = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes('Files') ?? false;
  document.addEventListener('dragover', (event) => {
    if (element.hidden || !holdsFiles(event)) return;
    event.preventDefault();
    veil.hidden = false;
  });
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  document.addEventListener('drop', (event) => {
    veil.hidden = true;
    const dropped = event.dataTransfer?.files;
    if (element.hidden || !dropped?.length) return;
    event.preventDefault();
    if (dropped.length > 1) say(filesText.many(dropped.length));
    void read(dropped[0]);
  });

  /** @param {File} file */
  async function read(file) {
    if (file.size > LARGEST) {
      say(filesText.tooLarge(file.name, file.size), 'problem');
      return;
    }
    try {
      await open(file.name, await file.text());
    } catch {
      say(filesText.unreadable(file.name), 'problem');
    }
  }

  /** @param {string} name @param {string} written @returns {Promise<boolean>} whether it was taken */
  async function open(name, written) {
    if (looksLikePopulation(written)) return openPopulation(name, written);
    const taken = await session.openScenario(written, (why) => filesText.refused(name, why));
    if (taken) say(filesText.scenarioOpened(name, String(run.scenario.title ?? '')));
    return taken;
  }

  /** @param {string} name @param {string} written */
  async function openPopulation(name, written) {
    const taken = await session.restart({ population: written }, (why) => filesText.refused(name, why));
    const found = taken && describe(written);
    if (found) say(filesText.opened(name, filesText.loaded(found.count, found)));
    return taken;
  }

  return {
    /** Asks for a file. */
    choose: () => input.click(),
    openPopulation,
    removePopulation: () => void session.restart({ population: '' }),

    /** The programs of this moment, as `run --save-population` writes them. */
    async savePopulation() {
      const side = lens.side();
      const { population } = await engine.request('population');
      if (population) save(`population-${session.preset}${side && `-${side}`}-seed${run.scenario.seed}-tick${lens.run.tick}.json`, new Blob([population], { type: 'application/json' }));
    },
  };
}

/** @typedef {ReturnType<typeof createFiles>} Files */
