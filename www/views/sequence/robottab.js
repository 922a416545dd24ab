import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Hold } from '../../sequence/hold.js' */
/** @import { Planner } from '../../sequence/planner.js' */
/** @import { Playback } from '../../sequence/playback.js' */

const DEGREES = 180 / Math.PI;

/**
 * All robots at the moment on screen: place, heading, way gone, distance to the target.
 *
 * @param {{ planner: Planner, playback: Playback, hold: Hold }} parts
 */
export function createRobotTab({ planner, playback, hold }) {
  const caption = h('caption', {});
  const heads = sequenceText.robots.columns.map((column) => h('th', { scope: 'col' }, column));
  const rows = h('tbody', {});
  const element = h('div', { class: 'tab-body' }, h('table', { class: 'robot-table' }, caption, h('thead', {}, h('tr', {}, ...heads)), rows));
  /** @type {Float64Array} metres gone by each robot up to each step, of the path `measured` */
  let lengths = new Float64Array(0);
  /** @type {object | null} */
  let measured = null;

  /** Robots move straight within a step, so the ways between poses are exact but for rounding. */
  function measure() {
    const { path } = playback;
    const robots = planner.task?.start.length ?? 0;
    if (!path || path === measured) return;
    measured = path;
    lengths = new Float64Array(path.frames * robots);
    for (let at = robots; at < lengths.length; at += 1) {
      const before = at - robots;
      lengths[at] = lengths[before] + Math.hypot(path.poses[3 * at] - path.poses[3 * before], path.poses[3 * at + 1] - path.poses[3 * before + 1]);
    }
  }

  return {
    element,
    show() {
      const { task } = planner;
      const { path, step } = playback;
      if (!task) return;
      measure();
      const robots = task.start.length;
      const moving = path !== null && path.poses.length >= (step + 1) * robots * 3;
      write(caption, sequenceText.robots.caption((moving ? step : 0) / 10));
      const target = 'target' in task.goal ? task.goal.target : null;
      heads[5].hidden = target === null;
      rows.replaceChildren(
        ...task.start.map((start, robot) => {
          const at = (step * robots + robot) * 3;
          const [x, y, heading] = moving ? path.poses.subarray(at, at + 3) : start;
          const turns = (((heading * DEGREES) % 360) + 360) % 360;
          const far = target ? Math.max(0, Math.hypot(x - target[0], y - target[1]) - target[2]) : 0;
          const gone = moving ? lengths[step * robots + robot] : 0;
          const name = button(String(robot + 1), () => hold.choose({ kind: 'robot', index: robot }), { class: 'chip' });
          name.setAttribute('aria-label', sequenceText.tools.thing('robot', robot));
          const cells = [x.toFixed(1), y.toFixed(1), turns.toFixed(0), gone.toFixed(1), ...(target ? [far > 0 ? far.toFixed(1) : sequenceText.robots.inside] : [])];
          return h('tr', { class: hold.chosen?.kind === 'robot' && hold.chosen.index === robot ? 'chosen' : undefined }, h('th', { scope: 'row' }, name), ...cells.map((cell) => h('td', {}, cell)));
        }),
      );
    },
  };
}
