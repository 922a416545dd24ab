/**
 * @typedef {object} MeasureWords
 * @property {string} title
 * @property {string} unit what is counted; empty where nothing is a second
 * @property {string} file
 * @property {string} [peer] what another program was measured at
 * @property {string} [source] by whom, and how
 */

const CLOUD = 'measured for this project on a cloud machine with two cores';

/** Texts of the page #/bench. */
export const measureText = {
  title: 'How fast is this browser?',
  lede: 'The numbers of make bench, measured in your browser by one worker. Nothing else should be busy meanwhile; single rounds scatter, so let it make several. What was computed is the same on every machine: compare the fingerprints.',
  run: 'Measure',
  again: 'Measure once more',
  stop: 'Stop',
  short: 'Short: a twentieth of it',
  csv: 'CSV',
  csvLong: 'Every round with browser, processors and version',
  none: 'Nothing is measured yet.',
  running: (/** @type {string} */ title) => `Measuring: ${title}`,
  finished: (/** @type {number} */ rounds) => `Measured, ${rounds} ${rounds === 1 ? 'round' : 'rounds'}`,
  stopped: 'Stopped. What was measured stands.',
  failed: (/** @type {string} */ title, /** @type {string} */ why) => `${title} could not be measured: ${why}`,
  caption: 'Medians over the rounds',
  columns: ['What', 'Here', 'Rounds', 'Fingerprint or count', 'Another program'],
  rate: (/** @type {string} */ number, /** @type {string} */ unit) => `${number} ${unit}/s`,
  each: (/** @type {string} */ ms) => `${ms} ms a search`,
  whole: (/** @type {string} */ seconds) => `${seconds} s for ten minutes of play`,
  memory: (/** @type {string} */ megabytes) => `${megabytes} MB`,
  integrated: (/** @type {number} */ count) => `${count} integrations`,
  honest: 'Other programs do not do quite the same and ran on other machines: take the figures as orders of magnitude.',
  /** @type {Record<string, MeasureWords>} */
  measures: {
    foraging: { title: 'Swarm that evolves, 12,000 steps of 100 robots', unit: 'robot-steps', file: 'scenarios/foraging.json' },
    published: {
      title: 'The authors’ published program, 12,000 steps of 100 robots',
      unit: 'robot-steps',
      file: 'scenarios/published.json',
      peer: '133 to 245 robot-steps/s',
      source: `the authors’ public Python code over its first 250 steps, processor time, ${CLOUD}`,
    },
    fixed: { title: 'Swarm with one fixed tree, 20,000 steps', unit: 'robot-steps', file: 'scenarios/hand-tree.json' },
    tree: {
      title: 'Reactive behaviour tree of 18 nodes',
      unit: 'root ticks',
      file: 'tests/cases/reactive_tree.json',
      peer: '38,000 to 45,000 root ticks/s',
      source: `BehaviorTree.CPP 4, ${CLOUD}`,
    },
    navigation: {
      title: 'Search for a plan of navigation, 10 layouts',
      unit: 'integrations',
      file: 'scenarios/navigation.json',
      peer: '19.3 to 24.5 s a search',
      source: 'the paper’s own program with 20 robots, Intel Core i5-750, as the paper prints it',
    },
    coverage: {
      title: 'Search for a plan of coverage, 10 layouts',
      unit: 'integrations',
      file: 'scenarios/coverage.json',
      peer: '29.4 to 63.6 s a search',
      source: 'the paper’s own program, Intel Core i5-750, as the paper prints it',
    },
    flocks: { title: 'Flocking within a search, 2,000,000 steps of robots', unit: 'robot-steps', file: 'tests/cases/flocks.json' },
    match: {
      title: 'Match of ten minutes, both coaches',
      unit: 'steps',
      file: 'scenarios/match.json',
      peer: '247 s for ten minutes of play',
      source: `rSim with sensible roles, elapsed time, ${CLOUD}`,
    },
    memory: { title: 'Memory of the engine of the worlds', unit: '', file: '' },
  },
};
