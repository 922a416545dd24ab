/** @import { Path, Scenario, Task } from './types.js' */

/**
 * Trajectories as CSV: a row for each robot and moment.
 *
 * @param {Task} task
 * @param {Path} path
 * @param {number} every steps between two moments
 */
export function trajectoriesCsv(task, path, every) {
  const robots = task.start.length;
  const lines = ['seconds,interval,behaviour,robot,x,y,heading'];
  const letters = [...path.letters];
  for (let step = 0; step < path.frames; step += 1) {
    if (step % every !== 0 && step !== path.frames - 1) continue;
    const interval = Math.min(Math.floor(step / task.steps), letters.length - 1);
    for (let robot = 0; robot < robots; robot += 1) {
      const at = (step * robots + robot) * 3;
      const [x, y, heading] = path.poses.subarray(at, at + 3);
      lines.push(`${(step / 10).toFixed(1)},${interval + 1},${letters[interval]},${robot + 1},${x.toFixed(4)},${y.toFixed(4)},${heading.toFixed(5)}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/**
 * A plan with everything that it is of: opened again, the scenario is planned for anew.
 *
 * @param {{ version: string, scenario: Scenario, task: Task, path: Path, byHand: boolean, proof: { cost: number | null, lower_bound: number | null, proven_ratio: number | null } }} what
 */
export function planJson({ version, scenario, task, path, byHand, proof }) {
  const { letters, replay } = path;
  const behaviours = [...letters].map((letter) => task.library.find((behaviour) => behaviour.letter === letter)?.name ?? letter);
  const plan = { version, letters, behaviours, by_hand: byHand, ...replay, best_known_cost: proof.cost, lower_bound: proof.lower_bound, proven_ratio: proof.proven_ratio, scenario };
  return `${JSON.stringify({ plan }, null, 2)}\n`;
}
