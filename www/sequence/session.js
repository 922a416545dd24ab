import { EngineError } from '../engine.js';
import { fieldOf } from '../link.js';
import { olderVersion } from '../pagekeys.js';
import { messageOf } from '../session.js';
import { sequenceText } from '../ui/strings.sequence.en.js';
import { text } from '../ui/strings.en.js';
import { frozen } from './edit.js';
import { readSequenceLink, writeSequenceLink } from './link.js';

/** @import { Engine } from '../engine.js' */
/** @import { Address } from '../router.js' */
/** @import { Parameter, Value } from '../types.js' */
/** @import { Preset } from './library.js' */
/** @import { Say } from '../ui/notices.js' */
/** @import { Planner } from './planner.js' */
/** @import { Playback } from './playback.js' */
/** @import { Path, Scenario } from './types.js' */

const MOST_STATES = 200;
const UNLISTED = ['obstacles', 'obstacle-list', 'start-list'];

/** @typedef {{ scenario: Scenario, preset: string, hand: string | null }} Standing what can be undone */

/**
 * The scenario on screen, the plan made by hand if there is one, and everything that changes them.
 *
 * @param {{ engine: Pick<Engine, 'request'>, planner: Planner, playback: Playback, address: Address, schema: Parameter[], version: string,
 *   presets: Preset[], say: Say }} parts
 */
