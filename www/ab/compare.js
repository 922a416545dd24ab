import '../style/ab.css';
import { createEngine } from '../engine.js';
import { fieldOf } from '../link.js';
import { messageOf } from '../session.js';
import { save } from '../ui/share.js';
import { abText } from '../ui/strings.ab.en.js';
import { createEditor } from '../views/ab/editor.js';
import { besideOf, differencesOf, readDifferences, writeDifferences } from './differences.js';
import { createPair } from './pair.js';
import { comparisonOf } from './pairs.js';
import { createStage } from './stage.js';
import { createTwin } from './twin.js';

/** @import { Theme } from '../draw/theme.js' */
/** @import { Engine } from '../engine.js' */
/** @import { LinkParts } from '../link.js' */
/** @import { Lens } from '../lens.js' */
/** @import { Run } from '../run.js' */
/** @import { Selection } from '../selection.js' */
/** @import { Session } from '../session.js' */
/** @import { State } from '../state.js' */
/** @import { Scenario } from '../types.js' */
/** @import { WorldView } from '../views/world.js' */
/** @import { Difference, Whole } from './differences.js' */
/** @import { Comparison } from './pairs.js' */

/**
 * @typedef {{ differences: Difference[], preset: Whole | null }} Choice what B is: A with differences; `preset` is the one they
 *   came from
 */

/**
 * A | B: two scenarios, one seed, one clock.
 *
 * @param {{ engine: Engine, desk: Pick<Engine, 'request' | 'cancel'>, lens: Lens, run: Run, state: State, session: Session, selection: Selection,
 *   world: WorldView, theme: () => Theme, onTheme: (listener: () => void) => void, pane: HTMLElement, controls: HTMLElement, inspector: HTMLElement,
 *   broke: (message: string) => void, spawn: () => Worker, pressed: (on: boolean) => void,
 *   say: (message: string, kind?: 'note' | 'problem') => void, announce: (message: string) => void }} parts
 *   `desk` is where the run's requests go; `pressed` is told whether A | B is on
 */
