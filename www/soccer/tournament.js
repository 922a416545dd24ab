import { createPool } from '../studies/pool.js';
import { button, h, write } from '../ui/dom.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { createStandingsTable, paperTable } from '../views/soccer/standings.js';
import { fixtures, standings } from './table.js';

/** @import { SoccerFrame } from '../views/soccer/frame.js' */
/** @import { SoccerSession } from './session.js' */
/** @import { Game } from './table.js' */
/** @import { Outcome } from './types.js' */

const words = soccerText.tournament;
const MOST_ROUNDS = 10;
const LONGEST_HALF = 3600;
const KINDS = Object.keys(soccerText.kinds);

/**
 * A round robin of the playground's teams over a pool of workers, with the table filling as games end.
 *
 * @param {{ frame: SoccerFrame, session: SoccerSession, watch: (scenario: Record<string, string | number | boolean>) => Promise<void>, announce: (message: string) => void }} parts
 *   `watch` shows a game on the pitch
 */
export function createTournament({ frame, session, watch, announce }) {
  let on = false;
  let going = false;
  let seconds = 0;
  /** @type {string[]} */
  let teams = [];
  /** @type {(ReturnType<typeof fixtures>[number] & { seed: number, goals: [number, number] | null })[]} */
  let games = [];
  /** @type {Record<string, unknown>} what all games have in common */
  let common = {};

  const pool = createPool({
    spawn: () => new Worker(new URL('./hand.js', import.meta.url), { type: 'module' }),
    module: () => WebAssembly.compileStreaming(fetch(new URL('./engine/swarm_playground_bg.wasm', import.meta.url))),
    on: {
      done(run, line, took) {
        /** @type {Outcome} */
        const { goals } = JSON.parse(line);
        games[run].goals = goals;
        seconds += took;
        show();
      },
      failed: (_, why) => write(problem, words.failed(why)),
      broken(why) {
        going = false;
        write(problem, words.failed(why));
        show();
      },
      idle() {
        going = false;
        show();
        announce(progress.textContent ?? '');
      },
    },
  });

  const boxes = KINDS.map((kind) => ({ kind, box: h('input', { type: 'checkbox', checked: true, id: `soccer-team-${kind}` }) }));
  const number = (/** @type {string} */ id, /** @type {string} */ label, /** @type {number} */ value, /** @type {number} */ most) => {
    const field = h('input', { type: 'text', inputmode: 'numeric', id, value, size: 5, autocomplete: 'off' });
    const read = () => Math.min(Math.max(Math.round(Number(field.value)) || 1, 1), most);
    field.addEventListener('change', () => ((field.value = String(read())), reset()));
    return { element: h('label', {}, label, field), field, read };
  };
  const rounds = number('soccer-rounds', words.rounds, 1, MOST_ROUNDS);
  const half = number('soccer-half', words.half, 300, LONGEST_HALF);
  const cores = navigator.hardwareConcurrency || 2;
  const workers = number('soccer-workers', words.workers, Math.max(1, Math.min(cores - 1, 8)), 8);
  const start = button(words.start, () => void toggle(), { class: 'primary' });
  start.id = 'soccer-tournament-start';
  const again = button(words.again, reset);
  const progress = h('p', { id: 'soccer-progress', role: 'status' });
  const problem = h('p', { class: 'verdict bad', role: 'alert' });
  const table = createStandingsTable(words.caption, 'soccer-standings');
  const sums = h('p', { class: 'said small', id: 'soccer-sums' });
  const rows = h('tbody', {});
  const list = h('table', { class: 'games' }, h('thead', {}, h('tr', {}, ...words.gameColumns.map((column) => h('th', { scope: 'col' }, column)))), rows);
  const element = h(
    'div',
    { class: 'tournament', tabindex: 0, role: 'region', 'aria-label': words.title },
    h('h2', {}, words.title),
    h('fieldset', {}, h('legend', {}, words.teams), ...boxes.map(({ kind, box }) => h('label', { class: 'check' }, box, soccerText.kinds[kind]))),
    h('div', { class: 'settings' }, rounds.element, half.element, workers.element, start, again),
    problem,
    progress,
    h('div', { class: 'tables' }, h('div', {}, table.element, sums), h('details', { open: true }, h('summary', {}, words.games), list), paperTable()),
  );
  for (const { box } of boxes) box.addEventListener('change', reset);

  /** Forgets what was played. */
  function reset() {
    pool.stop();
    going = false;
    seconds = 0;
    teams = boxes.filter(({ box }) => box.checked).map(({ kind }) => kind);
    const seed = Number(session.scenario().seed);
    games = fixtures(teams.length, rounds.read()).map((game, index) => ({ ...game, seed: seed + index, goals: null }));
    common = { ...session.scenario(), 'half-seconds': half.read(), 'blue-coach': '', 'yellow-coach': '', 'blue-roles': '', 'yellow-roles': '', events: [] };
    const scenarios = games.map((game) => ({ ...common, seed: game.seed, blue: teams[game.blue], yellow: teams[game.yellow] }));
    pool.load(JSON.stringify(scenarios), games.map((_, index) => index));
    write(problem, teams.length < 2 ? words.few : '');
    rows.replaceChildren(
      ...games.map((game, index) => {
        const [blue, yellow] = [teams[game.blue], teams[game.yellow]].map((kind) => soccerText.kinds[kind]);
        const label = `${blue} – ${yellow}`;
        const show = button(label, () => void watch({ blue: teams[game.blue], yellow: teams[game.yellow], seed: games[index].seed, 'half-seconds': half.read() }), { class: 'chip', title: words.watch(blue, yellow, game.seed) });
        return h('tr', {}, h('th', { scope: 'row' }, show), h('td', {}, game.seed), h('td', {}));
      }),
    );
    show();
  }

  async function toggle() {
    if (going) {
      pause();
      return;
    }
    if (games.length > 0 && games.every(({ goals }) => goals)) reset();
    if (games.length === 0) return;
    going = true;
    pool.resize(workers.read());
    show();
    await pool.go();
    show();
  }

  function pause() {
    if (!going) return;
    going = false;
    pool.pause();
    show();
  }

  function show() {
    const played = games.flatMap(({ blue, yellow, goals }) => (goals ? [/** @type {Game} */ ({ blue, yellow, goals })] : []));
    const ranking = standings(teams.length, played);
    table.show(ranking.map(({ team, points, played: count, won, tied, lost, scored, conceded }) => [soccerText.kinds[teams[team]], points, count, won, tied, lost, scored, conceded, scored - conceded]));
    const sum = (/** @type {'scored' | 'conceded'} */ what) => ranking.reduce((all, row) => all + row[what], 0);
    write(sums, words.sums(sum('scored'), sum('conceded')));
    write(progress, words.progress(played.length, games.length, seconds));
    games.forEach(({ goals }, index) => write(rows.rows[index].cells[2], goals ? `${goals[0]} : ${goals[1]}` : '–'));
    start.disabled = games.length === 0;
    write(start, going ? words.pause : played.length > 0 && played.length < games.length ? words.resume : words.start);
    element.dataset.going = String(going);
    element.dataset.played = String(played.length);
  }

  return {
    on: () => on,

    open() {
      on = true;
      frame.stages.prepend(element);
      if (games.length === 0) reset();
    },

    close() {
      on = false;
      pause();
      element.remove();
    },

    pause,
  };
}

/** @typedef {ReturnType<typeof createTournament>} Tournament */
