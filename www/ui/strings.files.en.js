const plural = (/** @type {number} */ count, /** @type {string} */ one) => `${count} ${count === 1 ? one : `${one}s`}`;

/** Texts of files that are opened and saved: populations and scenarios. */
export const filesText = {
  populationSave: 'Save population',
  populationSaveLong: "The robots' programs of this moment as a file, for this page and for the command line",
  populationOpen: 'Open population',
  paste: 'Paste a population',
  pasted: 'Open what is pasted',
  pastedName: 'the pasted text',
  remove: 'Remove',
  none: 'None: every robot starts with a random program.',
  /** @param {number} count @param {{ title: string, seed: number | null, tick: number | null }} from */
  loaded: (count, { title, seed, tick }) => {
    const origin = [title && `from “${title}”`, seed !== null && `seed ${seed}`, tick !== null && `tick ${tick}`].filter((part) => part);
    return `${plural(count, 'program')}${origin.length > 0 ? ` ${origin.join(', ')}` : '; the file does not say where they come from'}.`;
  },
  opened: (/** @type {string} */ name, /** @type {string} */ what) => `${name} is opened: ${what} The run starts again at tick 0.`,
  scenarioOpened: (/** @type {string} */ name, /** @type {string} */ title) => `${name} is opened${title ? `: ${title}` : ''}.`,
  refused: (/** @type {string} */ name, /** @type {string} */ why) => `${name} was not opened, and nothing changed: ${why}.`,
  unreadable: (/** @type {string} */ name) => `${name} could not be read.`,
  tooLarge: (/** @type {string} */ name, /** @type {number} */ bytes) => `${name} was not opened: it has ${bytes} bytes, expected at most 10000000.`,
  many: (/** @type {number} */ count) => `One file at a time: ${count} were dropped, the first is opened.`,
  drop: 'Drop a population or a scenario to open it',
};
