/** @import { Film } from './film.js' */
/** @import { Deed, Team } from './types.js' */
/** @import { SoccerMatch } from './match.js' */

/** @typedef {{ from: number, to: number, role: number }} Stretch a robot held a role from one tick to another, which is not part of it */

/**
 * The stretches in which each robot held its roles, kept while the match grows.
 *
 * @param {SoccerMatch} match
 */
export function createStretches(match) {
  /** @type {Stretch[][]} */
  let stretches = Array.from({ length: 6 }, () => []);
  let done = 0; // ticks looked at

  /** @param {Film} film */
  function grow(film) {
    for (; done < film.count; done += 1) {
      if (done > 0 && film.roles(done) === film.roles(done - 1)) continue;
      for (let robot = 0; robot < 6; robot += 1) {
        const list = stretches[robot];
        const role = film.role(done, robot);
        const last = list[list.length - 1];
        if (last?.role === role) continue;
        if (last) last.to = done;
        list.push({ from: done, to: Infinity, role });
      }
    }
  }

  match.on('grown', () => grow(match.film));
  for (const name of /** @type {const} */ (['opened', 'cut'])) {
    match.on(name, () => {
      stretches = Array.from({ length: 6 }, () => []);
      done = 0;
      grow(match.film);
    });
  }

  return {
    /** @param {number} robot 0 to 5 */
    of: (robot) => stretches[robot],
    /** The stretch that holds a tick. @param {number} robot @param {number} tick */
    at: (robot, tick) => stretches[robot].findLast(({ from }) => from <= tick) ?? null,
  };
}

/** @typedef {ReturnType<typeof createStretches>} Stretches */

/** How often something happened to a team up to a tick. @param {Deed[]} deeds @param {Team} team @param {string} kind @param {number} tick */
export const countOf = (deeds, team, kind, tick) => deeds.reduce((count, deed) => count + Number(deed.team === team && deed.kind === kind && deed.frame < tick), 0);
