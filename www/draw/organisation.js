/** @import { Organisation } from '../soccer/types.js' */

export const SHEET = { width: 316, height: 300 };
const ROLE = { width: 120, height: 26 };
const COLUMN = { attack: 76, defend: 240 };
const GROUP = 146;
const TOP = 116;
const STEP = 44;

/** In which row a role stands, so that roles that a robot exchanges when the group changes face each other. @type {Record<string, [attack: number, defend: number]>} */
const ROWS = { goalkeeper: [0, 0], striker: [1, 1], wingback: [1, 1], assistant: [2, 2], fullback: [2, 2], penalty_kicker: [3, 3], penalty_defender: [3, 3] };

/**
 * @typedef {{ mode: string, role: string, x: number, y: number, inner: number, width: number, height: number, bounds: string }} RoleBox `inner` is where its players stand
 * @typedef {{ mode: string, x: number, y: number, width: number, height: number }} GroupBox
 * @typedef {{ d: string, scope: 'intra_group' | 'inter_group' }} Line
 */

/**
 * Where the organisation's groups, roles and compatibilities are drawn.
 *
 * @param {Organisation} organisation
 */
export function organisationDrawing({ structural }) {
  /** @type {RoleBox[]} */
  const roles = [];
  /** @type {GroupBox[]} */
  const groups = [];
  for (const { mode, roles: inside } of structural.groups) {
    const x = mode === 'attack' ? COLUMN.attack : COLUMN.defend;
    groups.push({ mode, x: x - GROUP / 2, y: TOP - 36, width: GROUP, height: 4 * STEP + 22 });
    for (const { role, least, most } of inside) {
      const row = ROWS[role]?.[mode === 'attack' ? 0 : 1] ?? 0;
      const inner = x + (mode === 'attack' ? 1 : -1) * (GROUP / 2 + 9);
      roles.push({ mode, role, x, y: TOP + row * STEP, inner, ...ROLE, bounds: `${least}..${most}` });
    }
  }
  const find = (/** @type {string} */ mode, /** @type {string} */ role) => roles.find((box) => box.mode === mode && box.role === role);
  /** @type {Line[]} */
  const lines = [];
  for (const { scope, from, to } of structural.compatibilities) {
    if (scope === 'inter_group') {
      const [a, b] = [find('attack', from) ?? find('attack', to), find('defend', to) ?? find('defend', from)];
      if (a && b) lines.push({ scope, d: `M${a.x + ROLE.width / 2} ${a.y}L${b.x - ROLE.width / 2} ${b.y}` });
      continue;
    }
    for (const mode of ['attack', 'defend']) {
      const [a, b] = [find(mode, from), find(mode, to)];
      if (!a || !b) continue;
      const out = (mode === 'attack' ? -1 : 1) * (ROLE.width / 2);
      const bend = out + Math.sign(out) * (Math.abs(a.y - b.y) > STEP ? 12 : 6);
      lines.push({ scope, d: `M${a.x + out} ${a.y}C${a.x + bend} ${a.y} ${b.x + bend} ${b.y} ${b.x + out} ${b.y}` });
    }
  }
  const coach = { x: SHEET.width / 2, y: 24, ...ROLE };
  const authority = groups.map(({ x, y, width }) => `M${coach.x} ${coach.y + ROLE.height / 2}L${x + width / 2} ${y - 2}`);
  return { roles, groups, lines, coach, authority };
}
