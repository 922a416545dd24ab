/**
 * @typedef {object} StudyFile
 * @property {string} name
 * @property {string} json
 *
 * @typedef {object} Committed results that the command line made
 * @property {string} file as in the repository
 * @property {() => Promise<string>} csv
 * @property {() => Promise<string>} spec the study of these results, which needs no presets
 */

/** The study files, those with values of the paper first. @returns {StudyFile[]} */
export function readStudies() {
  const texts = /** @type {Record<string, string>} */ (import.meta.glob('/studies/*.json', { query: '?raw', import: 'default', eager: true }));
  const files = Object.entries(texts).map(([path, json]) => ({ name: nameOf(path), json }));
  const first = (/** @type {StudyFile} */ file) => Number(!['paper', 'matches'].some((field) => field in JSON.parse(file.json)));
  return files.sort((a, b) => first(a) - first(b) || (a.name < b.name ? -1 : 1));
}

/** The scenarios that a study may name. @returns {Record<string, string>} */
export function readPresets() {
  const texts = /** @type {Record<string, string>} */ (import.meta.glob('/scenarios/*.json', { query: '?raw', import: 'default', eager: true }));
  return Object.fromEntries(Object.entries(texts).map(([path, json]) => [nameOf(path), json]));
}

/** The committed results of a study, fetched when they are asked for; null when there are none. @param {string} name @returns {Committed | null} */
export function committedResults(name) {
  const csv = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('/results/*.csv', { query: '?raw', import: 'default' }));
  const specs = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('/results/*.study.json', { query: '?raw', import: 'default' }));
  const [path, spec] = [`/results/${name}.csv`, `/results/${name}.study.json`];
  return csv[path] && specs[spec] ? { file: path.slice(1), csv: csv[path], spec: specs[spec] } : null;
}

/** @param {string} path */
const nameOf = (path) => path.slice(path.lastIndexOf('/') + 1, -'.json'.length);