export function createSequenceSession({ engine, planner, playback, address, schema, version, presets, say }) {
  /** @type {Record<'change' | 'path' | 'link', (() => void)[]>} */
  const listeners = { change: [], path: [], link: [] };
  /** @type {Map<string, Scenario>} presets with every field */
  const bases = new Map();
  /** @type {Standing[]} */
  let past = [];
  /** @type {Standing[]} */
  let future = [];
  /** @type {Path | null} what the plan made by hand leads through */
  let handPath = null;
  let asked = 0;
  let writing = 0;
  let push = false;

  const session = {
    schema,
    version,
    presets,
    preset: presets[0].name,
    /** @type {Scenario} what is in force, every field present */
    scenario: { world: 'sequencing', seed: 0, prefix: '' },
    /** @type {Scenario} the preset's */
    base: { world: 'sequencing', seed: 0 },
    /** @type {string | null} letters of the plan made by hand */
    hand: null,
    /** What is wrong with the placement on screen; empty when nothing. */
    refusal: '',
    /** In A | B, in what the two differ; null when the map stands alone. @type {string | null} */
    beside: null,

    /** @param {'change' | 'path' | 'link'} name `link` when one was opened, which says what is beside @param {() => void} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /** @param {string} key @returns {any} */
    value: (key) => session.scenario[fieldOf(key)],
    /** @param {string} key @returns {any} */
    original: (key) => session.base[fieldOf(key)],

    /** Two searches beside, or none any more. @param {string | null} pair in what they differ */
    compare(pair) {
      if (pair === session.beside) return;
      session.beside = pair;
      void session.writeAddress();
    },

    canUndo: () => past.length > 0,
    canRedo: () => future.length > 0,

    /** The path on screen: the one made by hand, else the planner's. */
    path: () => (session.hand === null ? planner.found : handPath),

    /** The present scenario with its layout in lists. */
    frozen: () => (planner.task ? frozen(session.scenario, planner.task) : session.scenario),

    /** @param {Parameter} parameter @param {Value | unknown[]} value */
    change(parameter, value) {
      const field = fieldOf(parameter.key);
      if (JSON.stringify(value) === JSON.stringify(session.scenario[field])) return Promise.resolve(true);
      return session.commit({ ...session.scenario, [field]: value }, (why) => text.value.refused(parameter.label, why));
    },

    /**
     * Plans for a placement that may not be the last: first a plan, then better ones, whatever method is set.
     *
     * @param {Scenario} scenario
     */
    async preview(scenario) {
      performance.mark('placement asked');
      const refusal = await planner.open(scenario.method === 'approximate' ? scenario : { ...scenario, method: 'both-sides' });
      session.refusal = refusal;
      tell('change');
      return refusal;
    },

    /**
     * Takes a scenario in place of the present one; when it is refused, everything stays as it was.
     *
     * @param {Scenario} scenario
     * @param {(why: string) => string} [refused]
     */
    commit: (scenario, refused = sequenceText.refused) => take({ scenario, preset: session.preset, hand: null }, refused, true),

    /** Drops a placement that is refused. */
    async back() {
      session.refusal = '';
      if (JSON.stringify(planner.scenario) !== JSON.stringify(session.scenario)) await planner.open(session.scenario);
      tell('change');
    },

    undo: () => turn(past, future),
    redo: () => turn(future, past),

    /** @param {string} name */
    async choosePreset(name) {
      push = true;
      await take({ scenario: await completed(name), preset: name, hand: null }, sequenceText.refused, true);
    },

    /** Another layout, and nothing of the one drawn by hand. @param {number} seed */
    newLayout(seed) {
      const fields = Object.fromEntries(UNLISTED.map((field) => [field, session.base[field]]));
      return session.commit({ ...session.scenario, ...fields, seed });
    },

    /** A plan made by hand, or the planner's again when null. @param {string | null} letters */
    async byHand(letters) {
      remember();
      session.hand = letters;
      await showHand();
      void session.writeAddress();
    },

    /** Fixes the beginning of the plan and plans the rest. @param {string} letters */
    lock: (letters) => session.commit({ ...session.scenario, prefix: letters }),

    /** @param {string} hash */
    async openLink(hash) {
      const link = await readSequenceLink(hash, schema, presets.map(({ name }) => name));
      const scenario = { ...(await completed(link.preset)) };
      session.beside = link.beside;
      for (const [key, value] of link.values) scenario[fieldOf(key)] = value;
      const opened = await take({ scenario, preset: link.preset, hand: link.plan }, sequenceText.refused, planner.task !== null);
      if (!opened && !planner.task) await take({ scenario: await completed(link.preset), preset: link.preset, hand: null }, sequenceText.refused, false);
      for (const problem of link.problems) say(problem, 'problem');
      if (link.version && link.version !== version) say(text.link.version(link.version, version), 'problem', olderVersion(link.version, text.link.older(link.version)));
      playback.seek(link.step);
      tell('link');
    },

    /** Takes a scenario from a file. @param {string} name @param {string} json */
    async openFile(name, json) {
      try {
        const written = JSON.parse(json);
        const scenario = written?.plan?.scenario ?? written;
        const complete = (await engine.request('complete', { scenario: JSON.stringify(scenario) })).scenario;
        if (complete.world !== 'sequencing') throw new Error(sequenceText.otherWorld(complete.world));
        const preset = presets.find(({ title }) => title === complete.title)?.name ?? session.preset;
        push = true;
        if (await take({ scenario: complete, preset, hand: null }, (why) => sequenceText.fileRefused(name, why), true)) say(sequenceText.opened(name));
      } catch (error) {
        say(sequenceText.fileRefused(name, messageOf(error)), 'problem');
      }
    },

    link: () => writeSequenceLink({ version, preset: session.preset, base: session.base, scenario: session.scenario, schema, plan: session.hand, beside: session.beside, step: playback.step }),

    /** The whole address to be given away. */
    href: async () => address.href(await session.link()),

    async writeAddress() {
      const ticket = ++writing;
      const hash = await session.link();
      if (ticket !== writing) return;
      address.write(hash, push);
      push = false;
    },

    /** Plans again with an engine that knows nothing. */
    reload: () => planner.open(session.scenario),
  };

  /** @param {'change' | 'path' | 'link'} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  /** @returns {Standing} */
  const standing = () => ({ scenario: session.scenario, preset: session.preset, hand: session.hand });

  function remember() {
    past.push(standing());
    past = past.slice(-MOST_STATES);
    future = [];
  }

  /** @param {string} name @returns {Promise<Scenario>} */
  async function completed(name) {
    const known = bases.get(name);
    if (known) return known;
    const preset = presets.find((candidate) => candidate.name === name) ?? presets[0];
    const { scenario } = await engine.request('complete', { scenario: preset.json });
    bases.set(name, scenario);
    return scenario;
  }

  /**
   * @param {Standing} next
   * @param {(why: string) => string} refused
   * @param {boolean} undoable
   */
  async function take(next, refused, undoable) {
    const ticket = ++asked;
    const before = standing();
    try {
      const base = await completed(next.preset);
      const known = JSON.stringify(planner.scenario) === JSON.stringify(next.scenario) && planner.status !== 'held';
      const refusal = known ? '' : await planner.open(next.scenario);
      if (ticket !== asked) return true; // a later one counts
      session.refusal = '';
      if (refusal) {
        say(refused(sequenceText.plain(refusal)), 'problem');
        if (planner.task && JSON.stringify(planner.scenario) !== JSON.stringify(before.scenario)) await planner.open(before.scenario);
        tell('change');
        return false;
      }
      if (undoable) {
        past.push(before);
        past = past.slice(-MOST_STATES);
        future = [];
      }
      Object.assign(session, { scenario: next.scenario, preset: next.preset, base, hand: next.hand });
      await showHand();
      tell('change');
      void session.writeAddress();
      return true;
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) say(refused(messageOf(error)), 'problem');
      return false;
    }
  }

  /** @param {Standing[]} from @param {Standing[]} to */
  async function turn(from, to) {
    const next = from.pop();
    if (!next) return;
    to.push(standing());
    await take(next, sequenceText.refused, false);
  }

  /** The path of the plan made by hand. A letter that no behaviour has ends it. */
  async function showHand() {
    const letters = session.hand;
    if (letters === null) handPath = null;
    else {
      try {
        const path = await planner.follow(letters);
        if (letters !== session.hand) return;
        handPath = path;
      } catch (error) {
        if (error instanceof EngineError && error.fatal) return;
        session.hand = null;
        handPath = null;
        say(sequenceText.handRefused(letters, messageOf(error)), 'problem');
      }
    }
    tell('path');
  }

  planner.on('task', () => {
    if (session.hand !== null) void showHand();
  });
  planner.on('slice', () => {
    if (session.hand === null) tell('path');
  });

  return session;
}

/** @typedef {ReturnType<typeof createSequenceSession>} SequenceSession */
