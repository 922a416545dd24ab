import { EngineError } from '../engine.js';
import { fieldOf } from '../link.js';
import { messageOf } from '../session.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { text } from '../ui/strings.en.js';
import { readSoccerLink, writeSoccerLink } from './link.js';

/** @import { Engine } from '../engine.js' */
/** @import { Address } from '../router.js' */
/** @import { Parameter, Value } from '../types.js' */
/** @import { Preset } from './library.js' */
/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { Scenario, Setting, Team } from './types.js' */

const LONGEST_ADDRESS = 1_000_000; // the longest a browser is asked to hold
/** Teams that a tree coaches; another one becomes the first of them when it is given a tree. */
const TREE_TEAMS = ['tree', 'tree-without-swaps', 'tree-double-margins'];

/**
 * The scenario on screen: the preset, what differs from it, and what was done to the match.
 *
 * @param {{ engine: Pick<Engine, 'request'>, match: SoccerMatch, playback: SoccerPlayback, address: Address, schema: Parameter[], setting: Setting,
 *   version: string, presets: Preset[], say: (message: string, kind?: 'note' | 'problem') => void }} parts
 */
export function createSoccerSession({ engine, match, playback, address, schema, setting, version, presets, say }) {
  /** @type {(() => void)[]} */
  const listeners = [];
  /** @type {(() => void)[]} */
  const linked = [];
  /** @type {Map<string, Scenario>} presets with every field */
  const bases = new Map();
  let writing = 0;
  let push = false;
  let awaited = ''; // the fingerprint that a link expects

  const session = {
    schema,
    setting,
    version,
    presets,
    preset: presets[0].name,
    /** @type {Scenario} the preset with every field */
    base: { world: 'soccer', seed: 0 },
    /** In A | B, who coaches blue in B; null when the match stands alone. @type {string | null} */
    beside: null,

    /** @param {() => void} listener told when the scenario is another one */
    on: (listener) => void listeners.push(listener),
    /** @param {() => void} listener told when a link was opened, which says what is beside */
    onLink: (listener) => void linked.push(listener),
    tell,

    /** Another match beside, or none any more. @param {string | null} blue who coaches blue in it */
    compare(blue) {
      if (blue === session.beside) return;
      session.beside = blue;
      void session.writeAddress();
    },

    /** What is played. @returns {Scenario} */
    scenario: () => match.scenario ?? session.base,

    /** @param {string} key @returns {Value} */
    value: (key) => session.scenario()[fieldOf(key)],
    /** @param {string} key @returns {Value} */
    original: (key) => session.base[fieldOf(key)],

    /** Plays the match anew with another value; what was done to it is dropped. @param {Parameter} parameter @param {Value} value */
    change(parameter, value) {
      const field = fieldOf(parameter.key);
      if (value === session.scenario()[field]) return Promise.resolve(true);
      return session.play({ [field]: value }, (why) => text.value.refused(parameter.label, why));
    },

    /** Plays the match anew with other values. @param {Record<string, Value>} changes @param {(why: string) => string} [refused] */
    play(changes, refused = soccerText.refused) {
      const now = session.scenario();
      const dropped = (now.events ?? []).length;
      if (dropped > 0) say(soccerText.dropped(dropped));
      return take({ ...now, ...changes, events: [] }, session.preset, refused);
    },

    /** A coach or roles of the visitor's own; empty for the built-in ones. @param {Team} team @param {'coach' | 'roles'} what @param {string} xml */
    give(team, what, xml) {
      const now = session.scenario();
      /** @type {Record<string, Value>} */
      const changes = { [`${team}-${what}`]: xml };
      if (what === 'coach' && xml !== '' && !TREE_TEAMS.includes(now[team])) changes[team] = TREE_TEAMS[0];
      return session.play(changes);
    },

    /** The text of a team's coach; null when no tree coaches it. @param {Team} team @returns {string | null} */
    coachText(team) {
      const now = session.scenario();
      if (!TREE_TEAMS.includes(now[team])) return null;
      return now[`${team}-coach`] || (now[team] === 'tree-without-swaps' ? setting.coach_without_swaps : setting.coach);
    },

    /** The text of a team's roles. @param {Team} team @returns {string} */
    rolesText(team) {
      const now = session.scenario();
      return now[`${team}-roles`] || (now[team] === 'chase' ? setting.chase_trees : setting.role_trees);
    },

    /** @param {string} name */
    async choosePreset(name) {
      push = true;
      if (!(await take(await completed(name), name, soccerText.refused))) push = false;
    },

    /** Does something to the match at the moment on screen. @param {string} key @param {unknown} value */
    async act(key, value) {
      if (match.over && playback.tick >= match.front()) return soccerText.situation.over;
      const later = (session.scenario().events ?? []).filter(({ tick }) => tick > playback.tick).length;
      const refusal = await match.set(playback.tick, key, value);
      if (refusal) return refusal.replace(/^soccer\.\w+: /, ''); // it is plain what was meant
      if (later > 0) say(soccerText.cut(playback.tick));
      tell();
      void session.writeAddress();
      return '';
    },

    /** @param {string} hash */
    async openLink(hash) {
      const link = await readSoccerLink(hash, schema, presets.map(({ name }) => name));
      if (link.version && link.version !== version) link.problems.push(text.link.version(link.version, version));
      const scenario = { ...(await completed(link.preset)) };
      session.beside = link.beside;
      for (const [key, value] of link.values) scenario[fieldOf(key)] = value;
      const opened = await take({ ...scenario, events: link.events }, link.preset, soccerText.refused, link.tick);
      if (!opened && !match.scenario) await take(await completed(link.preset), link.preset, soccerText.refused);
      for (const problem of link.problems) say(problem, 'problem');
      awaited = opened ? link.fingerprint : '';
      verify();
      for (const listener of linked) listener();
    },

    /** Takes a scenario, or the log of a replay, from a file. @param {string} name @param {string} json */
    async openFile(name, json) {
      try {
        const written = JSON.parse(json);
        const scenario = written?.scenario ?? written;
        const complete = (await engine.request('complete', { scenario: JSON.stringify(scenario) })).scenario;
        if (complete.world !== 'soccer') throw new Error(soccerText.otherWorld(complete.world));
        const preset = presets.find(({ title }) => title === complete.title)?.name ?? session.preset;
        push = true;
        if (!(await take(complete, preset, (why) => soccerText.fileRefused(name, why)))) return;
        say(soccerText.opened(name));
        awaited = String(written?.fingerprint ?? written?.fingerprints?.at?.(-1)?.[1] ?? ''); // of a log of this page, or of a replay
        verify();
      } catch (error) {
        say(soccerText.fileRefused(name, messageOf(error)), 'problem');
      }
    },

    link: () => writeSoccerLink({ version, preset: session.preset, base: session.base, scenario: session.scenario(), schema, beside: session.beside, tick: playback.tick, fingerprint: match.fingerprint }),

    /** The whole address to be given away. */
    href: async () => address.href(await session.link()),

    async writeAddress() {
      const ticket = ++writing;
      const hash = await session.link();
      if (ticket !== writing || hash.length > LONGEST_ADDRESS) return; // a later moment is being written, or only a file can hold it
      address.write(hash, push);
      push = false;
    },

    /** What was done by somebody who drove stands in the scenario of the engine only until it is fetched. */
    async refetch() {
      match.scenario = (await engine.request('scenario')).scenario;
      tell();
      void session.writeAddress();
    },

    /** Plays again with an engine that knows nothing. */
    reload: () => match.open(session.scenario()),
  };

  function tell() {
    for (const listener of listeners) listener();
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
   * Takes a scenario in place of the present one; when it is refused, everything stays as it was.
   *
   * @param {Scenario} scenario
   * @param {string} preset
   * @param {(why: string) => string} refused
   * @param {number} [tick] the moment to show as soon as it is there
   */
  async function take(scenario, preset, refused, tick = 0) {
    try {
      const base = await completed(preset);
      const refusal = await match.open(scenario);
      if (refusal) {
        say(refused(refusal), 'problem');
        return false;
      }
      awaited = '';
      Object.assign(session, { preset, base });
      tell();
      await playback.reach(tick);
      void session.writeAddress();
      return true;
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) say(refused(messageOf(error)), 'problem');
      return false;
    }
  }

  /** Compares the fingerprint of a link or a replay once the match is over. */
  function verify() {
    if (!awaited || !match.over) return;
    if (awaited === match.fingerprint) say(soccerText.matches(awaited));
    else say(soccerText.differs(awaited, match.fingerprint), 'problem');
    awaited = '';
  }

  match.on('over', () => {
    verify();
    void session.writeAddress();
  });
  match.on('cut', () => void (awaited = ''));

  return session;
}

/** @typedef {ReturnType<typeof createSoccerSession>} SoccerSession */
