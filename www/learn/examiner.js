import { createEngine } from '../engine.js';
import { scenarioText } from './presets.js';

/** @import { Engine } from '../engine.js' */
/** @import { Layout } from '../types.js' */
/** @import { Shared } from '../router.js' */
/** @import { Moment, Opened } from '../trees/types.js' */
/** @import { Path, Progress } from '../sequence/types.js' */
/** @import { Lesson, Measure, TreeCheck, Values, World } from './lessons.js' */

/**
 * @typedef {object} Found what the engine found for one option
 * @property {string} option
 * @property {boolean} right
 * @property {number | null} number what was measured
 * @property {number} [of] out of how many
 * @property {string} [letters] what was carried out
 * @property {string} [program] what a genome stands for
 * @property {boolean} [goal] whether the target was reached
 * @property {boolean} [collided]
 * @property {string[]} [fingerprints]
 *
 * @typedef {object} Finding
 * @property {Found[]} rows one for each option; one for a task without options
 * @property {string} version of the engine
 */

const SLICE_MS = 50;
const MOST_SLICES = 160; // a search for a plan that takes longer than 8 seconds of computing is left as it stands

/** @typedef {{ scenario: string, tick: number }} Job a run to a tick */

/**
 * Answers the questions of lessons by running the engine: a worker of its own, so the world on screen is not touched.
 * No answer is written anywhere.
 *
 * @param {(done: number, all: number) => void} progress
 */
