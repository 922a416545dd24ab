/** @typedef {{ name: string, title: string, about: string, json: string }} Preset */

const OPENING = 'match';

/** The presets of soccer, which are files, read alike by the page, the command line and the tests. @returns {Preset[]} the opening one first */
export function readPresets() {
  const files = /** @type {Record<string, string>} */ (import.meta.glob('/scenarios/match*.json', { query: '?raw', import: 'default', eager: true }));
  return Object.entries(files)
    .map(([path, json]) => {
      const name = path.replace(/^.*\/|\.json$/g, '');
      const { title, about } = JSON.parse(json);
      return { name, title: String(title ?? name), about: String(about ?? ''), json };
    })
    .sort((a, b) => Number(b.name === OPENING) - Number(a.name === OPENING) || a.name.localeCompare(b.name));
}
