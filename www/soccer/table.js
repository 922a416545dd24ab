/**
 * @typedef {{ blue: number, yellow: number, goals: [number, number] }} Game two teams by their place in the list, and what each scored
 *
 * @typedef {object} Standing a row of the table
 * @property {number} team
 * @property {number} points
 * @property {number} played
 * @property {number} won
 * @property {number} tied
 * @property {number} lost
 * @property {number} scored
 * @property {number} conceded
 */

const [VICTORY, TIE] = [3, 1];

/** Goals scored over conceded. @param {Standing} standing */
export const difference = ({ scored, conceded }) => scored - conceded;

/** Every pair of teams once in each round; sides change from round to round. @param {number} teams @param {number} rounds @returns {{ blue: number, yellow: number, round: number }[]} */
export function fixtures(teams, rounds) {
  const games = [];
  for (let round = 0; round < rounds; round += 1) {
    for (let first = 0; first < teams; first += 1) {
      for (let second = first + 1; second < teams; second += 1) {
        games.push(round % 2 === 0 ? { blue: first, yellow: second, round } : { blue: second, yellow: first, round });
      }
    }
  }
  return games;
}

/**
 * The table of a tournament, the first first. Order: points, goal difference, goals scored, direct result, place in the list.
 *
 * @param {number} teams
 * @param {Game[]} games
 * @returns {Standing[]}
 */
export function standings(teams, games) {
  const table = Array.from({ length: teams }, (_, team) => ({ team, points: 0, played: 0, won: 0, tied: 0, lost: 0, scored: 0, conceded: 0 }));
  for (const { blue, yellow, goals } of games) {
    enter(table[blue], goals[0], goals[1]);
    enter(table[yellow], goals[1], goals[0]);
  }
  return table.sort((a, b) => b.points - a.points || difference(b) - difference(a) || b.scored - a.scored || direct(games, b.team, a.team) || a.team - b.team);
}

/** @param {Standing} row @param {number} scored @param {number} conceded */
function enter(row, scored, conceded) {
  row.played += 1;
  row.scored += scored;
  row.conceded += conceded;
  if (scored > conceded) row.won += 1;
  else if (scored === conceded) row.tied += 1;
  else row.lost += 1;
  row.points += scored > conceded ? VICTORY : scored === conceded ? TIE : 0;
}

/** Points of one team over another's in the games between them. @param {Game[]} games @param {number} one @param {number} other */
function direct(games, one, other) {
  let sum = 0;
  for (const { blue, yellow, goals } of games) {
    const sign = Math.sign(goals[0] - goals[1]);
    if (blue === one && yellow === other) sum += sign;
    if (blue === other && yellow === one) sum -= sign;
  }
  return sum;
}
