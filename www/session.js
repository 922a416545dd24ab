import { text } from './ui/strings.en.js';
import { fieldOf, readLink, writeLink } from './link.js';

/** @import { Engine } from './engine.js' */
/** @import { Run } from './run.js' */
/** @import { Address } from './router.js' */
/** @import { State } from './state.js' */
/** @import { Parameter, Scenario, Value } from './types.js' */
/** @import { LinkParts } from './link.js' */

/** @typedef {{ name: string, title: string, about: string, json: string }} Preset */

/**
 * The scenario on screen: the preset, what differs from it, and changes that wait for a restart.
 *
 * @param {{ engine: Engine, run: Run, state: State, address: Address, schema: Parameter[], version: string, presets: Preset[],
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts
 */
export function createSession({ engine, run, state, address, schema, version, presets, say }) {
  /** @type {(() => void)[]} */
  const listeners = [];
  let writing = 0;
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
     * @param {{ seed?: number }} [changes]
     */
    async restart(changes = {}) {
      /** @type {Scenario} */
      const scenario = { ...run.scenario, events: [] };
      for (const { key } of schema) scenario[fieldOf(key)] = session.value(key);
      Object.assign(scenario, changes);
      await launch(scenario);
    },

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
     * @returns {Promise<boolean>} whether the world may start to move by itself
     */
    async open(hash) {
      const parts = await readLink(hash, schema, presets.map((preset) => preset.name));
      if (parts.version && parts.version !== version) parts.problems.push(text.link.version(parts.version, version));
      const base = await completed(parts.preset);
      const scenario = await accepted(base, parts);
      for (const problem of parts.problems) say(problem, 'problem');
      if (!(await launch(scenario, { name: parts.preset, base }))) return false;
      if (parts.tick === null) return true;
      await run.seek(parts.tick);
      say(...verdict(parts));
      return false;
    },

    /** Address of the last moment whose fingerprint is known, as a hash; while the world stands, that is the one on screen. */
    link: () =>
      writeLink({ version, schema, preset: session.preset, base: session.base, scenario: run.scenario, tick: run.fingerprintTick, fingerprint: run.fingerprint }),

    /** Writes the moment on screen into the address: a new entry after a change of preset, else in place of the present one. */
    async writeAddress() {
      const ticket = ++writing;
      const hash = await session.link();
      if (ticket !== writing) return; // a later moment is being written
      address.write(hash, push);
      push = false;
    },
  };

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
   * @param {{ name: string, base: Scenario }} [preset] what the scenario is compared with from now on
   */
  async function launch(scenario, preset = { name: session.preset, base: session.base }) {
    const before = { name: session.preset, base: session.base };
    const played = state.name === 'running';
    adopt(preset);
    try {
      await run.load(scenario);
    } catch (error) {
      adopt(before);
      say(text.scenario.refused(messageOf(error)), 'problem');
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
