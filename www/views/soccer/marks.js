import { s } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { SoccerMatch } from '../../soccer/match.js' */

const HEIGHT = 16;

/** Whether a call follows a goal that counts. @param {import('../../soccer/types.js').Call} call */
export const isGoal = ({ rule }) => typeof rule === 'object' && 'goal' in rule;

/** The team that scored. @param {import('../../soccer/types.js').Call} call the kick-off of the other one */
export const scorer = ({ team }) => (team === 'blue' ? 'yellow' : 'blue');

/**
 * The events of a match over its scrubber: goals as triangles, calls as lines, swaps of roles as dots.
 *
 * @param {SoccerMatch} match
 */
export function createMarks(match) {
  const svg = s('svg', { class: 'marks', height: HEIGHT, preserveAspectRatio: 'none', 'aria-hidden': 'true' }, s('title', {}, soccerText.transport.marks));
  let width = 0;
  let shown = '';

  function show() {
    const end = Math.max(match.end(), 1);
    const key = `${width} ${end} ${match.calls.length} ${match.deeds.length} ${match.front()}`;
    if (key === shown || width === 0) return;
    shown = key;
    const x = (/** @type {number} */ frame) => Math.round((frame / end) * width * 10) / 10;
    const swaps = match.deeds.filter(({ kind }) => kind === 'swap').map(({ frame, team }) => `M${x(frame)} ${team === 'blue' ? 12 : 14.5}h0`);
    const calls = match.calls.filter((call) => !isGoal(call)).map(({ frame }) => `M${x(frame)} 0V9`);
    const goals = match.calls.filter(isGoal).map((call) => {
      const at = x(call.frame);
      const up = scorer(call) === 'blue';
      return s('path', { class: `goal-mark ${scorer(call)}`, d: up ? `M${at} 0l4 9h-8Z` : `M${at} 9l4 -9h-8Z` });
    });
    svg.replaceChildren(
      s('title', {}, soccerText.transport.marks),
      s('path', { class: 'swap-marks', d: swaps.join('') }),
      s('path', { class: 'call-marks', d: calls.join('') }),
      ...goals,
    );
  }

  new ResizeObserver(() => {
    width = svg.clientWidth;
    svg.setAttribute('viewBox', `0 0 ${Math.max(width, 1)} ${HEIGHT}`);
    show();
  }).observe(svg);

  return { svg, show };
}
