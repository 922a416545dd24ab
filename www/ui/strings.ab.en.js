const plural = (/** @type {number} */ count, /** @type {string} */ one, /** @type {string} */ many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

/** Texts of A | B. */
export const abText = {
  title: 'A | B',
  arena: (/** @type {string} */ side) => `The arena of ${side}. Arrow keys choose the nearest robot in that direction, Home and End the first and the last.`,
  leave: 'Leave A | B',
  goThere: (/** @type {number} */ tick) => `Go to tick ${tick}`,
  name: (/** @type {string} */ title, /** @type {boolean} */ changed) => (changed ? `${title}, changed` : title),
  ofA: (/** @type {number} */ count) => (count === 0 ? 'the same as A' : `A with ${plural(count, 'difference')}`),
  titleOfB: (/** @type {string} */ title, /** @type {number} */ count) => (count === 0 ? title : `${title}, with ${plural(count, 'difference')}`),
  finished: (/** @type {string} */ a, /** @type {string} */ b) => (a === b ? a : `A: ${a}, B: ${b}`),
  refused: (/** @type {string} */ why) => `B: ${why}`,
  leftOut: (/** @type {string} */ key, /** @type {string} */ why) => `The link's 'b.${key}' was left out: ${why}.`,
  notChanged: (/** @type {string} */ why) => `B was not changed: ${why}.`,
  notOpened: (/** @type {string} */ why) => `A | B was not opened: ${why}.`,
  differs: (/** @type {number} */ tick, /** @type {string} */ expected, /** @type {string} */ found) =>
    `B's fingerprint at tick ${tick} does not match: the link says ${expected}, this run gives ${found}. Please report this.`,

  parting: {
    start: 'Different from the start',
    until: (/** @type {number} */ tick) => `Identical until tick ${tick}`,
    soFar: (/** @type {number} */ tick) => (tick === 0 ? 'Identical so far, at tick 0' : `Identical so far, up to tick ${tick}`),
  },

  counts: (/** @type {number} */ delivered, /** @type {number} */ total, /** @type {number} */ carried, /** @type {number} */ programs) =>
    `Delivered ${delivered} of ${total}, ${carried} carried, ${plural(programs, 'tree')}`,
  ended: (/** @type {number} */ tick, /** @type {string} */ reason) => `ended at tick ${tick}: ${reason}`,
  fingerprint: (/** @type {string} */ side) => `Fingerprint of ${side}`,

  side: 'Inspect, table and files show',

  chart: {
    title: 'Delivered',
    said: (/** @type {number} */ tick, /** @type {number} */ a, /** @type {number} */ b) => `Delivered at tick ${tick}: A ${a}, B ${b}`,
    table: 'Numbers',
    caption: 'Delivered over time',
    columns: ['Tick', 'A', 'B'],
    tick: 'tick',
  },

  editor: {
    title: 'A | B',
    pairs: 'Comparison',
    ownPair: 'Your own',
    pair: /** @type {Record<string, string>} */ ({
      'paper-robust': 'Paper as written | robust',
      'paper-published': 'Paper as written | published code',
      'betr-geese-bt': 'BeTr-GEESE | GEESE-BT',
      'selection-none': 'Selection | no selection',
    }),
    from: 'B is',
    likeA: 'A, with these differences',
    swap: 'Swap A and B',
    same: 'Make B the same as A',
    none: 'B has no difference yet: both do the same. Choose a comparison or add a parameter.',
    list: (/** @type {number} */ count) => plural(count, 'difference'),
    inA: (/** @type {string} */ value) => `A: ${value}`,
    inB: (/** @type {string} */ label) => `${label} in B`,
    b: 'B:',
    alike: 'the same as A now',
    fromTick: 'from tick',
    fromTickOf: (/** @type {string} */ label) => `${label}: B's value holds from tick`,
    remove: (/** @type {string} */ label) => `Remove the difference in ${label}`,
    add: 'Add',
    parameter: 'Parameter to differ in',
    text: (/** @type {string} */ value) => (value.length > 40 ? `a text of ${value.length} characters` : value || 'none'),
    memory: 'Each of the two keeps 16 MB for going back, half of what one run alone keeps.',
    saveB: "Save B's scenario",
  },
};
