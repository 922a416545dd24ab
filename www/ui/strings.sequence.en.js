const plural = (/** @type {number} */ count, /** @type {string} */ one, /** @type {string} */ many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

/** @param {string} kind @param {number} index */
const thing = (kind, index) => /** @type {Record<string, string>} */ ({ swarm: 'Start of the swarm', target: 'Target', obstacle: `Obstacle ${index + 1}`, robot: `Robot ${index + 1}` })[kind];

const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(1)} %`;

/** Texts of the tab Sequence, except labels and help of parameters, which come with the schema. */
export const sequenceText = {
  list: (/** @type {string} */ found) => `found '${found.length > 40 ? `${found.slice(0, 40)}…` : found}', expected a list in square brackets`,
  otherWorld: (/** @type {string} */ world) => `it is of the world '${world}', expected 'sequencing'`,
  refused: (/** @type {string} */ why) => `Not possible, and the last plan stays: ${why}`,
  fileRefused: (/** @type {string} */ name, /** @type {string} */ why) => `${name} was refused, and the last plan stays: ${why}.`,
  opened: (/** @type {string} */ name) => `Opened ${name}.`,
  handRefused: (/** @type {string} */ letters, /** @type {string} */ why) => `The plan '${letters}' was left out: ${why}.`,

  /** The engine's sentence about a placement, for somebody who drags. @param {string} why */
  plain(why) {
    const inside = /robot (\d+) at \(.*\): expected a free place, found obstacle (\d+)/.exec(why);
    if (inside) return `robot ${inside[1]} would start inside obstacle ${inside[2]}${/^obstacle-margin/.test(why) ? ' with its margin' : ''}.`;
    const outside = /robot (\d+) at \(.*\): expected a place on the map/.exec(why);
    if (outside) return `robot ${outside[1]} would start outside the map.`;
    return `${why}.`.replace(/\.\.$/, '.');
  },

  pane: { map: 'Map', controls: 'Controls', inspector: 'Inspector' },

  verdict: {
    none: 'Which order of behaviours brings the whole swarm to the target at the least cost?',
    searching: (/** @type {string} */ what) => `Searching. ${what}`,
    held: (/** @type {string} */ what) => `The search rests. ${what}`,
    noPlanYet: (/** @type {number} */ integrated) => `No plan yet after ${plural(integrated, 'integration')}.`,
    noPlan: 'No plan was found, which proves nothing.',
    noProof: (/** @type {string} */ cost) => `The best plan so far costs ${cost}; this method proves nothing about it.`,
    best: (/** @type {string} */ cost) => `The plan costs ${cost}, and none costs less.`,
    /** @param {string} cost @param {string} ratio @param {string} bound */
    within: (cost, ratio, bound) => `The best plan so far costs ${cost}, at most ${ratio} times the least: none costs less than ${bound}.`,
    solved: (/** @type {string} */ what) => `Solved: the weight's promise is kept. ${what.replace(' so far', '')}`,
    optimal: (/** @type {string} */ cost, /** @type {boolean} */ idle) => (idle ? 'Proved optimal: the goal holds already, and nobody has to move.' : `Proved optimal: ${cost}, and no plan costs less.`),
    infeasible: (/** @type {string} */ why) => `Proved infeasible: there is no plan. ${why}`,
    outOfReach: 'The target cannot be reached in time, at 2 m/s without any detour.',
    blocked: (/** @type {string} */ first) => `Every behaviour collides in the first interval. ${first}.`,
    exhausted: (/** @type {number} */ integrated) => `Every sequence was tried or ruled out, with ${plural(integrated, 'integration')}.`,
    cancelled: (/** @type {string} */ what) => `Stopped. ${what}`,
    gaveUp: (/** @type {string} */ how, /** @type {string} */ what) => `${how.charAt(0).toUpperCase()}${how.slice(1)}. ${what}`,
  },

  map: {
    label: 'Map with the plan. Page Up and Page Down choose a thing, arrow keys move it by a metre, with Shift by 10 centimetres, Delete removes an obstacle.',
    start: 'Start',
    target: 'Target',
    /** @param {number} seconds @param {number} robots @param {number} obstacles @param {string} behaviour */
    summary: (seconds, robots, obstacles, behaviour) => `${seconds.toFixed(1)} seconds. ${plural(robots, 'robot')}, ${plural(obstacles, 'obstacle')}. ${behaviour}`,
    covered: (/** @type {number} */ visited, /** @type {number} */ wanted) => `${visited} of ${wanted} cells visited.`,
  },
  layers: { label: 'Layers', robots: 'Robots', plan: 'Plan', frontier: 'Search', fan: 'Moved starts' },

  tools: {
    label: 'Edit the map',
    undo: 'Undo',
    redo: 'Redo',
    drawing: 'New obstacle',
    disc: '+ Disc',
    box: '+ Box',
    polygon: '+ Polygon',
    draw: (/** @type {string} */ kind) => (kind === 'polygon' ? 'Click its corners on the map; a dent is filled' : `Drag on the map to draw a ${kind}`),
    close: 'Close the polygon',
    place: 'Chosen thing',
    chosen: 'Choose a thing on the map',
    none: 'Choose…',
    hint: 'Drag anything on the map, or choose it and type where it is to stand.',
    thing,
    field: { x: 'x', y: 'y', heading: 'heading °', radius: 'radius', width: 'width', height: 'height' },
    remove: 'Delete',
  },

  ribbon: {
    label: 'Plan, one behaviour for each interval. Left and right choose an interval, up and down change its behaviour.',
    /** @param {number} interval @param {string} name @param {number | null} cost @param {boolean} locked @param {boolean} fails */
    cell: (interval, name, cost, locked, fails) => `${interval}: ${name}${fails ? ', collides' : cost === null ? ', not reached' : `, ${cost.toFixed(0)} m`}${locked ? ', yours' : ''}`,
    interval: (/** @type {number} */ interval, /** @type {number} */ from, /** @type {number} */ to) => `Interval ${interval}, ${from} to ${to} s`,
    lock: (/** @type {number} */ count) => (count === 1 ? 'Keep the first' : `Keep the first ${count}`),
    unlock: (/** @type {number} */ count) => (count === 0 ? 'Keep none' : `Keep only the first ${count}`),
    lockLong: 'These are yours; the rest is planned',
    locked: (/** @type {number} */ count) => (count === 1 ? 'The first is yours; the rest is planned.' : `The first ${count} are yours; the rest is planned.`),
    back: "Back to the planner's plan",
    none: 'There is no plan to show.',
    waiting: 'A plan is being looked for.',
  },
  hand: {
    /** @param {string} name @param {number} robot @param {number | null} obstacle @param {number} seconds */
    collides: (name, robot, obstacle, seconds) => `Your plan fails: in ${name}, robot ${robot} ${obstacle === null ? 'leaves the map' : `hits obstacle ${obstacle}`} after ${seconds.toFixed(1)} s.`,
    misses: (/** @type {string} */ cost) => `Your plan costs ${cost} and does not reach the goal.`,
    reaches: (/** @type {string} */ cost) => `Your plan reaches the goal for ${cost}.`,
    against: (/** @type {string} */ cost, /** @type {number} */ more) =>
      `Your plan reaches the goal for ${cost}, ${Math.abs(more) < 0.0005 ? 'as much as' : `${percent(Math.abs(more))} ${more > 0 ? 'more than' : 'less than'}`} the planner's best.`,
  },

  inspector: { plan: 'Plan', search: 'Search', robots: 'Robots', game: 'Beat it' },
  plan: {
    columns: ['No.', 'Behaviour', 'Path, m', 'Cells'],
    total: (/** @type {string} */ total, /** @type {string} */ charges, /** @type {boolean} */ charged) => (charged ? `In all ${total}, of which ${charges} charges for time and switches.` : `In all ${total} of path, all robots together.`),
    none: 'No plan.',
    blocked: 'What each behaviour runs into when it is the first:',
  },
  robust: {
    title: 'Robustness',
    about: 'Fifty replays of the plan on screen, every robot started a little elsewhere.',
    jitter: 'Moved by',
    jitters: /** @type {[string, string][]} */ ([
      ['0.001', '1 mm'],
      ['0.01', '1 cm'],
      ['0.1', '10 cm'],
    ]),
    check: 'Replay',
    /** @param {number} feasible @param {number} runs @param {number} jitter @param {number | null} more */
    share: (feasible, runs, jitter, more) =>
      `${feasible} of ${runs} still succeed when every robot starts ${jitter < 0.01 ? `${jitter * 1000} mm` : `${jitter * 100} cm`} elsewhere${more === null ? '' : `; they cost ${percent(Math.abs(more))} ${more >= 0 ? 'more' : 'less'} at the mean`}.`,
  },
  search: {
    facts: /** @type {[string, string, string][]} */ ([
      ['cost', 'Best plan', 'Incumbent: path length and charges of the best plan'],
      ['bound', 'No plan costs less than', 'Proven lower bound'],
      ['ratio', 'Proven ratio', 'Best plan over lower bound, rounded up'],
      ['weight', 'Weight', 'w of equation 10 at work, and the smallest whose promise is kept'],
      ['integrated', 'Integrations', 'Behaviours simulated for one interval; the same on every machine'],
      ['collided', 'of these collided', 'Integrations that ended in a collision'],
      ['expanded', 'Expanded', 'Sequences that were extended'],
      ['open', 'Open', 'Entries in the queue'],
      ['dropped', 'Too late, missed, alike', 'Sequences that cannot arrive in time, complete ones that missed the goal, and those alike after rounding'],
      ['memory', 'Memory', 'Taken by stored sequences and queue'],
      ['time', 'Computing', 'On this machine, in this browser'],
    ]),
    weight: (/** @type {number} */ weight) => String(weight),
    proven: (/** @type {number} */ weight, /** @type {number} */ proven) => (weight === proven ? `${weight}, kept` : `${weight}; ${proven} is kept`),
    seconds: (/** @type {number} */ seconds) => (seconds < 10 ? `${(seconds * 1000).toFixed(0)} ms` : `${seconds.toFixed(1)} s`),
    stop: 'Stop the search',
    go: 'Go on searching',
    more: (/** @type {number} */ budget) => `Continue with ${budget} more integrations`,
  },
  curve: {
    title: 'Best plan and bound',
    caption: 'Best plan and proven bound over the search',
    columns: ['Integrations', 'Best plan, m', 'Bound, m', 'Computing, ms'],
    said: (/** @type {number} */ integrated, /** @type {string} */ cost, /** @type {string} */ bound) => `After ${plural(integrated, 'integration')}: best plan ${cost}, bound ${bound}`,
  },
  robots: {
    columns: ['Robot', 'x', 'y', '°', 'Gone, m', 'To go, m'],
    caption: (/** @type {number} */ seconds) => `Robots after ${seconds.toFixed(1)} s`,
    inside: 'inside',
  },

  game: {
    rules: 'Choose the behaviours yourself, as an operator would: you see the map and the robots, and nothing of the search. Then your cost stands beside the planner\'s and the proven bound.',
    begin: 'Begin',
    again: 'Begin again',
    end: 'Show the plan',
    pace: 'Time for a choice',
    paces: /** @type {[string, string][]} */ ([
      ['8', '8 s'],
      ['4', '4 s'],
      ['2', '2 s'],
      ['0', 'as long as I like'],
    ]),
    clock: 'Time until the next decision',
    choose: 'Next behaviour',
    first: 'Choose the first behaviour: the clock starts with it.',
    /** @param {number} interval @param {number} of @param {string} name @param {boolean} waits */
    now: (interval, of, name, waits) => `${interval} of ${of}: ${name}. ${waits ? 'Choose the next behaviour.' : 'Choose what comes next; without a choice it goes on.'}`,
    chosen: (/** @type {string} */ name, /** @type {number} */ interval) => `${name} for interval ${interval}`,
    /** @param {boolean} goal @param {boolean} collided @param {string} cost @param {string} letters */
    result: (goal, collided, cost, letters) => (goal ? `You reached the goal for ${cost}: ${letters}.` : collided ? `Collided after ${cost} of path: ${letters}.` : `The goal was not reached: ${letters}, ${cost}.`),
    planner: (/** @type {string} */ cost) => `The planner's best so far costs ${cost}.`,
    /** @param {string} cost @param {number} more */
    against: (cost, more) => `The planner's best so far costs ${cost}: ${Math.abs(more) < 0.0005 ? 'you are equal.' : more > 0 ? `yours costs ${percent(more)} more.` : `yours costs ${percent(-more)} less. You beat the planner.`}`,
    bound: (/** @type {string} */ bound, /** @type {string | null} */ ratio) => `No plan costs less than ${bound}${ratio === null ? '' : `, so yours is at most ${ratio} times the least`}.`,
    improving: 'It is still searching.',
    plannerNone: 'The planner has found no plan either.',
    plannerSearches: 'The planner is searching for its first plan.',
    best: (/** @type {string} */ cost, /** @type {string} */ letters) => `Your best here: ${cost}, ${letters}.`,
    hidden: 'Your turn: nothing of the search is shown.',
    notNow: 'Hidden while you play.',
  },

  compare: {
    label: 'A | B',
    title: 'A | B: two ways to search the same layout, side by side',
    missing: (/** @type {string} */ why) => `A | B could not be opened: ${why}`,
    map: (/** @type {string} */ side) => `Map of ${side}`,
    pair: 'Compare',
    pairs: /** @type {[string, string][]} */ ([
      ['literal', 'Algorithm 1 word by word | accelerated'],
      ['weight', 'weight 2 | weight 10'],
      ['geodesic', 'straight distances | round obstacles'],
    ]),
    again: 'Search again',
    running: 'Both search…',
    /** @param {Record<string, any>} differs @param {(field: string, value: any) => string} label */
    side: (differs, label) => Object.entries(differs).map(([field, value]) => label(field, value)).join(', '),
    /** @param {{ cost: number | null, integrated: number }} a @param {{ cost: number | null, integrated: number }} b */
    ended: (a, b) => `A: ${a.cost === null ? 'no plan' : `${a.cost.toFixed(0)} m`} after ${plural(a.integrated, 'integration')}. B: ${b.cost === null ? 'no plan' : `${b.cost.toFixed(0)} m`} after ${plural(b.integrated, 'integration')}.`,
  },

  transport: {
    region: 'Transport',
    label: 'Plan',
    play: 'Play',
    pause: 'Pause',
    start: 'To the start',
    back: '0.1 s back',
    forward: '0.1 s forward',
    intervalBack: 'One interval back',
    intervalForward: 'One interval forward',
    scrub: 'Moment of the plan',
    seconds: (/** @type {number} */ seconds) => `${seconds.toFixed(1)} s`,
    of: (/** @type {number} */ seconds) => ` / ${seconds.toFixed(1)} s`,
    speed: (/** @type {number} */ times) => `${times < 10 ? times.toFixed(1) : times.toFixed(0)} × real time`,
    seed: 'Layout',
    newLayout: 'New layout',
  },
  controls: { open: 'Open a file' },

  foot: {
    honest: 'Plan and ratio hold for the stated model, not for continuous time or real robots.',
    copied: 'The link is on the clipboard. It holds the whole scenario, the plan made by hand and the moment.',
    png: 'Picture of the map, PNG',
    svg: 'Drawing of the map, SVG',
    videoLong: 'A film of the plan as it is carried out, with even timing',
    plan: 'Plan',
    planLong: 'Plan with costs, proof and scenario, JSON',
    csv: 'Trajectories of all robots every 0.1 s, CSV',
    json: 'The scenario as a file, for the command line',
    citeLong: 'Copy title, version, link, plan and the paper',
    noPlan: 'There is no plan yet to be saved.',
    /** @param {string} preset @param {number} seed @param {string} letters @param {number} seconds */
    caption: (preset, seed, letters, seconds) => `${preset}, layout ${seed}${letters && `, ${letters}, ${seconds.toFixed(1)} s`}`,
    /** @param {string} version @param {string} link @param {string} letters @param {number | null} cost @param {number | null} ratio */
    citation: (version, link, letters, cost, ratio) =>
      `Swarm playground ${version}, behaviour sequencing. ${letters ? `Plan ${letters}${cost === null ? '' : `, cost ${cost.toFixed(1)} m`}${ratio === null ? '' : `, proven ratio ${ratio.toFixed(4)}`}. ` : ''}${link}\nAfter: optimal swarm behaviour sequencing.`,
  },

  said: {
    playing: 'Playing',
    chosen: (/** @type {string} */ name, /** @type {number} */ x, /** @type {number} */ y) => `${name} at ${x.toFixed(1)}, ${y.toFixed(1)}`,
  },
  broken: { reload: 'Plan again', kept: 'The scenario and its link are kept. The faulty state is not used again.' },
};
