import { ASPECT, drawMatch } from '../../draw/soccer.js';

/** @import { PitchScene, PitchTheme } from '../../draw/soccer.js' */

const GAP = 20;
const SIDE = 440; // width of one pitch
const EDGE = 12; // on both sides of the words
const LINES = [22, 42]; // base lines of the words, below the pitch
const PITCH = Math.round(SIDE / ASPECT);

export const WIDTH = 2 * SIDE + GAP;
export const HEIGHT = PITCH + 56;

/** @typedef {{ scene: Omit<PitchScene, 'width' | 'height'> | null, score: string, time: string }} Half what stands on one side, and who plays how in it */

/**
 * Two matches side by side, each with its words below.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Half[]} halves
 * @param {PitchTheme} theme
 */
export function paintBoth(context, halves, theme) {
  halves.forEach(({ scene, score, time }, index) => {
    context.save();
    context.translate(index * (SIDE + GAP), 0);
    if (scene) drawMatch(context, { ...scene, width: SIDE, height: PITCH }, theme);
    context.textAlign = 'start';
    context.fillStyle = theme.ink;
    context.font = `600 14px ${theme.font}`;
    context.fillText(score, EDGE, PITCH + LINES[0], SIDE - 2 * EDGE); // long names are drawn narrower
    context.fillStyle = theme.secondary;
    context.font = `13px ${theme.font}`;
    context.fillText(time, EDGE, PITCH + LINES[1], SIDE - 2 * EDGE);
    context.restore();
  });
}
