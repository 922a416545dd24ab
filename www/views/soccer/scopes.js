import { button, h } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { Team } from '../../soccer/types.js' */

/**
 * Which team is looked at: one choice for all tabs of the inspector.
 *
 * @param {() => void} changed
 */
export function createScopes(changed) {
  /** @type {{ team: Team, keys: HTMLButtonElement[] }[]} */
  const all = [];
  const scopes = {
    /** @type {Team} */
    team: 'blue',
    index: () => (scopes.team === 'blue' ? 0 : 1),

    /** A pair of buttons for one tab. */
    element() {
      const keys = /** @type {Team[]} */ (['blue', 'yellow']).map((team) => {
        const key = button('', () => scopes.choose(team));
        key.append(h('span', { class: `badge ${team}`, 'aria-hidden': 'true' }), soccerText.teams[team]);
        all.push({ team, keys: [key] });
        return key;
      });
      show();
      return h('div', { class: 'scopes', role: 'group', 'aria-label': soccerText.scope }, ...keys);
    },

    /** @param {Team} team */
    choose(team) {
      scopes.team = team;
      show();
      changed();
    },
  };

  function show() {
    for (const { team, keys } of all) for (const key of keys) key.setAttribute('aria-pressed', String(team === scopes.team));
  }

  return scopes;
}

/** @typedef {ReturnType<typeof createScopes>} Scopes */
