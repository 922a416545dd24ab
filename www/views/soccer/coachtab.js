import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { createTreeFigure } from '../treefigure.js';
import { createStateChart } from './statechart.js';

/** @import { SoccerSession } from '../../soccer/session.js' */
/** @import { TreeShapes } from '../../soccer/shapes.js' */
/** @import { Moment, Setting } from '../../soccer/types.js' */
/** @import { CoachText } from './coachtext.js' */
/** @import { Scopes } from './scopes.js' */

const words = soccerText.coach;

/**
 * The coach at this moment: its tree with what every node returned, or its state chart; and its text, to be edited.
 *
 * @param {{ scopes: Scopes, session: SoccerSession, setting: Setting, shapes: TreeShapes, moment: () => Moment | null, text: CoachText,
 *   openTree: (xml: string, title: string) => Promise<void> }} parts `openTree` shows a tree in the workbench
 */
export function createCoachTab({ scopes, session, setting, shapes, moment, text, openTree }) {
  /** @type {number | null} */
  let selected = null;
  const title = h('h2', {});
  const figure = createTreeFigure({ label: words.tree, select: (id) => ((selected = id), show()) });
  const frame = h('div', { class: 'tree-frame' }, figure.svg);
  const said = h('p', { class: 'said small' });
  const fault = h('p', { class: 'verdict bad' });
  const chart = createStateChart(setting);
  const nobody = h('p', { class: 'empty' }, words.nobody);
  const board = h('tbody', {});
  const details = h('details', {}, h('summary', {}, words.board), h('table', {}, h('thead', {}, h('tr', {}, ...words.boardColumns.map((column) => h('th', { scope: 'col' }, column)))), board));
  details.addEventListener('toggle', () => show());
  const edit = button(words.edit, () => text.toggle(scopes.team, 'coach'));
  const bench = button(words.workbench, () => void openTree(session.coachText(scopes.team) ?? '', words.workbenchTitle(soccerText.teams[scopes.team])));
  const ways = h('div', { class: 'row' }, edit, bench);
  const differences = h('details', {}, h('summary', {}, words.differences), h('ol', { class: 'differences' }, ...words.differenceList.map((line) => h('li', {}, line))));
  const element = h('div', { class: 'tab-body' }, scopes.element(), title, ways, text.element, fault, frame, said, chart.element, nobody, details, differences);
  new ResizeObserver(() => figure.fit(frame.clientWidth)).observe(frame);

  async function show() {
    const now = moment();
    if (!now) return;
    const team = now.teams[scopes.index()];
    const own = session.scenario()[`${scopes.team}-coach`] !== '';
    write(title, own && team.coach === 'tree' ? soccerText.own(words.title.tree) : words.title[team.coach]);
    write(fault, team.fault ? words.fault(team.fault) : '');
    fault.hidden = !team.fault;
    const tree = team.coach === 'tree';
    ways.hidden = !tree;
    text.element.hidden = !text.open(scopes.team) || !(tree || text.what() === 'roles');
    write(edit, text.element.hidden ? words.edit : words.hide);
    frame.hidden = !tree;
    said.hidden = !tree;
    details.hidden = !tree;
    chart.element.hidden = team.coach !== 'machine';
    nobody.hidden = team.coach !== 'nobody';
    if (team.coach === 'machine') chart.show(team, now.tick);
    if (!tree) return;
    const xml = session.coachText(scopes.team) ?? '';
    const nodes = await shapes.of('coach', xml, 'coach');
    if (!nodes || moment() !== now) return;
    const statuses = team.call.length > 0 ? team.call : team.statuses;
    figure.show(nodes.map((node) => ({ ...node, status: statuses[node.id] ?? 'IDLE' })), { shape: xml, selected });
    write(said, team.call.length > 0 ? words.call : words.play);
    if (details.open) board.replaceChildren(...team.board.map(([name, value]) => h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, value))));
  }

  return { element, show: () => void show(), svg: () => (chart.element.hidden ? figure.svg : chart.svg) };
}