export function createCompare({ engine, desk, lens, run, state, session, selection, world, theme, onTheme, pane, controls, inspector, broke, spawn, pressed, say, announce }) {
  const other = createEngine(broke, spawn);
  const twin = createTwin();
  /** @type {Choice} */
  let choice = { differences: [], preset: null };
  const pair = createPair({ a: engine, b: other, twin, besideOf: bOf, differences: () => choice.differences, compared: () => stage.showParting() });
  const stage = createStage({ engine, other, lens, run, twin, pair: () => pair, state, selection, world, theme, onTheme, pane, inspector, announce });

  const editor = createEditor(session, {
    compare: (wanted) => void compare(wanted),
    choose: async (name) => (name ? choose(name) : editor.say(await change({ ...choice, preset: null }))),
    change: (differences) => change({ ...choice, differences }),
    swap: () => void swap(),
    same: async () => editor.say(await change({ differences: [], preset: null })),
    save: () => save(`swarm-b-seed${run.scenario.seed}.json`, new Blob([JSON.stringify(twin.scenario, null, 2)], { type: 'application/json' })),
  });

  /** @param {Scenario} scenario of A */
  function bOf(scenario) {
    return besideOf(scenario, choice.differences, titleOfB(scenario));
  }

  /** @param {Scenario} a */
  function titleOfB(a) {
    const { differences, preset } = choice;
    return preset ? String(preset.base.title) : abText.titleOfB(String(a.title), differences.length);
  }

  /** From the next world on, the run asks both engines; until then, and if that world is refused, the one of A. */
  function arm() {
    other.start();
    desk.request = async (type, body, transfer, progress) => {
      if (type !== 'load') return engine.request(type, body, transfer, progress);
      try {
        const answer = await pair.request(type, body);
        desk.request = pair.request;
        return answer;
      } catch (error) {
        disarm();
        throw error;
      }
    };
    desk.cancel = pair.cancel;
  }

  function disarm() {
    desk.request = engine.request;
    desk.cancel = engine.cancel;
    other.end();
  }

  function reveal() {
    if (stage.on) return;
    stage.reveal();
    controls.prepend(editor.element);
    pressed(true);
  }

  function conceal() {
    if (!stage.on) return;
    editor.element.remove();
    pressed(false);
    stage.conceal();
  }

  function show() {
    if (!stage.on) return;
    const original = session.presets.find(({ name }) => name === session.preset)?.title ?? session.preset;
    const changed = session.schema.some(({ key, type }) => type !== 'seed' && run.scenario[fieldOf(key)] !== session.original(key));
    const { differences, preset } = choice;
    const title = String(run.scenario.title || original);
    const kept = preset !== null && session.schema.every(({ key, type }) => type === 'seed' || twin.scenario[fieldOf(key)] === preset.base[fieldOf(key)]);
    const b = preset ? abText.name(String(preset.base.title), !kept || differences.some(({ from }) => from > 0)) : abText.ofA(differences.length);
    stage.name({ a: abText.name(title, changed && title === original), b });
    editor.show({ a: run.scenario, differences, preset: kept ? preset.name : '', comparison: changed ? '' : comparisonOf(session.preset, kept ? (preset?.name ?? '') : '', differences), steps: run.steps });
    stage.showTick();
    stage.showParting();
  }

  /** Where to come back to, and whether to play on, while worlds are built: a second change may come before the first is done. @type {{ tick: number, played: boolean } | null} */
  let stood = null;
  let building = 0;

  /**
   * Builds both worlds anew and comes back to where they stood.
   *
   * @param {() => Promise<boolean>} [build]
   * @param {boolean} [anew] whether to stay at tick 0
   */
  async function rebuild(build = relaunch, anew = false) {
    stood ??= { tick: run.tick, played: state.name === 'running' };
    if (anew) stood.tick = 0;
    const { tick, played } = stood;
    building += 1;
    try {
      if (!(await build())) return false;
      reveal();
      show();
      stage.forget();
      if (tick > 0 && building === 1) await run.seek(tick);
    } finally {
      building -= 1;
      if (building === 0) stood = null;
    }
    if (played && building === 0) run.play();
    return true;
  }

  async function relaunch() {
    await run.load(run.scenario);
    return true;
  }

  /**
   * Makes B something else; when that is refused, everything stays.
   *
   * @param {Choice} next
   * @returns {Promise<string>} what is wrong; empty when nothing
   */
  async function change(next) {
    const former = choice;
    choice = next;
    try {
      await rebuild();
      return '';
    } catch (error) {
      choice = former;
      show();
      return abText.notChanged(messageOf(error).replace(/^B: /, ''));
    }
  }

  /** B is a preset as it is, but for the seed. @param {string} name */
  async function choose(name) {
    const preset = { name, base: await session.completed(name) };
    const differences = differencesOf(run.scenario, (key) => preset.base[fieldOf(key)], session.schema);
    editor.say(await change({ differences, preset }));
  }

  /** Takes a comparison as a whole, from tick 0 on; the seed stays. @param {Comparison} wanted */
  async function compare(wanted) {
    const base = await session.completed(wanted.a);
    const preset = wanted.b ? { name: wanted.b, base: await session.completed(wanted.b) } : null;
    const given = new Map(wanted.differences ?? []);
    const value = (/** @type {string} */ key) => given.get(key) ?? (preset?.base ?? base)[fieldOf(key)];
    await replace({ ...base, seed: run.scenario.seed }, wanted.a, { differences: differencesOf(base, value, session.schema), preset }, true);
  }

  /** A becomes what B was, and B what A was. */
  async function swap() {
    const a = run.scenario;
    const keys = [...new Set(choice.differences.map(({ key }) => key))];
    const differences = keys.flatMap((key) => {
      const later = (a.events ?? []).filter((event) => event.key === key).map((event) => ({ key, value: event.value, from: event.tick }));
      return [...(later[0]?.from === 0 ? [] : [{ key, value: a[fieldOf(key)], from: 0 }]), ...later];
    });
    const former = { name: session.preset, base: session.base };
    await replace({ ...twin.scenario, title: choice.preset?.base.title ?? a.title }, choice.preset?.name ?? session.preset, { differences, preset: choice.preset && former });
  }

  /** @param {Scenario} a @param {string} name of A's preset @param {Choice} next @param {boolean} [anew] */
  async function replace(a, name, next, anew = false) {
    const former = choice;
    choice = next;
    if (await rebuild(() => session.take(a, name), anew)) return;
    choice = former;
    show();
  }

  async function enter() {
    session.turnPage();
    arm();
    try {
      await rebuild();
    } catch (error) {
      say(abText.notOpened(messageOf(error).replace(/^B: /, '')), 'problem');
    }
  }

  /** Back to A alone, at its tick. */
  async function leave() {
    if (state.name === 'running') run.pause();
    if (state.name === 'busy') run.cancel();
    session.turnPage();
    await run.mark().catch(() => {}); // then nothing is under way any more
    const tick = stood?.tick ?? pair.at().a.tick;
    disarm();
    conceal();
    run.steps = Number(run.scenario.steps);
    await run.seek(tick);
  }

  run.on('frame', stage.showTick);
  run.on('settled', stage.showTick);
  run.on('loaded', show);
  run.on('scenario', show);
  session.on(show);

  return {
    get on() {
      return stage.on;
    },

    rings: stage.rings,
    drew: stage.drew,

    /** Opens A | B, or goes back to A. */
    toggle: () => (stage.on ? leave() : enter()),

    /** For a session: see `Beside`. @param {LinkParts} parts @param {Scenario} scenario */
    async open(parts, scenario) {
      if (parts.beside.length === 0) {
        if (stage.on) {
          disarm();
          conceal();
        }
        return async () => {};
      }
      const former = choice;
      choice = await accepted(parts, scenario);
      if (!stage.on) arm();
      return async (/** @type {boolean} */ opened) => {
        if (opened) {
          reveal();
          show();
          stage.forget();
        } else choice = former;
      };
    },

    /** @param {LinkParts} parts */
    verdict(parts) {
      const expected = parts.beside.find(([key]) => key === 'b.f')?.[1];
      if (!stage.on || !expected || expected === twin.fingerprint) return '';
      return abText.differs(run.tick, expected, twin.fingerprint);
    },

    async link() {
      if (desk.request !== pair.request) return [];
      const parts = await writeDifferences(run.scenario, choice.differences, choice.preset, session.schema);
      const known = run.fingerprintTick > 0 && twin.fingerprintTick === pair.at().b.tick && run.fingerprintTick === run.tick;
      return known ? [...parts, `b.f=${twin.fingerprint}`] : parts;
    },

    /** A new engine for B, after one of the two has broken. */
    revive: () => stage.on && arm(),
  };

  /** What a link says of B, as far as the engine takes it. @param {LinkParts} parts @param {Scenario} scenario */
  async function accepted(parts, scenario) {
    const read = await readDifferences(parts.beside, session.schema, session.presets.map(({ name }) => name), parts.problems);
    const preset = read.preset ? { name: read.preset, base: await session.completed(read.preset) } : null;
    const value = (/** @type {string} */ key) => read.values.get(key) ?? (preset?.base ?? scenario)[fieldOf(key)];
    const wanted = [...differencesOf(scenario, value, session.schema), ...read.later];
    if ((await session.refusal(besideOf(scenario, wanted, ''))) === '') return { differences: wanted, preset };
    /** @type {Difference[]} */
    const differences = [];
    for (const difference of wanted) {
      const problem = await session.refusal(besideOf(scenario, [...differences, difference], ''));
      if (problem) parts.problems.push(abText.leftOut(difference.key, problem));
      else differences.push(difference);
    }
    return { differences, preset: null };
  }
}

/** @typedef {ReturnType<typeof createCompare>} Compare */
