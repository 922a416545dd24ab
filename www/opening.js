/**
 * The moment that a visitor without a link sees first: drawn when the page is built, and reached by the engine from preset
 * and seed. Of the first 120 seeds this one has the most robots under way with food at that tick, which a slow computer
 * reaches in less than a second.
 */
export const OPENING = { preset: 'foraging', seed: 75, tick: 200 };
