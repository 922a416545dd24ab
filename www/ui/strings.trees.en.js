/** @import { Problem, ScriptEvent, Status } from '../trees/types.js' */

const plural = (/** @type {number} */ count, /** @type {string} */ one, /** @type {string} */ many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

/** Texts of the tab Trees, except those of the drawing, the timeline and the comparison. */
export const benchText = {
  opened: (/** @type {string} */ title) => `Opened: ${title}. Undo brings back what was here.`,
  refused: (/** @type {string} */ why) => `The engine did not take this: ${why}.`,
  scriptRefused: (/** @type {string} */ why) => `The tree was opened without its script: ${why}.`,
  fileRefused: (/** @type {string} */ name, /** @type {string} */ why) => `${name} was not opened: ${why}.`,
  noSetup: 'it holds no field "xml"; expected an XML tree, or a setup saved here as JSON',
  tooLarge: (/** @type {number} */ megabytes) => `it is larger than ${megabytes} MB`,

  link: {
    script: 'expected a list of script events, each with a tick',
    compare: (/** @type {string} */ found) => `found '${found.slice(0, 60)}', expected line and column as in 3.5, or none`,
    noCompare: (/** @type {number} */ line, /** @type {number} */ column) => `no sequence or fallback stands at line ${line}, column ${column}`,
  },

  pane: {
    tree: 'Tree',
    editor: 'Text of the tree',
    inspector: 'Inspector',
    inspect: (/** @type {string} */ name) => `Inspect ${name} ▴`,
    width: 'Width of the text',
  },

  open: {
    choose: 'Tree',
    library: 'Library',
    drafts: 'What you typed',
    own: 'A tree of your own',
    draft: (/** @type {string} */ title, /** @type {number} */ lines) => `${title}, ${plural(lines, 'line')}`,
    edited: (/** @type {string} */ title) => `${title}, edited`,
    file: 'Open…',
    fileLong: 'Open an XML file, or a setup saved here as JSON; it can also be dropped on the text',
    restore: 'Restore what I typed',
    find: 'Find',
    findLong: 'Find and replace in the text (Ctrl F)',
  },

  editor: {
    label: 'XML of the tree. Tab indents, Escape leaves the text.',
  },

  problems: {
    label: 'Problems',
    none: 'No problems',
    count: (/** @type {number} */ faults, /** @type {number} */ warnings) =>
      [faults > 0 ? plural(faults, 'fault') : '', warnings > 0 ? plural(warnings, 'warning') : ''].filter((part) => part !== '').join(', '),
    more: (/** @type {number} */ count) => `and ${count} more`,
    fault: 'Fault',
    warning: 'Warning',
    place: (/** @type {Problem} */ { line, column, message }) => `line ${line}, column ${column}: ${message}`,
    replace: (/** @type {string} */ name) => `Replace by ${name}`,
    declare: (/** @type {'Action' | 'Condition'} */ kind, /** @type {string} */ name) => `Declare ${name} as ${kind.toLowerCase()}`,
  },

  bar: {
    label: 'Drawing',
    undo: 'Undo',
    redo: 'Redo',
    zoomIn: 'Zoom in',
    zoomOut: 'Zoom out',
    fit: 'Whole tree',
    fold: 'Fold all',
    unfold: 'Unfold all',
    down: 'Grows down; press to let it grow to the right',
    right: 'Grows to the right; press to let it grow down',
    search: 'Find a node',
    found: (/** @type {number} */ count) => plural(count, 'hit'),
    at: (/** @type {number} */ index, /** @type {number} */ count) => `${index} of ${count}`,
    next: 'Next hit',
    compare: 'Compare',
    compareLong: 'The selected sequence or fallback, or else the first one, in all its kinds side by side',
  },

  drawing: {
    label: 'Behaviour tree',
    stale: 'Shows the last valid tree',
    timeline: 'Timeline',
    notRunnable: 'This tree can be shown but not run: the engine does not know what its own control nodes or decorators do.',
  },

  compare: {
    label: 'Kinds side by side',
    none: 'There is no sequence or fallback to compare here: select one first.',
    failed: (/** @type {string} */ why) => `The kinds could not be compared: ${why}.`,
    note: (/** @type {string} */ name, /** @type {number} */ line) => `${name} in line ${line}, same script and same ticks in every column.`,
  },

  /** @type {Record<string, string>} */
  status: { S: 'SUCCESS', F: 'FAILURE', R: 'RUNNING', K: 'SKIPPED', H: 'HALTED', I: 'IDLE' },

  inspector: { node: 'Node', script: 'Script', board: 'Blackboard', log: 'Log' },

  node: {
    none: 'No node is selected. Click one in the drawing, or walk it with the arrow keys.',
    type: 'Type',
    kind: 'Kind',
    tree: 'In tree',
    line: 'Line',
    goTo: (/** @type {number} */ line) => `Go to line ${line}`,
    now: 'Now',
    last: 'Last returned',
    /** @type {Record<string, string>} */
    kinds: { action: 'action', condition: 'condition', control: 'control node', decorator: 'decorator', subtree: 'subtree' },
    scripted: 'leaf that answers as the script says',
    ports: 'Ports',
    conditions: 'Conditions',
    notTicked: 'not ticked',
    kept: (/** @type {string} */ status) => `${status}, not ticked`,
    never: 'never',
    tick: (/** @type {number} */ tick) => `in tick ${tick}`,
    returns: (/** @type {number} */ tick) => (tick === 0 ? 'Returns, from the start' : `Returns, from tick ${tick + 1} on`),
    shared: (/** @type {number} */ count) => `Holds for all ${count} nodes of this name.`,
    after: 'after',
    afterLong: 'Ticks it returns RUNNING before that',
    runningUnit: 'ticks RUNNING',
    progress: (/** @type {number} */ done) => `${plural(done, 'tick')} RUNNING so far`,
    output: (/** @type {string} */ port) => `writes to ${port}`,
    pause: 'Pause when it',
    pauseOn: (/** @type {string} */ status) => `returns ${status}`,
    pauseHalted: 'is halted',
  },

  script: {
    leaves: 'What the leaves answer now',
    noLeaves: 'No leaf of this tree is scripted: its leaves are built in and act by themselves.',
    columns: ['Leaf', 'Returns', 'After'],
    returns: (/** @type {string} */ leaf) => `${leaf} returns`,
    after: (/** @type {string} */ leaf) => `${leaf}: ticks RUNNING before it`,
    events: (/** @type {number} */ count) => `Script, ${plural(count, 'event')}`,
    none: 'Nothing happens yet: every leaf returns SUCCESS at once.',
    eventColumns: ['Tick', 'What happens', ''],
    remove: (/** @type {string} */ what) => `Remove: ${what}`,
    goTo: (/** @type {number} */ tick) => `Go to tick ${tick}`,
    halt: 'Halt the tree now',
    haltLong: (/** @type {number} */ tick) => `The whole tree is halted after tick ${tick}`,
    /** @param {ScriptEvent} event */
    what: (event) => {
      if ('halt' in event) return 'the whole tree is halted';
      if ('set' in event) return `${event.set} := ${event.value}`;
      const { leaf, running = 0, then, writes = {} } = event;
      const written = Object.entries(writes).map(([port, value]) => `${port}=${value}`);
      return [`${leaf} → ${then}${running > 0 && then !== 'RUNNING' ? ` after ${running} RUNNING` : ''}`, ...written].join(', ');
    },
  },

  board: {
    caption: (/** @type {number} */ tick) => `Entries after tick ${tick}`,
    columns: ['Name', 'Value', 'Type', 'Written by'],
    none: 'The blackboards are empty.',
    global: 'Global board (@)',
    local: (/** @type {string} */ board) => `Board of ${board}`,
    noValue: 'no value',
    byHand: 'by hand',
    start: 'from the start',
    when: (/** @type {number} */ tick) => `tick ${tick}`,
    value: (/** @type {string} */ name) => `Value of ${name}`,
    add: 'Add an entry',
    name: 'Name',
    newValue: 'Value',
    put: 'Write',
    hint: 'A name that begins with @ stands on the global board. A value that is a number is read as one.',
  },

  log: {
    none: 'No tick yet.',
    caption: (/** @type {number} */ tick) => `Tick ${tick}, in order`,
    passes: (/** @type {number} */ passes) => (passes > 1 ? `${passes} passes from the root` : 'one pass from the root'),
    time: (/** @type {number} */ ms) => `${ms} ms of simulated time`,
    columns: ['', 'Node', 'Returned'],
    halted: 'Halted while RUNNING, in order',
    noneHalted: 'Nothing was halted.',
    error: 'The tick ended with an error',
    more: (/** @type {number} */ count) => `and ${count} more returns`,
  },

  transport: {
    region: 'Transport',
    label: 'Run',
    play: 'Play',
    pause: 'Pause',
    restart: 'Restart: back to tick 0, later ticks are forgotten',
    back: '−1 tick',
    forward: '+1 tick',
    speed: 'Speed',
    ticksPerSecond: (/** @type {number} */ ticks) => `${ticks} ticks/s`,
    scrub: 'Go to tick',
    tick: 'tick',
    of: (/** @type {number} */ length) => ` / ${length}`,
    root: 'root',
    noRoot: 'not ticked',
    mode: 'A tick is',
    modes: { once: 'tickOnce', exactly_once: 'tickExactlyOnce' },
    meaning: {
      once: 'passes from the root until nothing asks for another one: a retry of three attempts is one tick',
      exactly_once: 'exactly one pass from the root: a retry of three attempts is three ticks',
    },
    ms: 'Time per tick',
    msUnit: 'ms',
    complete: 'pause when the root completes',
  },

  said: {
    paused: (/** @type {number} */ tick) => `Paused at tick ${tick}`,
    running: 'Running',
    finished: (/** @type {number} */ tick) => `Finished at tick ${tick}: no further tick can be recorded`,
    finishedWhy: 'no further tick can be recorded',
    breakpoint: (/** @type {string} */ name, /** @type {Status | 'HALTED'} */ status, /** @type {number} */ tick) =>
      status === 'HALTED' ? `Paused at tick ${tick}: ${name} was halted.` : `Paused at tick ${tick}: ${name} returned ${status}.`,
    error: (/** @type {string} */ name, /** @type {string} */ message, /** @type {number} */ tick) => `Tick ${tick} ended with an error in ${name}: ${message}.`,
    root: (/** @type {number} */ tick, /** @type {string} */ status) => `Tick ${tick}: the root returned ${status}`,
  },

  foot: {
    take: 'Take away',
    coach: 'Play as coach',
    coachLong: 'Let this tree coach the blue team in the tab Soccer',
    copied: 'The link is on the clipboard. It holds the tree, its script, the tick and the fingerprint.',
    tooLong: (/** @type {number} */ length) => `The link would have ${length} characters, too many for some programs. Save the setup as a file instead.`,
    xml: 'The tree as canonical XML with models of its own nodes, for BehaviorTree.CPP and Groot2',
    svg: 'Drawing of the tree with what it returned, SVG',
    png: 'Drawing of the tree with what it returned, PNG',
    videoLong: 'A film of the run, a picture for each tick',
    noRun: 'This tree cannot be run, so there is nothing to film.',
    json: 'Text, script, mode and tick as a file that can be opened here',
    citeLong: 'Copy title, version, link, tick and fingerprint',
    notFormatted: (/** @type {string} */ why) => `No XML was saved: ${why}.`,
    noDrawing: 'There is no tree to draw.',
    tooWide: 'The drawing is too large for a PNG. Save the SVG instead.',
    noCompare: 'Leave the comparison first: the drawing is of one tree.',
    /** @param {string} version @param {string} link @param {string} title @param {number} tick @param {string} fingerprint */
    citation: (version, link, title, tick, fingerprint) =>
      `Swarm playground ${version}, tree workbench. ${title}, tick ${tick}, fingerprint ${fingerprint}. ${link}\nSemantics: BehaviorTree.CPP 4.10, XML format 4.`,
  },
};
