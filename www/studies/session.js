import { studiesText as text } from '../ui/strings.studies.en.js';
import { text as page } from '../ui/strings.en.js';
import { olderVersion } from '../pagekeys.js';
import { messageOf } from '../session.js';
import { at, changed, written } from './draft.js';
import { readStudyLink, writeStudyLink, LIST } from './link.js';

/** @import { Engine } from '../engine.js' */
/** @import { Say } from '../ui/notices.js' */
/** @import { Address } from '../router.js' */
/** @import { Path } from './draft.js' */
/** @import { StudyFile } from './library.js' */
/** @import { StudyRun } from './run.js' */
/** @import { Fault, MetricWords, Outline, Size } from './types.js' */
/** @import { Parameter } from '../types.js' */

const TYPING_MS = 200;
const MOST_RUNS = 100_000; // more than a page can hold at once

/** @typedef {{ name: string, outline: Outline }} Listed a study file with what it says */

/**
 * What is open: the list, or a study as text, with what the engine says of it. A text with a fault changes nothing but
 * itself: the last valid study stays what is run and reported.
 *
 * @param {{ desk: Engine, run: StudyRun, address: Address, files: StudyFile[], version: string, schema: Parameter[], metrics: MetricWords[],
 *   say: Say }} parts
 */
export function createStudySession({ desk, run, address, files, version, schema, metrics, say }) {
  /** @type {(() => void)[]} */
  const listeners = [];
  /** @type {Promise<Listed[]> | null} */
  let listing = null;
  let checking = 0;
  let writing = 0;
  let valid = ''; // the text of the study that is run
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let typing;

  /** Whether something is of the study's world; while nothing was valid yet, everything is. @param {string} world */
  const ours = (world) => session.outline === null || session.outline.world === world;

  const session = {
    version,
    schema,
    /** The parameters of the study's world. */
    parameters: () => schema.filter(({ key }) => !key.includes('.') || ours(key.slice(0, key.indexOf('.')))),
    /** The metrics of the study's world. */
    metrics: () => metrics.filter(({ world }) => ours(world)),
    /** Whether the list is on screen. */
    list: true,
    /** @type {string | null} the study file that the text began as */
    name: null,
    text: '',
    /** @type {any} the text as a value; null while it is no JSON */
    draft: null,
    /** @type {Fault | null} */
    fault: null,
    /** @type {Outline | null} of the last valid text */
    outline: null,
    /** @type {Size} */
    size: 'glance',
    /** Whether this size has more runs than a page can hold. */
    tooMany: false,

    /** @param {() => void} listener */
    on: (listener) => void listeners.push(listener),

    /** Whether the text is the study file's own. */
    pristine: () => session.name !== null && session.text === files.find(({ name }) => name === session.name)?.json,

    /** Every study file with its outline. */
    listed() {
      listing ??= Promise.all(files.map(async ({ name, json }) => ({ name, outline: (await desk.request('check', { spec: json })).outline })));
      return listing;
    },

    /** A text from elsewhere takes the place of the present one. @param {string} json @param {string} title */
    async openText(json, title) {
      if (await open(null, json, null, true)) say(text.said.opened(title));
    },

    /** The text is another. @param {string} json */
    edit(json) {
      if (json === session.text) return;
      session.text = json;
      session.draft = parsed(json);
      clearTimeout(typing);
      typing = setTimeout(() => void check(), TYPING_MS);
      tell();
    },

    /** A value of the study is another; `undefined` takes its field away. @param {Path} path @param {any} value */
    change(path, value) {
      if (session.draft === null || at(session.draft, path) === value) return;
      session.replace(changed(session.draft, path, value));
    },

    /** The whole study is another. @param {any} draft */
    replace(draft) {
      session.draft = draft;
      session.text = written(draft);
      clearTimeout(typing);
      void check();
      tell();
    },

    /** @param {Size} size */
    async resize(size) {
      session.size = size;
      if (valid !== '') await take();
      tell();
      await write(false);
    },

    /** What a link says: the list, a study file, or a study in the link itself. @param {string} hash */
    async openLink(hash) {
      const link = await readStudyLink(hash, files.map(({ name }) => name));
      for (const problem of link.problems) say(problem, 'problem');
      if (link.version && link.version !== version) say(page.link.version(link.version, version), 'problem', olderVersion(link.version, page.link.older(link.version)));
      if (link.spec !== null) await open(null, link.spec, link.size, false);
      else if (link.name !== null) await open(link.name, files.find(({ name }) => name === link.name)?.json ?? '', link.size, false);
      else showList();
    },

    link: () => writeStudyLink({ version, name: session.pristine() ? session.name : null, spec: session.text, size: session.size }),
    /** The whole address to be given away. */
    href: async () => address.href(await session.link()),

    /** Reads the text again; for a desk that was started anew. */
    async reload() {
      listing = null;
      if (session.list) tell();
      else await check();
    },
  };

  function tell() {
    for (const listener of listeners) listener();
  }

  function showList() {
    run.pause();
    session.list = true;
    address.write(LIST);
    tell();
  }

  /**
   * @param {string | null} name
   * @param {string} json
   * @param {Size | null} size
   * @param {boolean} push whether the address becomes a new entry of the history
   * @returns {Promise<boolean>} whether it is a study
   */
  async function open(name, json, size, push) {
    clearTimeout(typing);
    if (size) session.size = size;
    session.list = false;
    session.name = name;
    session.text = json;
    session.draft = parsed(json);
    session.fault = null;
    session.outline = null;
    valid = '';
    await check(push);
    return session.fault === null;
  }

  /** Asks whether the text is a study, and takes it when it is. @param {boolean} [push] */
  async function check(push = false) {
    const mine = (checking += 1);
    const spec = session.text;
    const { outline, fault } = await desk.request('check', { spec });
    if (mine !== checking || session.list) return;
    session.fault = fault ?? null;
    if (!outline && valid === '') run.close(); // what was open before is another study
    if (outline) {
      session.outline = outline;
      valid = spec;
      if (!session.outline?.sizes.some(({ size }) => size === session.size)) session.size = 'paper';
      await take();
    }
    tell();
    await write(push);
  }

  async function take() {
    session.tooMany = (session.outline?.sizes.find(({ size }) => size === session.size)?.runs ?? 0) > MOST_RUNS;
    if (session.tooMany) {
      run.close();
      return;
    }
    try {
      await run.open(valid, session.size);
    } catch (error) {
      say(messageOf(error), 'problem');
    }
  }

  /** @param {boolean} push */
  async function write(push) {
    const mine = (writing += 1);
    const hash = await session.link();
    if (mine === writing && !session.list) address.write(hash, push);
  }

  /** @param {string} json */
  function parsed(json) {
    try {
      const value = JSON.parse(json);
      return value !== null && typeof value === 'object' && !Array.isArray(value) ? value : null;
    } catch {
      return null;
    }
  }

  return session;
}

/** @typedef {ReturnType<typeof createStudySession>} StudySession */
