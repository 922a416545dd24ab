/** @import { Values } from './lessons.js' */

const TEXTS = /** @type {Record<string, string>} */ (import.meta.glob('/scenarios/*.json', { query: '?raw', import: 'default', eager: true }));

/**
 * A scenario file with other fields, as text for the engine.
 *
 * @param {string} preset
 * @param {Values} values
 */
export function scenarioText(preset, values) {
  return JSON.stringify({ ...JSON.parse(TEXTS[`/scenarios/${preset}.json`]), ...values });
}