export function createExaminer(progress) {
  /** @type {Map<string, Engine>} */
  const engines = new Map();
  let cancelled = false;
  /** @type {(reason: Error) => void} */
  let fail = () => {};

  /** @param {'worlds' | 'trees' | 'sequence'} kind @returns {Engine} */
  function engine(kind) {
    const known = engines.get(kind);
    if (known) return known;
    const spawn = {
      worlds: () => new Worker(new URL('../worker.js', import.meta.url), { type: 'module' }),
      trees: () => new Worker(new URL('../trees/worker.js', import.meta.url), { type: 'module' }),
      sequence: () => new Worker(new URL('../sequence/worker.js', import.meta.url), { type: 'module' }),
    }[kind];
    const made = createEngine((message) => fail(new Error(message)), spawn);
    made.start();
    engines.set(kind, made);
    return made;
  }

  /** Runs a scenario to a tick and measures. @param {Job} job @param {Measure} measure */
  async function measured({ scenario, tick }, measure) {
    const { request } = engine('worlds');
    /** @type {{ layout: Layout }} */
    const { layout } = await request('load', { scenario });
    const { buffer } = await request('seek', { tick });
    const frame = new Float32Array(buffer);
    if (measure === 'delivered') return frame[layout.counts.offset + layout.counts.fields.indexOf('delivered')];
    let knowing = 0;
    for (let agent = 0; agent < layout.agents.count; agent += 1) {
      const { detail } = await request('inspect', { query: { agent } });
      if (detail.agent.knows.some((/** @type {string} */ place) => /site/i.test(place))) knowing += 1;
    }
    return knowing;
  }

  /** The fingerprint of a run at a tick. @param {Job} job @returns {Promise<string>} */
  async function fingerprint({ scenario, tick }) {
    const { request } = engine('worlds');
    await request('load', { scenario });
    await request('seek', { tick });
    return (await request('fingerprint')).hash;
  }

  /** @param {string} preset @param {number} seed @param {number} tick @param {...(Values | undefined)} values @returns {Job} */
  const job = (preset, seed, tick, ...values) => ({ scenario: scenarioText(preset, Object.assign({ seed }, ...values)), tick });

  /**
   * What the engine has to say of each option.
   *
   * @param {Lesson} lesson
   * @param {() => Promise<Shared>} screen what the visitor has on screen, for tasks
   * @returns {Promise<Found[]>}
   */
  async function rowsOf({ check, world }, screen) {
    switch (check.kind) {
      case 'runs': {
        const rows = await each(check.options, async (option, { values, tick }) => ({ option, number: await measured(job(check.preset, check.seed, tick ?? check.tick, check.values, values), check.measure) }));
        const most = Math.max(...rows.map(({ number }) => number));
        return rows.map((row) => ({ ...row, right: row.number === most && most > 0 }));
      }
      case 'number': {
        const number = await measured(job(check.preset, check.seed, check.tick, check.values), check.measure);
        return Object.entries(check.options).map(([option, { from, to }]) => ({ option, number, right: number >= from && number <= to }));
      }
      case 'twins':
        return each(check.options, async (option, pair) => {
          const fingerprints = [];
          for (const { seed, values } of pair) fingerprints.push(await fingerprint(job(check.preset, seed, check.tick, values)));
          return { option, number: null, fingerprints, right: new Set(fingerprints).size === 1 };
        });
      case 'derive': {
        const { request } = engine('worlds');
        await request('load', job(check.preset, check.seed, 0, check.values));
        /** @type {{ genome: number[] }} */
        const { genome } = (await request('inspect', { query: { agent: 0 } })).detail.agent;
        const before = (await request('derive', { codons: genome })).derived.phenotype;
        return each(check.options, async (option, { codon, value }) => {
          const codons = genome.map((known, at) => (at === codon - 1 ? value : known));
          const program = (await request('derive', { codons })).derived.phenotype;
          return { option, number: null, program: program ?? '', right: program !== before };
        });
      }
      case 'tree':
        return treeRows(check, world);
      case 'orders': {
        await openPlan(scenarioText(check.preset, { seed: check.seed }));
        const orders = ordersOf(check.letters);
        let number = 0;
        for (const [at, letters] of orders.entries()) {
          progress(at, orders.length);
          if ((await followed(letters)).goal) number += 1;
        }
        return Object.entries(check.options).map(([option, { from, to }]) => ({ option, number, of: orders.length, right: number >= from && number <= to }));
      }
      case 'wins': {
        const rows = await each(check.options, async (option, [first, second]) => {
          let number = 0;
          for (let seed = 1; seed <= check.seeds; seed += 1) {
            const mine = await measured(job(check.preset, seed, check.tick, check.values, first), check.measure);
            if (mine > (await measured(job(check.preset, seed, check.tick, check.values, second), check.measure))) number += 1;
          }
          return { option, number, of: check.seeds };
        });
        const most = Math.max(...rows.map(({ number }) => number));
        return rows.map((row) => ({ ...row, right: row.number === most }));
      }
      case 'goal': {
        const { file } = await screen();
        const number = await measured({ scenario: file.text, tick: check.tick }, check.measure);
        return [{ option: '', number, right: number >= check.least }];
      }
      case 'plan':
        return planRows(await screen());
    }
  }

  /** @param {TreeCheck} check @param {World} world */
  async function treeRows(check, world) {
    const setup = { xml: world.xml ?? '', script: world.script ?? [], mode: 'exactly_once', ms: 100, length: check.tick, at: check.tick };
    /** @type {Opened} */
    const { tree, moment } = (await engine('trees').request('open', { bench: 0, setup })).opened;
    const letters = /** @type {Moment} */ (moment).ticked;
    return each(check.options, async (option, { leaf, letter }) => {
      const node = tree?.nodes.find(({ name, scripted }) => scripted && name === leaf);
      return { option, number: null, right: node !== undefined && letters[node.id] === letter };
    });
  }

  /** The visitor's plan, and the best that the planner has for the same task. @param {Shared} shared @returns {Promise<Found[]>} */
  async function planRows({ file, plan }) {
    let searched = await openPlan(file.text);
    const own = plan ? await followed(plan) : { number: null, goal: false, collided: false, letters: '' };
    for (let slice = 0; slice < MOST_SLICES && searched.outcome === null && !cancelled; slice += 1) {
      searched = (await engine('sequence').request('search', { budgetMs: SLICE_MS })).slice.progress;
    }
    return [
      { option: 'yours', ...own, right: own.goal },
      { option: 'planner', number: searched.cost, letters: searched.plan ?? '', goal: searched.plan !== null, collided: false, right: false },
    ];
  }

  /** @param {string} scenario @returns {Promise<Progress>} */
  async function openPlan(scenario) {
    const { slice } = await engine('sequence').request('open', { scenario, budgetMs: SLICE_MS });
    return slice.progress;
  }

  /** @param {string} letters */
  async function followed(letters) {
    /** @type {Path} */
    const { replay } = (await engine('sequence').request('follow', { letters })).path;
    return { letters, number: replay.total, goal: replay.goal && replay.collision === null, collided: replay.collision !== null };
  }

  /**
   * @template O, R
   * @param {Record<string, O>} options
   * @param {(name: string, option: O) => Promise<R>} look
   */
  async function each(options, look) {
    const list = Object.entries(options);
    /** @type {R[]} */
    const rows = [];
    for (const [name, option] of list) {
      progress(rows.length, list.length);
      rows.push(await look(name, option));
    }
    return rows;
  }

  return {
    /**
     * Rejects when the engine breaks, or refuses what is on screen.
     *
     * @param {Lesson} lesson
     * @param {() => Promise<Shared>} screen
     * @returns {Promise<Finding>}
     */
    async examine(lesson, screen) {
      cancelled = false;
      progress(0, 1);
      const broken = new Promise((_, reject) => (fail = reject));
      const rows = await Promise.race([rowsOf(lesson, screen), /** @type {Promise<never>} */ (broken)]);
      const kind = lesson.check.kind === 'tree' ? 'trees' : lesson.check.kind === 'orders' || lesson.check.kind === 'plan' ? 'sequence' : 'worlds';
      const { version } = await engine(kind).request('hello');
      return { rows, version };
    },

    /** Ends the workers; a later question starts new ones. */
    end() {
      cancelled = true;
      for (const made of engines.values()) made.end();
      engines.clear();
    },
  };
}

/** Every different order of the same letters. @param {string} letters @returns {string[]} */
export function ordersOf(letters) {
  if (letters.length < 2) return [letters];
  const firsts = [...new Set(letters)];
  return firsts.flatMap((first) => ordersOf(letters.replace(first, '')).map((rest) => first + rest));
}

/** @typedef {ReturnType<typeof createExaminer>} Examiner */
