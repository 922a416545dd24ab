import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { isGoal, scorer } from './marks.js';

/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { SoccerPlayback } from '../../soccer/playback.js' */
/** @import { Call, Deed } from '../../soccer/types.js' */

const words = soccerText.log;
const MOST_ROWS = 400;

/** What a call is called: the goal that led to a kick-off counts more than the kick-off. @param {Call} call */
export function callTitle(call) {
  const named = call.team && soccerText.teams[call.team].toLowerCase();
  if (isGoal(call)) return soccerText.call.goal(scorer(call));
  return soccerText.call.what(soccerText.commands[call.command], named, call.quadrant);
}

/**
 * What referee and coaches did and why; each line leads to its moment.
 *
 * @param {{ match: SoccerMatch, playback: SoccerPlayback }} parts
 */
export function createLogTab({ match, playback }) {
  let filter = words.filters[0][0];
  const keys = words.filters.map(([value, label]) => ({ value, key: button(label, () => ((filter = value), show())) }));
  const rows = h('tbody', {});
  const empty = h('p', { class: 'empty' }, words.empty);
  const more = h('p', { class: 'status-key' });
  const table = h('table', { class: 'log' }, h('caption', {}, words.caption), h('thead', {}, h('tr', {}, ...words.columns.map((column) => h('th', { scope: 'col' }, column)))), rows);
  const element = h('div', { class: 'tab-body' }, h('div', { class: 'scopes', role: 'group', 'aria-label': words.show }, ...keys.map(({ key }) => key)), more, table, empty);
  let listed = '';
  /** @type {number[]} frame of each row */
  let frames = [];

  function show() {
    for (const { value, key } of keys) key.setAttribute('aria-pressed', String(value === filter));
    const key = `${filter} ${match.calls.length} ${match.deeds.length} ${match.calls.at(-1)?.frame}`;
    if (key !== listed) {
      listed = key;
      list();
    }
    const now = frames.findLastIndex((frame) => frame <= playback.tick);
    [...rows.rows].forEach((row, index) => row.classList.toggle('chosen', index === now));
  }

  function list() {
    /** @type {{ frame: number, row: () => HTMLTableRowElement }[]} */
    const lines = [];
    if (filter !== 'deeds') lines.push(...match.calls.map((call) => ({ frame: call.frame, row: () => ofCall(call) })));
    if (filter !== 'calls') lines.push(...match.deeds.map((deed) => ({ frame: deed.frame + 1, row: () => ofDeed(deed) })));
    lines.sort((a, b) => a.frame - b.frame);
    const left = Math.max(lines.length - MOST_ROWS, 0);
    const kept = lines.slice(left);
    frames = kept.map(({ frame }) => frame);
    rows.replaceChildren(...kept.map(({ row }) => row()));
    empty.hidden = kept.length > 0;
    table.hidden = kept.length === 0;
    write(more, left > 0 ? words.more(left) : '');
  }

  /** @param {Call} call */
  function ofCall(call) {
    const title = callTitle(call);
    return row(call.frame, title, h('b', {}, title), h('span', { class: 'reason' }, soccerText.call.because(call.reason)), isGoal(call) ? `goal ${scorer(call)}` : '');
  }

  /** @param {Deed} deed */
  function ofDeed({ frame, team, kind, text }) {
    const said = `${soccerText.teams[team]}: ${text.replaceAll('_', ' ')}`;
    return row(frame + 1, said, h('span', {}, said), null, `deed ${kind}`);
  }

  /** @param {number} frame @param {string} title @param {HTMLElement} what @param {HTMLElement | null} why @param {string} kind */
  function row(frame, title, what, why, kind) {
    const time = soccerText.exact(frame / 60);
    const go = button(time, () => (playback.pause(), playback.seek(frame)), { class: 'chip' });
    go.setAttribute('aria-label', words.go(time, title));
    return h('tr', { class: kind }, h('th', { scope: 'row' }, go), h('td', {}, what, why));
  }

  return { element, show };
}
