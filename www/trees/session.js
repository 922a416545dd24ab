import { redo, redoDepth, undo, undoDepth } from '@codemirror/commands';
import { text } from '../ui/strings.en.js';
import { benchText } from '../ui/strings.trees.en.js';
import { EngineError } from '../engine.js';
import { olderVersion } from '../pagekeys.js';
import { messageOf } from '../session.js';
import { createDrafts } from './drafts.js';
import { readSetup, readTreeLink, writeTreeLink } from './link.js';
import { written } from './script.js';
import { PLAIN, changeRest, replaceSetup, restChanged, restOf } from './setup.js';

/** @import { EditorView, ViewUpdate } from '@codemirror/view' */
/** @import { Address } from '../router.js' */
/** @import { Say } from '../ui/notices.js' */
/** @import { Draft } from './drafts.js' */
/** @import { Entry } from './library.js' */
/** @import { Spot, TreeLink } from './link.js' */
/** @import { TreeRun } from './run.js' */
/** @import { Rest } from './setup.js' */
/** @import { Problem } from './types.js' */

const TYPING_MS = 120;
const KEEPING_MS = 400;

/** @typedef {{ xml: string, rest: Rest, length: number, at: number, draft?: string, compare?: Spot | null }} Opening a tree that takes the place of the present one;
 *   `compare` is what a link says of the comparison, undefined where it does not */

/**
 * What is on the bench: text, script, mode and time as the editor's state holds them, the library entry they began as,
 * and everything that follows from a change of them.
 *
 * @param {{ run: TreeRun, address: Address, version: string, library: Entry[], view: EditorView, compared: () => Spot | null,
 *   say: Say }} parts `compared` is where the sequence or fallback stands whose kinds are compared
 */
