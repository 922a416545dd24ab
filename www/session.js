import { text } from './ui/strings.en.js';
import { fieldOf, readLink, writeLink } from './link.js';
import { olderVersion } from './pagekeys.js';

/** @import { Engine } from './engine.js' */
/** @import { Run } from './run.js' */
/** @import { Address } from './router.js' */
/** @import { State } from './state.js' */
/** @import { Parameter, Scenario, Value } from './types.js' */
/** @import { LinkParts } from './link.js' */
/** @import { Say } from './ui/notices.js' */

/** @typedef {{ name: string, title: string, about: string, json: string }} Preset */

/**
 * @typedef {object} Beside the other half of A | B
 * @property {(parts: LinkParts, scenario: Scenario) => Promise<(opened: boolean) => Promise<void>>} open makes ready for what
 *   a link says of B; afterwards it is told whether the world of A was built
 * @property {(parts: LinkParts) => string} verdict at the link's tick, what is wrong with B; empty when nothing
 * @property {() => Promise<string[]>} link what B adds to the address
 */

/** The longest address a browser is asked to hold. */
const LONGEST_ADDRESS = 1_000_000;

/**
 * The scenario on screen: the preset, what differs from it, and changes that wait for a restart.
 *
 * @param {{ engine: Engine, run: Run, state: State, address: Address, beside: Beside, schema: Parameter[], version: string, presets: Preset[],
 *   say: Say }} parts
 */
