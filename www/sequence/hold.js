import { added, placeOf, placed, removed, things } from './edit.js';

/** @import { Thing, Place } from './edit.js' */
/** @import { SequenceSession } from './session.js' */
/** @import { Form, Scenario, Task } from './types.js' */

/**
 * What is chosen on the map and what is done to it. While something is dragged, every placement is planned for; one that
 * cannot be is shown where it is, said why, and dropped in favour of the last one that could.
 *
 * @param {{ session: SequenceSession, task: () => Task | null, changed: () => void }} parts
 */
export function createHold({ session, task, changed }) {
  /** @type {Scenario | null} the last placement of a drag that was taken */
  let good = null;
  /** @type {Scenario | null} what is under the pointer */
  let shown = null;
  /** Steps of the chosen thing that came while an earlier one was being taken, metres. */
  let late = { x: 0, y: 0 };
  let stepping = false;

  const hold = {
    /** @type {Thing | null} */
    chosen: null,

    frozen: () => session.frozen(),
    refusal: () => session.refusal,
    /** The placement under the pointer; null when nothing is dragged. */
    shown: () => shown,

    /** @param {Thing | null} thing */
    choose(thing) {
      hold.chosen = thing;
      late = { x: 0, y: 0 };
      changed();
    },

    /** Chooses the next or the previous thing. @param {1 | -1 | 'first' | 'last'} where */
    step(where) {
      const now = task();
      if (!now) return;
      const all = things(now);
      const at = all.findIndex((thing) => thing.kind === hold.chosen?.kind && thing.index === hold.chosen.index);
      const next = where === 'first' ? 0 : where === 'last' ? all.length - 1 : at < 0 ? (where > 0 ? 0 : all.length - 1) : at + where;
      hold.choose(all[(next + all.length) % all.length]);
    },

    /** @returns {Place | null} where the chosen thing stands */
    place: () => (hold.chosen ? placeOf(shown ?? session.frozen(), hold.chosen) : null),

    /** Plans for a placement while it moves. @param {Scenario} scenario */
    async drag(scenario) {
      shown = scenario;
      changed();
      const refusal = await session.preview(scenario);
      if (shown !== scenario) return;
      if (refusal === '') good = scenario;
      changed();
    },

    /** The drag ends: the last placement that could be planned for counts. */
    async drop() {
      const last = shown;
      if (!last) return;
      const refused = session.refusal !== '';
      shown = null;
      const taken = refused ? good : last;
      good = null;
      if (taken) await session.commit(taken);
      else await session.back();
      changed();
    },

    /** Puts the chosen thing elsewhere or changes its size. @param {Partial<Place>} to */
    async put(to) {
      if (!hold.chosen) return;
      await session.commit(placed(session.frozen(), hold.chosen, to));
      changed();
    },

    /**
     * Moves the chosen thing. Keys come faster than placements are taken: what came meanwhile is taken in one.
     *
     * @param {number} dx @param {number} dy metres
     */
    async nudge(dx, dy) {
      late = { x: late.x + dx, y: late.y + dy };
      if (stepping) return;
      stepping = true;
      try {
        for (let place = hold.place(); place && (late.x !== 0 || late.y !== 0); place = hold.place()) {
          const to = { x: place.x + late.x, y: place.y + late.y };
          late = { x: 0, y: 0 };
          await hold.put(to);
        }
      } finally {
        stepping = false;
      }
    },

    /** A new obstacle, which is then chosen. @param {Form} form */
    async add(form) {
      const scenario = added(session.frozen(), form);
      if (await session.commit(scenario)) hold.choose({ kind: 'obstacle', index: scenario['obstacle-list'].length - 1 });
    },

    /** Takes the chosen obstacle away. */
    async remove() {
      const { chosen } = hold;
      if (chosen?.kind !== 'obstacle') return;
      const scenario = removed(session.frozen(), chosen.index);
      hold.chosen = null;
      await session.commit(scenario);
      changed();
    },
  };

  return hold;
}

/** @typedef {ReturnType<typeof createHold>} Hold */
