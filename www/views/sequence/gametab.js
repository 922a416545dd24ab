import { metres, ratioOf } from '../../sequence/words.js';
import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Game } from '../../sequence/game.js' */
/** @import { Planner } from '../../sequence/planner.js' */
/** @import { Playback } from '../../sequence/playback.js' */

const words = sequenceText.game;

/**
 * Beat the planner: the rules, the behaviours to choose from, the clock, and the result beside what the planner proves.
 *
 * @param {{ game: Game, planner: Planner, playback: Playback }} parts
 */
export function createGameTab({ game, planner, playback }) {
  const begin = button(words.begin, game.begin, { class: 'primary' });
  begin.id = 'sequence-game-begin';
  const end = button(words.end, game.end);
  const pace = h('select', { id: 'sequence-pace' }, ...words.paces.map(([value, label]) => h('option', { value }, label)));
  pace.value = String(game.pace());
  pace.addEventListener('change', () => game.setPace(Number(pace.value)));
  const clock = h('progress', { class: 'sequence-clock', max: 1, value: 0, 'aria-label': words.clock });
  const said = h('p', { class: 'game-said' });
  const keys = h('div', { class: 'game-keys', role: 'group', 'aria-label': words.choose });
  const result = h('p', { class: 'game-result', id: 'sequence-game-result' });
  const beside = h('p', { id: 'sequence-game-planner' });
  const best = h('p', { class: 'secondary' });
  const element = h(
    'div',
    { class: 'tab-body' },
    h('p', {}, words.rules),
    h('div', { class: 'row' }, begin, end, h('label', { for: pace.id }, words.pace), pace),
    said,
    clock,
    keys,
    result,
    beside,
    best,
  );
  let library = '';

  function show() {
    const { task } = planner;
    if (!task) return;
    const playing = game.hides();
    end.hidden = game.stage === 'off';
    write(begin, game.stage === 'off' ? words.begin : words.again);
    keys.hidden = !playing;
    clock.hidden = !playing;
    const written = task.library.map(({ letter }) => letter).join('');
    if (written !== library) {
      library = written;
      keys.replaceChildren(...task.library.map(({ letter, name }) => h('button', { type: 'button', 'data-letter': letter, onclick: () => void game.choose(letter) }, h('b', {}, letter), ` ${name}`)));
    }
    const now = [...game.letters()];
    for (const key of keys.children) {
      const letter = key.getAttribute('data-letter');
      key.setAttribute('aria-pressed', String(letter === (game.chosen() ?? (game.stage === 'on' ? now[now.length - 1] : null))));
    }
    const name = task.library.find(({ letter }) => letter === now[now.length - 1])?.name ?? '';
    write(said, game.stage === 'ready' ? words.first : game.stage === 'on' ? words.now(now.length, task.decisions, name, game.waits()) : '');
    showClock();
    const ended = game.result();
    write(result, ended ? words.result(ended.goal, ended.collided, metres(ended.cost), ended.letters) : '');
    write(beside, ended ? planned(ended.goal ? ended.cost : null) : '');
    const known = game.best();
    write(best, known ? words.best(metres(known.cost), known.letters) : '');
  }

  function showClock() {
    const steps = planner.task?.steps ?? 1;
    clock.value = game.stage === 'on' && playback.path ? (playback.step - game.interval() * steps) / steps : 0;
  }

  /** What the planner has to say about it by now. @param {number | null} cost of the player; null when the goal was missed */
  function planned(cost) {
    const { cost: theirs = null, lower_bound: bound = null } = planner.progress ?? {};
    if (theirs === null) return planner.status === 'ended' ? words.plannerNone : words.plannerSearches;
    const promise = bound === null ? '' : words.bound(metres(bound), cost === null ? null : ratioOf(Math.max(1, cost / bound)));
    const against = cost === null ? words.planner(metres(theirs)) : words.against(metres(theirs), cost / theirs - 1);
    return `${against} ${promise}${planner.status === 'searching' ? ` ${words.improving}` : ''}`;
  }

  playback.on(() => game.hides() && showClock());
  return { element, show };
}
