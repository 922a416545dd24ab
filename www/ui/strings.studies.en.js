/** @import { Range } from '../studies/speed.js' */
/** @import { Size } from '../studies/types.js' */

const plural = (/** @type {number} */ count, /** @type {string} */ one, /** @type {string} */ many = `${one}s`) => `${count.toLocaleString('en')} ${count === 1 ? one : many}`;

/** A span of time for people. @param {number} seconds @returns {[number: number, unit: string]} */
function span(seconds) {
  if (seconds < 90) return [Math.max(1, Math.round(seconds)), 's'];
  if (seconds < 90 * 60) return [Math.round(seconds / 60), 'min'];
  return [Number((seconds / 3600).toPrecision(2)), 'h'];
}

/** @param {Range} range */
function between([low, high]) {
  const [from, to] = [span(low), span(high)];
  if (from[1] !== to[1]) return `${from.join(' ')} to ${to.join(' ')}`;
  return from[0] === to[0] ? to.join(' ') : `${from[0]} to ${to.join(' ')}`;
}

/** Texts of the tab Studies. */
export const studiesText = {
  list: {
    title: 'Studies',
    about: 'A study is many runs of a scenario and its variants, with tables, tests and a figure, and the paper’s values beside ours. The same files run on the command line, with the same results.',
    open: 'Open a file…',
    openLong: 'Open a study of your own: a JSON file as in the folder studies',
    paste: 'Paste',
    pasteLong: 'Open the text that is on the clipboard',
    notPasted: 'The clipboard could not be read. Open any study and put the text into its field.',
    pastedTitle: 'the text from the clipboard',
    dropped: 'A file can also be dropped on the page.',
    tooLarge: (/** @type {string} */ name, /** @type {number} */ megabytes) => `${name} was not opened: it is larger than ${megabytes} MB.`,
    sizes: /** @type {Record<Size, string>} */ ({ glance: 'Glance', class: 'Class', paper: 'Paper' }),
    sizesLong: /** @type {Record<Size, string>} */ ({
      glance: 'Glance: short runs of a few seeds, to see what it is about',
      class: 'Class: enough for a tendency',
      paper: 'Paper: full length, as results are quoted',
    }),
    runs: (/** @type {number} */ runs) => plural(runs, 'run'),
    kept: (/** @type {number} */ kept, /** @type {number} */ runs) => (kept >= runs ? 'all made here' : `${kept} made here`),
    time: (/** @type {Range} */ range) => between(range),
    noTime: 'How long a study takes is told as soon as a few runs were made on this computer: a glance is enough.',
    hasTime: (/** @type {number} */ workers) => `Times are for ${plural(workers, 'worker')}, from the runs made on this computer so far.`,
  },

  pane: { results: 'Results', form: 'Study', text: 'Study as text', bar: 'Runs' },
  back: '‹ All studies',
  fault: {
    at: (/** @type {string} */ path, /** @type {string} */ message) => (path === '' ? message : `${path}: ${message}`),
    show: 'Show the place',
    last: 'The text has a fault. What runs and is reported is the last valid study.',
    none: 'The text is no valid study yet; its fault stands beside it.',
  },

  form: {
    name: 'Name',
    title: 'Title',
    about: 'About',
    scenario: 'Scenario',
    preset: 'Preset',
    ownPreset: 'That of the study',
    whole: 'A scenario of its own',
    settings: 'Changed parameters',
    grid: 'Grid',
    gridLong: 'Every combination of these values is a cell',
    words: 'Name and words',
    cells: 'Cells',
    cell: (/** @type {number} */ number) => `Cell ${number}`,
    addCell: 'Add a cell',
    removeCell: 'Remove this cell',
    newCell: (/** @type {number} */ number) => `cell ${number}`,
    parameter: 'Parameter',
    add: 'Add',
    remove: (/** @type {string} */ label) => `Remove ${label}`,
    values: (/** @type {string} */ label) => `${label}, values separated by commas`,
    value: (/** @type {string} */ label, /** @type {number} */ number) => `${label}, value ${number}`,
    addValue: 'Add a value',
    labels: 'Labels, by which figures group',
    label: (/** @type {number} */ number) => `Label ${number}`,
    labelValue: (/** @type {string} */ label) => `What the label ${label} says`,
    newLabel: 'label',
    runs: 'Runs',
    first: 'First seed',
    count: 'Seeds for each cell',
    steps: 'Steps of a run',
    sizeSeeds: (/** @type {string} */ size) => `${size}: seeds`,
    sizeSteps: (/** @type {string} */ size) => `${size}: steps`,
    metrics: 'Metrics',
    figure: 'Figure',
    kind: 'Kind',
    kinds: { box: 'Box plots with every run', curve: 'Medians and quartiles as a curve', proportion: 'Shares of successes', histogram: 'Histogram' },
    noFigure: 'None',
    metric: 'Metric',
    x: 'Along the axis',
    group: 'By colour',
    nothing: 'Nothing',
    noScenario: 'None: every cell has its own',
    inText: (/** @type {number} */ tests, /** @type {number} */ values) => `${plural(tests, 'test')} and ${plural(values, 'value')} of the paper: edited in the text.`,
    on: 'on',
    off: 'off',
    noJson: 'The text is no JSON object, so there is no form.',
  },

  text: {
    label: 'The study as text (JSON)',
    save: 'Save as a file',
    saveLong: 'The study file: the command line runs it unchanged',
    original: 'Back to the file’s own text',
  },

  bar: {
    run: 'Run',
    pause: 'Pause',
    resume: 'Resume',
    carryOn: 'Continue',
    stop: 'Stop',
    stopLong: 'End the workers; the runs they are at will be made again',
    size: 'Size',
    workers: 'Workers',
    workersLong: (/** @type {number} */ cores) => `Runs that go on at once; this computer says that it has ${plural(cores, 'processor')}`,
    progress: 'Runs made',
    done: (/** @type {number} */ done, /** @type {number} */ all) => `${done.toLocaleString('en')} of ${plural(all, 'run')}`,
    underWay: (/** @type {number} */ count) => `${plural(count, 'run')} under way`,
    left: (/** @type {Range} */ range) => `${between(range)} left`,
    about: (/** @type {Range} */ range) => `about ${between(range)}`,
    unknown: 'time left: told after four runs',
    slowest: (/** @type {string} */ cell, /** @type {number} */ seconds) => `slowest: ${cell}, ${seconds < 10 ? seconds.toFixed(2) : Math.round(seconds)} s a run`,
  },

  state: {
    all: 'all runs are made',
    fresh: 'Not started',
    paused: 'Paused',
    partial: 'Not complete',
    running: 'Running',
    finished: 'Finished',
  },

  results: {
    none: 'No run has been made yet.',
    start: 'Run makes the runs of this size, cell by cell in turn, so that what there is can be compared at any time.',
    extent: (/** @type {string} */ extent) => `${extent.charAt(0).toUpperCase()}${extent.slice(1)}.`,
    figureBox: 'Figure',
    figure: (/** @type {string} */ title) => `Figure: ${title}. Its numbers are in the table below.`,
    failed: (/** @type {string} */ reason, /** @type {number} */ count) => `${plural(count, 'run')} failed, and no number below counts them: ${reason}`,
    more: 'All other metrics',
    verdicts: (/** @type {[string, number][]} */ counts) => `The paper’s values: ${counts.map(([verdict, count]) => `${count} ${verdict}`).join(', ')}.`,
    large: (/** @type {number} */ runs, /** @type {Range | null} */ range) =>
      `This size is too large for a page: ${plural(runs, 'run')} of full length${range ? `, about ${between(range)} here` : ''}. It can be made here, a part at a time, for as long as the page is open. The command line makes it faster, and can be left alone:`,
    tooMany: (/** @type {number} */ runs) => `${plural(runs, 'run')} are more than a page can hold. The command line makes them:`,
    saveFirst: 'Save the study as a file first; the command reads it from the folder studies.',
    copy: 'Copy the command',
    copied: 'The command is on the clipboard.',
    whose: 'Results shown',
    yours: (/** @type {number} */ done, /** @type {number} */ all) => `Made here: ${done} of ${all}`,
    committed: 'Made by the command line',
    committedAbout: (/** @type {string} */ file) => `These results were made by the command line and are part of the project: ${file}.`,
    committedOther: 'They are of another state of this study than the one on screen.',
    committedBad: (/** @type {string} */ file, /** @type {string} */ why) => `${file} could not be shown: ${why}.`,
    otherVersions: (/** @type {number} */ rows, /** @type {string} */ versions) => `${plural(rows, 'row')} of this study made with version ${versions} are kept too. Versions never mix, so they are not shown.`,
    clearOther: 'Remove them',
  },

  foot: {
    take: 'Take away',
    csv: 'One row a run, the same bytes as the command line’s file',
    spec: 'Spec',
    specLong: 'The study without presets, grid and sizes, as it goes beside the CSV',
    report: 'Report',
    reportLong: 'Tables, tests and the paper’s values as Markdown',
    svg: 'The figure',
    png: 'The figure at twice its size, on light ground',
    zip: 'Study, rows, report, figure and citation in one file',
    zipMissing: 'The part that packs files could not be loaded. Is the network there?',
    /** @param {string} name @param {string} title @param {string} version @param {string} hash @param {string} link */
    citation: (name, title, version, hash, link) =>
      `Swarm playground ${version}: "${title}", study ${hash}.\n${link}\n\nThe command line of this version makes the same rows again:\nswarm-playground study ${name}.study.json --out again.csv\n`,
    nothing: 'There is nothing to take away yet: make some runs first.',
    noFigure: 'This study has no figure, or no run to draw.',
    tooLong: (/** @type {number} */ letters) => `The link would have ${letters} letters, too many for some programs. Save the study as a file instead.`,
    copied: 'The link is on the clipboard. It holds the study, not the results.',
  },

  clear: { do: 'Clear results', long: 'Forget the rows of this study and size that this browser keeps' },

  said: {
    opened: (/** @type {string} */ title) => `Opened: ${title}.`,
    cleared: (/** @type {number} */ rows) => `${plural(rows, 'row')} cleared.`,
    restore: 'Bring them back',
    found: (/** @type {number} */ rows, /** @type {number} */ runs) => `${rows} of ${plural(runs, 'run')} were made here before. Continue makes the rest.`,
    started: (/** @type {number} */ left) => `Running: ${plural(left, 'run')} to make`,
    paused: (/** @type {number} */ done, /** @type {number} */ all) => `Paused: ${done} of ${plural(all, 'run')} made`,
    stopped: (/** @type {number} */ done, /** @type {number} */ all) => `Stopped: ${done} of ${plural(all, 'run')} made`,
    finished: (/** @type {number} */ all) => `Finished: ${all === 1 ? 'the run is' : `all ${all} runs are`} made`,
    progress: (/** @type {number} */ done, /** @type {number} */ all) => `${done} of ${plural(all, 'run')} made`,
    failed: (/** @type {number} */ run, /** @type {string} */ why) => `Run ${run} failed, and its row says why: ${why}.`,
    noWorker: (/** @type {string} */ why) => `No worker could be started: ${why}. What was made is kept.`,
    unreadable: (/** @type {string} */ why) => `The rows kept here could not be read: ${why}.`,
    notKept: 'This browser keeps nothing for the page, so results last as long as the page is open. Everything else works.',
    full: 'The browser’s storage is full: rows from now on last as long as the page is open. Everything else works.',
  },

  broken: { reload: 'Start it again', kept: 'The study and every row that was made are kept.' },

  pool: {
    silent: (/** @type {number} */ seconds) => `the worker was silent for ${seconds} seconds`,
    noReason: 'the worker ended without a reason',
    died: (/** @type {number} */ times, /** @type {string} */ why) => `its worker died ${times} times, last: ${why}`,
  },
};