export function createSession({ engine, run, state, address, beside, schema, version, presets, say }) {
  /** @type {(() => void)[]} */
  const listeners = [];
  let writing = 0;
  let links = 0;
  /** @type {Promise<unknown>} the link under way: one is opened after the other */
  let opening = Promise.resolve();
  /** Whether the next address is a new entry of the history. */
  let push = false;

  const session = {
    schema,
    version,
    presets,
    preset: presets[0].name,
    /** @type {Scenario} the preset with every field */
    base: { world: 'geese', seed: 0 },
    /** @type {Map<string, Value>} values on screen that need a restart */
    pending: new Map(),

    /** @param {() => void} listener */
    on: (listener) => void listeners.push(listener),

    /**
     * The value on screen: one that waits for a restart, else the one in force at this tick.
     *
     * @param {string} key
     * @returns {Value}
     */
    value: (key) => session.pending.get(key) ?? inForce(key),

    /** The preset's value. @param {string} key @returns {Value} */
    original: (key) => session.base[fieldOf(key)],

    /**
     * Changes a value: at once where the world allows it, else at the next restart.
     *
     * @param {Parameter} parameter
     * @param {Value} value
     */
    async change(parameter, value) {
      const { key } = parameter;
      if (parameter.apply === 'live') {
        if (value === inForce(key)) return;
        const later = (run.scenario.events ?? []).some((event) => event.tick > run.tick);
        try {
          await run.change(key, value);
          if (later) say(text.events.cut(run.tick));
        } catch (error) {
          say(text.value.refused(parameter.label, messageOf(error)), 'problem');
        }
      } else if (value === inForce(key)) session.pending.delete(key);
      else session.pending.set(key, value);
      tell();
    },

    /**
     * Builds a world anew from the values on screen.
     *
     * @param {{ seed?: number, population?: string }} [changes]
     * @param {(why: string) => string} [refused] what is said when it is refused; then everything stays as it was
     */
    async restart(changes = {}, refused = text.scenario.refused) {
      /** @type {Scenario} */
      const scenario = { ...run.scenario, events: [] };
      for (const { key } of schema) scenario[fieldOf(key)] = session.value(key);
      Object.assign(scenario, changes);
      return launch(scenario, { name: session.preset, base: session.base }, refused);
    },

    /**
     * Takes a scenario from a file; the preset of the same title, if there is one, says what differs.
     *
     * @param {string} json
     * @param {(why: string) => string} refused
     */
    async openScenario(json, refused) {
      try {
        const { scenario } = await engine.request('complete', { scenario: json });
        const name = presets.find(({ title }) => title === scenario.title)?.name ?? session.preset;
        push = true;
        if (await launch(scenario, { name, base: await completed(name) }, refused)) return true;
      } catch (error) {
        say(refused(messageOf(error)), 'problem');
      }
      push = false;
      return false;
    },

    /** Takes a scenario in place of the present one. @param {Scenario} scenario @param {string} name of the preset that says what differs */
    take: async (scenario, name) => launch(scenario, { name, base: await completed(name) }),

    /** The next address is a new entry of the history. */
    turnPage: () => void (push = true),

    /** A preset with every field. @param {string} name */
    completed,

    /** What the engine has against a scenario; empty when nothing. */
    refusal,

    /** Takes the preset as it is. @param {string} name */
    async choosePreset(name) {
      const base = await completed(name);
      push = true;
      if (!(await launch(base, { name, base }))) push = false;
    },

    /**
     * Opens a link as far as it can be read, runs to its tick and compares the fingerprint.
     *
     * @param {string} hash
     * @param {boolean} [quiet] whether nothing is said of reaching the tick
     * @returns {Promise<boolean>} whether the world may start to move by itself
     */
    open(hash, quiet = false) {
      links += 1;
      const number = links;
      run.cancel(); // an earlier link need not reach its tick any more
      const next = opening.then(() => openLink(hash, number, quiet));
      opening = next.catch(() => {});
      return next;
    },

    /** Address of the last moment whose fingerprint is known, as a hash; while the world stands, that is the one on screen. */
    async link() {
      const { scenario, fingerprint, fingerprintTick: tick } = run;
      return writeLink({ version, schema, preset: session.preset, base: session.base, scenario, tick, fingerprint, beside: await beside.link() });
    },

    /** The whole address to be given away. */
    href: async () => address.href(await session.link()),

    /** Writes the moment on screen into the address: a new entry after a change of preset, else in place of the present one. */
    async writeAddress() {
      const ticket = ++writing;
      const hash = await session.link();
      if (ticket !== writing || hash.length > LONGEST_ADDRESS) return; // a later moment is being written, or only a file can hold it
      address.write(hash, push);
      push = false;
    },
  };

  /** @param {string} hash @param {number} number of the link, to know whether a later one waits @param {boolean} quiet */
  async function openLink(hash, number, quiet) {
    const parts = await readLink(hash, schema, presets.map((preset) => preset.name));
    const base = await completed(parts.preset);
    const scenario = await accepted(base, parts);
    const ready = await beside.open(parts, scenario);
    for (const problem of parts.problems) say(problem, 'problem');
    if (parts.version && parts.version !== version) say(text.link.version(parts.version, version), 'problem', olderVersion(parts.version, text.link.older(parts.version)));
    const opened = await launch(scenario, { name: parts.preset, base });
    await ready(opened);
    if (!opened) return false;
    if (parts.tick === null) return true;
    if (number === links) await run.seek(parts.tick);
    if (number !== links) return false;
    const [said, kind] = verdict(parts);
    if (!quiet || kind === 'problem') say(said, kind);
    const other = beside.verdict(parts);
    if (other) say(other, 'problem');
    return false;
  }

  function tell() {
    for (const listener of listeners) listener();
  }

  /** @param {string} key @returns {Value} */
  function inForce(key) {
    let value = run.scenario[fieldOf(key)];
    for (const event of run.scenario.events ?? []) if (event.key === key && event.tick <= run.tick) value = event.value;
    return value;
  }

  /**
   * Puts a new world in place of the present one; when it is refused, everything stays as it was.
   *
   * @param {Scenario} scenario
   * @param {{ name: string, base: Scenario }} preset what the scenario is compared with from now on
   * @param {(why: string) => string} [refused]
   */
  async function launch(scenario, preset, refused = text.scenario.refused) {
    const before = { name: session.preset, base: session.base };
    const played = state.name === 'running';
    adopt(preset);
    try {
      await run.load(scenario);
    } catch (error) {
      adopt(before);
      say(refused(messageOf(error)), 'problem');
      return false;
    }
    session.pending.clear();
    tell();
    if (played) run.play();
    return true;
  }

  /** @param {{ name: string, base: Scenario }} preset */
  function adopt({ name, base }) {
    session.preset = name;
    session.base = base;
  }

  /** @param {string} name @returns {Promise<Scenario>} */
  async function completed(name) {
    const preset = presets.find((entry) => entry.name === name) ?? presets[0];
    return (await engine.request('complete', { scenario: preset.json })).scenario;
  }

  /**
   * The preset with everything of the link the engine takes; what it refuses is named and left out.
   *
   * @param {Scenario} base
   * @param {LinkParts} parts
   */
  async function accepted(base, parts) {
    /** @type {Scenario} */
    let scenario = { ...base };
    const changes = [...parts.values].map(([key, value]) => /** @type {[string, object]} */ ([key, { [fieldOf(key)]: value }]));
    if (parts.events.length > 0) changes.push(['events', { events: parts.events }]);
    const all = Object.assign({}, scenario, ...changes.map(([, change]) => change));
    if (await refusal(all) === '') return all;
    for (const [key, change] of changes) {
      const problem = await refusal({ ...scenario, ...change });
      if (problem) parts.problems.push(text.link.bad(key, problem));
      else scenario = { ...scenario, ...change };
    }
    return scenario;
  }

  /** What the engine has against a scenario; empty when nothing. @param {Scenario} scenario */
  async function refusal(scenario) {
    try {
      await engine.request('complete', { scenario: JSON.stringify(scenario) });
      return '';
    } catch (error) {
      return messageOf(error);
    }
  }

  /** @param {LinkParts} parts @returns {[string, 'note' | 'problem']} */
  function verdict(parts) {
    if (run.tick !== parts.tick) return [text.link.notReached(parts.tick ?? 0, run.tick), 'problem'];
    if (!parts.fingerprint) return [text.link.reached(run.tick), 'note'];
    if (parts.fingerprint === run.fingerprint) return [text.link.matches(run.tick, run.fingerprint), 'note'];
    return [text.link.differs(run.tick, parts.fingerprint, run.fingerprint, parts.version, version), 'problem'];
  }

  return session;
}

/** @param {unknown} error */
export const messageOf = (error) => (error instanceof Error ? error.message : String(error));

/** @typedef {ReturnType<typeof createSession>} Session */