export function createTreeSession({ run, address, version, library, view, compared, say }) {
  const drafts = createDrafts();
  /** @type {{ change: (() => void)[], entry: ((compare: Spot | null, asked: boolean) => void)[] }} */
  const listeners = { change: [], entry: [] };
  /** @type {Map<string, string>} texts of library entries by name */
  const texts = new Map();
  let valid = ''; // the text whose tree runs
  let faulty = ''; // the text that was refused last
  let ran = ''; // what decided the run beside the text
  let replacing = false;
  let writing = 0;
  let push = false;
  let fresh = true; // nothing to go back to yet
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let typing;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let keeping;

  const session = {
    version,
    library,
    /** @type {Problem[]} of the text on screen */
    problems: [],
    /** Whether the drawing shows the last valid tree instead of the text's. */
    stale: false,
    /** Whether another tree takes the place of the present one, rather than an edit of it. */
    opening: false,
    drafts: drafts.others,

    /** @param {'change'} name @param {() => void} listener */
    on: (name, listener) => void listeners[name].push(listener),
    /** @param {(compare: Spot | null, asked: boolean) => void} listener told when another tree was opened and computed: what is to be compared, and whether a link asked for it */
    onOpened: (listener) => void listeners.entry.push(listener),

    rest: () => restOf(view.state),
    /** What an edit starts from and a link writes. */
    setup: () => ({ xml: view.state.doc.toString(), ...restOf(view.state) }),
    /** What runs: the last valid text. */
    running: () => ({ ...session.setup(), xml: valid }),
    /** The library entry that the present tree began as. */
    entry: () => library.find(({ name }) => name === restOf(view.state).entry) ?? null,

    /** Whether the text is the library entry's own. */
    pristine: () => view.state.doc.toString() === texts.get(restOf(view.state).entry ?? ''),

    /** Changes script, mode or time. @param {Partial<Rest>} changes */
    change: (changes) => changeRest(view, changes),
    undo: () => void undo(view),
    redo: () => void redo(view),
    canUndo: () => undoDepth(view.state) > 0,
    canRedo: () => redoDepth(view.state) > 0,

    /** The state of the editor changed. @param {ViewUpdate} update */
    edited(update) {
      const rest = restChanged(update.startState, update.state);
      if ((!update.docChanged && !rest) || replacing) return;
      const another = otherTree(restOf(update.startState), restOf(update.state)); // undo and redo go from tree to tree too
      if (another) drafts.begin();
      clearTimeout(typing);
      if (rest) void changed(another);
      else typing = setTimeout(() => void changed(false), TYPING_MS);
      clearTimeout(keeping);
      keeping = setTimeout(keep, KEEPING_MS);
      tell();
    },

    /** Takes a library entry as it is. @param {string} name */
    async openEntry(name) {
      const entry = library.find((candidate) => candidate.name === name) ?? library[0];
      await open(await opening(entry), true);
    },

    /** A text from elsewhere. @param {string} xml @param {string} title */
    async openText(xml, title) {
      await open({ xml, rest: { ...PLAIN, title }, length: 0, at: 0 }, true);
      say(benchText.opened(title));
    },

    /** A file of the visitor's: XML, or a setup as JSON. @param {string} name @param {string} content */
    async openFile(name, content) {
      if (!/^\s*\{/.test(content)) {
        await session.openText(content, name);
        return;
      }
      try {
        const { xml, script, mode, ms, length, at } = readSetup(content);
        await open({ xml, rest: { entry: null, title: name, script, mode, ms }, length, at }, true);
        say(benchText.opened(name));
      } catch (error) {
        say(benchText.fileRefused(name, messageOf(error)), 'problem');
      }
    },

    /** Takes up again what was typed. @param {Draft} draft */
    async restore({ id, xml, length, at, ...rest }) {
      const entry = library.find(({ name }) => name === rest.entry);
      if (entry) await textOf(entry);
      await open({ xml, rest: { entry: entry ? rest.entry : null, title: rest.title, script: rest.script, mode: rest.mode, ms: rest.ms }, length, at, draft: id }, true);
    },

    /** Opens a link as far as it can be read, runs to its tick and compares the fingerprint. @param {string} hash */
    async openLink(hash) {
      const link = await readTreeLink(hash, library);
      await open(await fromLink(link), false);
      for (const problem of link.problems) say(problem, 'problem');
      if (link.version && link.version !== version) say(text.link.version(link.version, version), 'problem', olderVersion(link.version, text.link.older(link.version)));
      if (link.tick !== null && run.moment) say(...verdict(link));
    },

    refresh,

    /** Computes anew with an engine that knows nothing of what was valid. @param {{ length: number, at: number }} position */
    async reload(position) {
      const { script, mode, ms } = session.setup();
      try {
        await run.open({ xml: valid, script, mode, ms, ...position });
        if (session.stale) await refresh(); // its problems
      } catch {
        // it broke again; the tab says so
      }
    },

    /** Address of the moment on screen, as a hash. */
    link() {
      const entry = session.entry();
      const { xml, script, mode, ms } = session.setup();
      const base = entry && texts.has(entry.name) ? { ...entry, xml: /** @type {string} */ (texts.get(entry.name)) } : null;
      const fingerprint = session.stale ? '' : (run.moment?.fingerprint ?? '');
      const compare = session.stale || session.opening ? usual() : compared(); // a text with faults has no places to compare
      return writeTreeLink({ version, entry: base, setup: { xml, script, mode, ms, length: run.length }, compare, usual: usual(), tick: run.tick, fingerprint });
    },

    /** The whole address to be given away. */
    href: async () => address.href(await session.link()),

    /** Writes the moment on screen into the address. */
    async writeAddress() {
      const ticket = ++writing;
      const hash = await session.link();
      if (ticket !== writing) return; // a later moment is being written
      address.write(hash, push);
      push = false;
    },
  };

  /** @param {boolean} another whether it is another tree than before */
  async function changed(another) {
    session.opening = another;
    const refusal = await refresh();
    session.opening = false;
    if (refusal) say(benchText.refused(refusal), 'problem');
  }

  function tell() {
    for (const listener of listeners.change) listener();
  }

  /** What is compared where nobody asked for anything else. */
  const usual = () => (session.pristine() ? (session.entry()?.compare ?? null) : null);

  /** @param {Entry} entry */
  async function textOf(entry) {
    const xml = texts.get(entry.name) ?? (await entry.xml()).replaceAll('\r\n', '\n');
    texts.set(entry.name, xml);
    return xml;
  }

  /** @param {Entry} entry @returns {Promise<Opening>} */
  async function opening(entry) {
    const { name, script, mode, ms, length, at } = entry;
    return { xml: await textOf(entry), rest: { entry: name, title: '', script, mode, ms }, length, at };
  }

  /** @param {TreeLink} link @returns {Promise<Opening>} */
  async function fromLink(link) {
    const entry = library.find(({ name }) => name === link.entry) ?? (link.xml === null ? library[0] : null);
    const base = entry ? await opening(entry) : { xml: link.xml ?? '', rest: PLAIN, length: 0, at: 0 };
    const length = link.length ?? base.length;
    return {
      xml: link.xml ?? base.xml,
      rest: { entry: base.rest.entry, title: '', script: link.script ?? base.rest.script, mode: link.mode ?? base.rest.mode, ms: link.ms ?? base.rest.ms },
      length,
      at: link.tick ?? Math.min(base.at, length),
      compare: link.compare,
    };
  }

  /** @param {Opening} next @param {boolean} asEntry whether it is a new entry of the browser's history */
  async function open({ xml, rest, length, at, draft, compare }, asEntry) {
    clearTimeout(keeping);
    if (!fresh) keep();
    drafts.begin(draft);
    replacing = true;
    replaceSetup(view, xml, rest, !fresh);
    replacing = false;
    fresh = false;
    push = asEntry;
    session.opening = true;
    tell();
    const refusal = await refresh({ length: Math.max(length, at), at });
    if (refusal) {
      say(benchText.scriptRefused(refusal), 'problem');
      replacing = true;
      changeRest(view, { ...PLAIN, entry: rest.entry, title: rest.title });
      replacing = false;
      await refresh({ length: 0, at: 0 });
    }
    session.opening = false;
    for (const listener of listeners.entry) listener(compare === undefined ? usual() : compare, compare !== undefined);
  }

  /**
   * The whole timeline from what is on screen now.
   *
   * @param {{ length: number, at: number }} [position]
   * @returns {Promise<string>} what the engine has against it; empty when nothing
   */
  async function refresh(position) {
    clearTimeout(typing);
    const { xml, script, mode, ms } = session.setup();
    const setup = { script, mode, ms, ...position };
    const decided = JSON.stringify(setup);
    try {
      if (xml !== faulty || !valid) await run.open({ xml, ...setup });
      if (xml === faulty && valid && decided !== ran) await run.open({ xml: valid, ...setup }); // the last valid tree follows the script
      ran = decided;
      return '';
    } catch (error) {
      return error instanceof EngineError && error.fatal ? '' : messageOf(error);
    }
  }

  run.on('opened', ({ problems, tree }, { xml }) => {
    if (faulty && xml === valid && xml !== view.state.doc.toString()) return; // the last valid tree, with another script
    session.problems = problems;
    session.stale = tree === null;
    if (tree) {
      valid = xml;
      faulty = '';
    } else faulty = xml;
    tell();
  });

  window.addEventListener('pagehide', () => {
    if (!fresh) keep();
  });

  function keep() {
    clearTimeout(keeping);
    const entry = session.entry();
    const { xml, ...rest } = session.setup();
    const asEntry = entry && xml === texts.get(entry.name) && written(rest.script) === written(entry.script) && rest.mode === entry.mode && rest.ms === entry.ms;
    drafts.keep(asEntry || xml.trim() === '' ? null : { xml, ...rest, length: run.length, at: run.tick });
  }

  /** @param {TreeLink} link @returns {[string, 'note' | 'problem']} */
  function verdict({ tick, fingerprint, version: made }) {
    const found = run.moment?.fingerprint ?? '';
    if (run.tick !== tick) return [text.link.notReached(tick ?? 0, run.tick), 'problem'];
    if (!fingerprint) return [text.link.reached(run.tick), 'note'];
    if (fingerprint === found) return [text.link.matches(run.tick, found), 'note'];
    return [text.link.differs(run.tick, fingerprint, found, made, version), 'problem'];
  }

  return session;
}

/** @param {Rest} before @param {Rest} now */
const otherTree = (before, now) => before.entry !== now.entry || before.title !== now.title;

/** @typedef {ReturnType<typeof createTreeSession>} TreeSession */
