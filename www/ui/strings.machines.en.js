// Texts of the view of a state machine.

const percent = (/** @type {number} */ share) => `${Math.round(share * 100)} %`;

export const machineText = {
  states: 'States',
  stateColumns: ['Behaviour', 'in it'],
  tests: 'Tests',
  testColumns: ['Condition or variable', 'holds'],
  rules: 'Rules, tried in this order',
  ruleColumns: ['Rule', 'What it says', 'fired'],
  reading: "GEESE's grammar is not public: rules of this form are our reading of its state machines.",
  start: 'start',
  here: '● here',
  away: '',
  yes: '✓ yes',
  no: '✗ no',
  now: 'now',
  recent: 'lately',
  share: (/** @type {number} */ share) => (share > 0 ? percent(share) : ''),
  parts: { from: 'In', when: 'If', unless: 'Unless', goto: 'Go to', set: 'Set' },
  always: 'always',
  /** @param {string} what @param {number} probability */
  likely: (what, probability) => (probability === 1 ? what : `${what} with probability ${probability}`),
  choose: (/** @type {number} */ rule) => `Rule ${rule}: ring the robots for which it fired`,
  reached: (/** @type {number} */ count) => `${count} ${count === 1 ? 'robot' : 'robots'} fired this rule in the last tick: ringed in the world.`,
  groupKey: 'Shares of the robots in the last tick. Rules: solid line, fired this tick; dashed, within 50; thin, not.',
  robotKey: '● the present state   ✓ holds   ✗ does not. Rules: solid line, fired this tick; dashed, within 50; thin, not.',
  file: 'Rules',
  fileLong: 'Save these rules as a grammar that gives every robot this machine',
  noun: 'machine',
  scope: 'One machine',
  programs: 'Most common machines',
  behaviours: 'Behaviours across all machines',
};
