import { messageOf } from '../session.js';
import { abText } from '../ui/strings.ab.en.js';
import { createParting } from './parting.js';

/** @import { Engine } from '../engine.js' */
/** @import { FrameAnswer, Scenario } from '../types.js' */
/** @import { Difference } from './differences.js' */
/** @import { Side } from './parting.js' */
/** @import { Twin } from './twin.js' */

/** Each of the two engines may keep half of what one alone keeps for going back. */
const KEYFRAMES = 16 << 20;

/**
 * Two engines that answer as one: a run that asks them moves both to one tick, and gets A's answer when B stands there too.
 * A run that has ended stands at its end while the other goes on.
 *
 * @param {{ a: Engine, b: Engine, twin: Twin, besideOf: (scenario: Scenario) => Scenario, differences: () => Difference[], compared: () => void }} parts
 *   `besideOf` gives B's scenario; `compared` is called when more is known of where the two part
 */
export function createPair({ a, b, twin, besideOf, differences, compared }) {
  const engines = { a, b };
  const parting = createParting();
  /** Where each stands. @type {Record<Side, { tick: number, finished: string | null }>} */
  let at = { a: { tick: 0, finished: null }, b: { tick: 0, finished: null } };
  /** Ticks that both managed within one frame lately; more are not asked for, so that neither waits long. */
  let reach = 8;
  /** A's scenario. @type {Scenario} */
  let own = { world: 'geese', seed: 0 };

  const tick = () => Math.max(at.a.tick, at.b.tick);

  /**
   * @param {Side} side
   * @param {'advance' | 'seek'} type
   * @param {object} body
   * @param {ArrayBuffer | undefined} buffer
   * @param {(tick: number) => void} [progress]
   * @returns {Promise<FrameAnswer>}
   */
  async function ask(side, type, body, buffer, progress) {
    const answer = await engines[side].request(type, { ...body, buffer, known: parting.known(side) }, buffer ? [buffer] : [], progress);
    at[side] = { tick: answer.tick, finished: answer.finished };
    parting.add(side, answer.marks);
    return answer;
  }

  /** The side that is behind the other and can go on. @returns {Side | null} */
  function behind() {
    if (at.a.tick === at.b.tick) return null;
    const side = at.a.tick < at.b.tick ? 'a' : 'b';
    return at[side].finished === null ? side : null;
  }

  /**
   * Both stand at one tick, or one at its end: gives A's answer in the name of both.
   *
   * @param {Record<Side, FrameAnswer>} answers
   * @param {number} before
   * @returns {FrameAnswer}
   */
  function show({ a: first, b: second }, before) {
    twin.show(second);
    compared();
    const finished = first.finished !== null && second.finished !== null ? abText.finished(first.finished, second.finished) : null;
    return { ...first, tick: tick(), done: Math.abs(tick() - before), finished, ms: Math.max(first.ms, second.ms) };
  }

  /** @type {Record<string, (body: any, progress?: (tick: number) => void) => Promise<any>>} */
  const answers = {
    async load({ scenario }) {
      const former = { scenario: twin.scenario, tick: at.b.tick, stands: twin.layout !== null };
      const load = (/** @type {Side} */ side, /** @type {Scenario} */ what) => engines[side].request('load', { scenario: JSON.stringify(what), keyframes: KEYFRAMES });
      const wanted = JSON.parse(scenario);
      let second;
      try {
        second = await load('b', besideOf(wanted));
      } catch (error) {
        throw new Error(abText.refused(messageOf(error)), { cause: error });
      }
      let first;
      try {
        first = await load('a', wanted);
      } catch (error) {
        if (former.stands) {
          await load('b', former.scenario);
          await b.request('seek', { tick: former.tick, known: 0 });
        }
        throw error;
      }
      own = first.scenario;
      at = { a: { tick: 0, finished: null }, b: { tick: 0, finished: null } };
      parting.reset();
      parting.add('a', first.marks);
      parting.add('b', second.marks);
      twin.load(second);
      return { ...first, steps: Math.max(Number(first.scenario.steps ?? 0), Number(second.scenario.steps ?? 0)) };
    },

    async advance({ ticks, budgetMs, buffer }) {
      const before = tick();
      const goal = Math.min(ticks, reach);
      const [first, second] = await Promise.all([ask('a', 'advance', { ticks: goal, budgetMs }, buffer), ask('b', 'advance', { ticks: goal, budgetMs }, twin.takeBuffer())]);
      const both = { a: first, b: second };
      const slower = Math.min(...[first, second].map(({ done, finished }) => (finished === null ? done : goal)));
      if (slower < goal) reach = slower + 1;
      else if (goal === reach) reach = Math.ceil(reach * 1.5);
      for (let side = behind(); side; side = behind()) {
        both[side] = await ask(side, 'advance', { ticks: tick() - at[side].tick, budgetMs: Infinity }, both[side].buffer);
      }
      return show(both, before);
    },

    async seek({ tick: target, buffer }, progress) {
      const before = tick();
      /** @type {Record<Side, number>} */
      const reached = { a: Infinity, b: Infinity };
      const report = (/** @type {Side} */ side) => (/** @type {number} */ now) => {
        reached[side] = now;
        progress?.(Math.min(reached.a, reached.b));
      };
      const [first, second] = await Promise.all([ask('a', 'seek', { tick: target }, buffer, report('a')), ask('b', 'seek', { tick: target }, twin.takeBuffer(), report('b'))]);
      const both = { a: first, b: second };
      // After a cancel one may have come further: it goes back to where the other stands.
      for (let side = behind(); side; side = behind()) {
        const ahead = side === 'a' ? 'b' : 'a';
        both[ahead] = await ask(ahead, 'seek', { tick: at[side].tick }, both[ahead].buffer);
      }
      return show(both, before);
    },

    /** A change of A concerns B too, unless B has its own value of that parameter. */
    async event({ key, value }) {
      const here = tick();
      const past = (own.events ?? []).filter((event) => event.tick < here || (event.tick === here && event.key !== key));
      const changed = besideOf({ ...own, events: [...past, { tick: here, key, value }] });
      await b.request('complete', { scenario: JSON.stringify(changed) }); // both take it, or neither
      const answer = await a.request('event', { key, value });
      own = answer.scenario;
      const apart = differences().some((difference) => difference.from > here || difference.key === key);
      if (apart) {
        // B's own later changes must stay, which an event would cut: it runs again from the start.
        await b.request('load', { scenario: JSON.stringify(changed), keyframes: KEYFRAMES });
        await b.request('seek', { tick: at.b.tick, known: 0 });
        twin.scenario = changed;
      } else twin.scenario = (await b.request('event', { key, value })).scenario;
      parting.cut(here);
      compared();
      return { ...answer, tick: here };
    },

    async fingerprint() {
      const [first, second] = await Promise.all([a.request('fingerprint'), b.request('fingerprint')]);
      twin.note(second.hash, second.tick);
      compared();
      return { ...first, tick: tick() };
    },
  };

  return {
    parting,
    at: () => at,

    /** @type {Engine['request']} */
    request: (type, body = {}, _transfer, progress) => answers[type](body, progress),

    cancel() {
      a.cancel();
      b.cancel();
    },
  };
}

/** @typedef {ReturnType<typeof createPair>} Pair */
