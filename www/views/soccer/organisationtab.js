import { SHEET, organisationDrawing } from '../../draw/organisation.js';
import { h, s, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { Moment, Organisation, Setting } from '../../soccer/types.js' */
/** @import { Scopes } from './scopes.js' */

const words = soccerText.organisation;

/**
 * The organisation as MOISE+ has it, with the group that is active and the roles that are played, and whether anything broke it.
 *
 * @param {{ scopes: Scopes, setting: Setting, moment: () => Moment | null }} parts
 */
export function createOrganisationTab({ scopes, setting, moment }) {
  const { organisation } = setting;
  const drawing = organisationDrawing(organisation);
  const title = s('title', {});
  const groups = drawing.groups.map(({ mode, x, y, width, height }) =>
    s('g', { class: 'org-group', 'data-mode': mode }, s('rect', { x, y, width, height, rx: 4 }), s('text', { x: x + width / 2, y: y + 14, 'text-anchor': 'middle' }, words.groups[mode])),
  );
  const roles = drawing.roles.map(({ mode, role, x, y, inner, width, height, bounds }) => {
    const players = s('text', { class: 'org-players', x: inner, y: y - 11, 'text-anchor': 'middle' });
    return {
      mode,
      role,
      players,
      element: s(
        'g',
        { class: 'org-role' },
        s('rect', { x: x - width / 2, y: y - height / 2, width, height, rx: height / 2 }),
        s('text', { x: x - width / 2 + 8, y, dy: '0.35em' }, soccerText.roles[role].replace('Penalty ', 'Pen. ')),
        s('text', { class: 'org-bounds', x: x + width / 2 - 7, y, dy: '0.35em', 'text-anchor': 'end' }, bounds),
        players,
      ),
    };
  });
  const { coach } = drawing;
  const svg = s(
    'svg',
    { class: 'organisation', viewBox: `0 0 ${SHEET.width} ${SHEET.height}`, role: 'img' },
    title,
    s('path', { class: 'org-authority', d: drawing.authority.join('') }),
    s('text', { class: 'org-note', x: coach.x, y: 60, 'text-anchor': 'middle' }, words.authority),
    s('rect', { class: 'org-coach', x: coach.x - coach.width / 2, y: coach.y - coach.height / 2, width: coach.width, height: coach.height, rx: coach.height / 2 }),
    s('text', { class: 'org-name', x: coach.x, y: coach.y, dy: '0.35em', 'text-anchor': 'middle' }, `${soccerText.roles.coach} 1..1`),
    ...groups,
    ...drawing.lines.map(({ d, scope }) => s('path', { class: `org-line ${scope}`, d })),
    ...roles.map(({ element }) => element),
  );
  const violations = h('p', { class: 'violations' });
  const refused = h('p', { class: 'verdict bad' });
  const element = h(
    'div',
    { class: 'tab-body' },
    scopes.element(),
    svg,
    violations,
    refused,
    h('p', { class: 'status-key' }, words.key),
    h('p', { class: 'status-key' }, words.links),
    details(words.formations, list(organisation.structural.groups.flatMap(({ mode, formations }) => formations.map(({ roles: inside }) => `${words.groups[mode]}: ${inside.map((role) => soccerText.roles[role]).join(', ')}`)))),
    details(words.duties, duties(organisation)),
    details(words.goals, goals(organisation, organisation.functional.goals[0]?.id)),
    h('p', { class: 'status-key' }, words.wording),
  );

  return {
    element,
    show() {
      const now = moment();
      if (!now) return;
      const team = now.teams[scopes.index()];
      const { mode, roles: held } = team.duties;
      write(title, words.drawing(soccerText.teams[scopes.team], words.groups[mode]));
      for (const group of groups) group.classList.toggle('active', group.dataset.mode === mode);
      for (const { mode: of, role, players, element: box } of roles) {
        const robots = of === mode ? held.flatMap((name, robot) => (name === role ? [robot + 1] : [])) : [];
        box.classList.toggle('held', robots.length > 0);
        write(players, robots.map((robot) => words.player(robot)).join(' '));
      }
      write(violations, words.violations(team.violations));
      write(refused, team.refused ? words.lastRefused(team.refused) : '');
      refused.hidden = !team.refused;
    },
  };
}

/** @param {string} summary @param {HTMLElement} body */
const details = (summary, body) => h('details', {}, h('summary', {}, summary), body);

/** @param {string[]} lines */
const list = (lines) => h('ul', { class: 'plain-list' }, ...lines.map((line) => h('li', {}, line)));

/** @param {Organisation} organisation */
function duties({ deontic, functional }) {
  const rows = deontic.map(({ role, relation, mission, when }) => {
    const { title = mission } = functional.missions.find(({ id }) => id === mission) ?? {};
    return h('tr', {}, h('th', { scope: 'row' }, soccerText.roles[role]), h('td', {}, words.relation[relation]), h('td', {}, `${title}${when ? `, when ${when}` : ''}`));
  });
  return h('table', { class: 'duties' }, h('thead', {}, h('tr', {}, ...words.dutyColumns.map((column) => h('th', { scope: 'col' }, column || h('span', { class: 'unseen' }, '–'))))), h('tbody', {}, ...rows));
}

/** A goal and the goals it consists of. @param {Organisation} organisation @param {string} id @returns {HTMLElement} */
function goals(organisation, id) {
  const goal = organisation.functional.goals.find((candidate) => candidate.id === id);
  if (!goal) return h('ul', {});
  const plan = goal.plan ? h('span', { class: 'secondary' }, `: ${words.plans[goal.plan]}`) : null;
  return h('ul', { class: 'plain-list' }, h('li', {}, goal.title, plan, ...(goal.parts ?? []).map((part) => goals(organisation, part))));
}
