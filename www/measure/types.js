/**
 * What the page and its worker that measures say to each other. Types only, no code.
 *
 * @typedef {{ id: number, name: string, share: number }} ToWorker `share` of the whole amount
 *
 * @typedef {object} Measured
 * @property {number} amount in the unit of the measure
 * @property {number} seconds
 * @property {string} [fingerprint] of what was computed; the same on every machine
 * @property {number} [each] seconds of one search, the median
 * @property {number} [integrated] intervals that were simulated; the same on every machine
 *
 * @typedef {object} Row one line of the table
 * @property {string} name
 * @property {Measured[]} rounds
 */
export {};
