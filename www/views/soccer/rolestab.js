import { countOf } from '../../soccer/stretches.js';
import { button, h, s, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { createTreeFigure } from '../treefigure.js';

/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { SoccerPlayback } from '../../soccer/playback.js' */
/** @import { SoccerSession } from '../../soccer/session.js' */
/** @import { TreeShapes } from '../../soccer/shapes.js' */
/** @import { Stretches } from '../../soccer/stretches.js' */
/** @import { Moment, Setting } from '../../soccer/types.js' */
/** @import { Scopes } from './scopes.js' */

const words = soccerText.rolesTab;
const ROW = 24;
const LABEL = 16; // room for the robots' numbers
const DEFENDING = new Set(['fullback', 'wingback', 'penalty_defender']);

/**
 * Who held which role when, with the swaps, and the tree of one robot's role.
 *
 * @param {{ scopes: Scopes, match: SoccerMatch, playback: SoccerPlayback, session: SoccerSession, setting: Setting, shapes: TreeShapes,
 *   stretches: Stretches, moment: () => Moment | null }} parts
 */
export function createRolesTab({ scopes, match, playback, session, setting, shapes, stretches, moment }) {
  let seconds = 20; // 0 is the whole match
  let robot = 0;
  const keys = words.windows.map(([value, label]) => {
    const key = button(label, () => ((seconds = Number(value)), show()));
    return { value: Number(value), key };
  });
  const svg = s('svg', { class: 'role-line', height: 3 * ROW + 12, role: 'img' });
  const title = s('title', {});
  const counts = h('p', { class: 'said small' });
  const rows = [0, 1, 2].map((index) => {
    const choose = button('', () => ((robot = index), show()), { class: 'chip' });
    const [role, since] = [h('td', {}), h('td', {})];
    return { choose, role, since, row: h('tr', {}, h('th', { scope: 'row' }, choose), role, since) };
  });
  const table = h('table', { class: 'who' }, h('caption', {}, words.caption), h('thead', {}, h('tr', {}, ...words.columns.map((column) => h('th', { scope: 'col' }, column)))), h('tbody', {}, ...rows.map(({ row }) => row)));
  const treeTitle = h('h2', {});
  const figure = createTreeFigure({ label: words.treeLabel, select: () => {} });
  const frame = h('div', { class: 'tree-frame' }, figure.svg);
  const line = h('div', { class: 'role-frame' }, svg);
  const element = h(
    'div',
    { class: 'tab-body' },
    scopes.element(),
    h('div', { class: 'scopes', role: 'group', 'aria-label': words.window }, ...keys.map(({ key }) => key)),
    line,
    counts,
    table,
    h('p', { class: 'status-key' }, words.key),
    h('p', { class: 'status-key' }, words.short),
    treeTitle,
    frame,
  );
  let width = 0;
  new ResizeObserver(() => {
    width = line.clientWidth;
    figure.fit(frame.clientWidth);
    draw();
  }).observe(line);

  /** The stretch of time that is shown. @returns {[number, number]} */
  function span() {
    if (seconds === 0) return [0, Math.max(match.end(), 1)];
    const half = seconds * 30;
    return [playback.tick - half, playback.tick + half];
  }

  function draw() {
    if (width === 0) return;
    const [from, to] = span();
    const x = (/** @type {number} */ tick) => LABEL + ((Math.min(Math.max(tick, from), to) - from) / (to - from)) * (width - LABEL);
    svg.setAttribute('viewBox', `0 0 ${width} ${3 * ROW + 12}`);
    svg.setAttribute('width', String(width));
    /** @type {SVGElement[]} */
    const parts = [];
    for (let index = 0; index < 3; index += 1) {
      const top = index * ROW + 12;
      parts.push(s('text', { class: 'role-robot', x: 0, y: top + ROW / 2, dy: '0.35em' }, String(index + 1)));
      for (const stretch of stretches.of(scopes.index() * 3 + index)) {
        const end = Math.min(stretch.to, match.front());
        if (end < from || stretch.from > to || end <= 0) continue;
        const role = setting.roles[stretch.role];
        const [left, right] = [x(stretch.from), x(end)];
        parts.push(s('rect', { class: `role-box ${DEFENDING.has(role) ? 'defends' : ''} ${role === 'goalkeeper' ? 'keeps' : ''}`, x: left, y: top + 2, width: Math.max(right - left, 0.5), height: ROW - 5 }));
        if (right - left > 20) parts.push(s('text', { class: 'role-name', x: (left + right) / 2, y: top + ROW / 2, dy: '0.35em', 'text-anchor': 'middle' }, soccerText.short[role]));
      }
    }
    const swaps = match.deeds.filter(({ team, kind, frame: at }) => team === scopes.team && kind === 'swap' && at >= from && at <= to);
    parts.push(s('path', { class: 'role-swaps', d: swaps.map(({ frame: at }) => `M${x(at)} 9l-3.5 -6h7Z`).join('') }));
    parts.push(s('path', { class: 'role-now', d: `M${x(playback.tick)} 0V${3 * ROW + 12}` }));
    svg.replaceChildren(title, ...parts);
  }

  function show() {
    for (const { value, key } of keys) key.setAttribute('aria-pressed', String(value === seconds));
    const label = words.windows.find(([value]) => Number(value) === seconds)?.[1] ?? '';
    write(title, words.line(label));
    const { tick } = playback;
    write(counts, words.counts(soccerText.teams[scopes.team], countOf(match.deeds, scopes.team, 'swap', tick), countOf(match.deeds, scopes.team, 'group', tick)));
    rows.forEach(({ choose, role, since, row }, index) => {
      const at = stretches.at(scopes.index() * 3 + index, tick);
      const name = at ? setting.roles[at.role] : '';
      write(choose, soccerText.pitch.thing(soccerText.teams[scopes.team], index + 1));
      choose.setAttribute('aria-pressed', String(index === robot));
      row.classList.toggle('chosen', index === robot);
      write(role, soccerText.roles[name] ?? '');
      write(since, at ? words.ago((tick - at.from) / 60) : '');
    });
    draw();
    void showTree();
  }

  async function showTree() {
    const now = moment();
    if (!now) return;
    const team = now.teams[scopes.index()];
    const role = team.duties.roles[robot];
    write(treeTitle, words.tree(soccerText.roles[role] ?? role, soccerText.pitch.thing(soccerText.teams[scopes.team], robot + 1)));
    const xml = session.rolesText(scopes.team);
    const nodes = await shapes.of('roles', xml, role);
    if (!nodes || moment() !== now) return;
    const statuses = team.roles[robot];
    figure.show(nodes.map((node) => ({ ...node, status: statuses[node.id] ?? 'IDLE' })), { shape: `${role} ${xml}` });
  }

  return { element, show };
}
