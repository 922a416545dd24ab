/**
 * @typedef {object} Looked
 * @property {'everyone' | 'program' | 'agent'} scope whose tree is shown
 * @property {number | null} agent
 * @property {number[]} under robots at the place of the last click
 * @property {string | null} program
 * @property {number | null} node of the tree shown
 * @property {number[]} reached robots whose last tick reached that node
 * @property {boolean} follow
 */

/**
 * What the visitor looks at: a robot, a group of robots with one tree, a node of it.
 */
export function createSelection() {
  /** @type {(() => void)[]} */
  const listeners = [];
  /** @type {Looked} */
  const looked = { scope: 'everyone', agent: null, under: [], program: null, node: null, reached: [], follow: false };
  const selection = Object.assign(looked, {
    /** @param {number | null} agent @param {number[]} [under] */
    selectAgent(agent, under = agent === null ? [] : [agent]) {
      change({ agent, under, scope: agent === null ? 'everyone' : 'agent', node: null, reached: [], follow: agent !== null && looked.follow });
    },

    /** @param {Looked['scope']} scope @param {string | null} [program] */
    look(scope, program = looked.program) {
      change({ scope, program, node: null, reached: [] });
    },

    /** @param {number | null} node */
    selectNode(node) {
      change({ node, reached: [] });
    },

    /** @param {number[]} reached */
    ring(reached) {
      looked.reached = reached;
    },

    toggleFollow() {
      if (looked.agent !== null) change({ follow: !looked.follow });
    },

    /** Takes back one thing at a time: following, then the node, then the robot. */
    clear() {
      if (looked.follow) change({ follow: false });
      else if (looked.node !== null) selection.selectNode(null);
      else selection.selectAgent(null);
    },

    /** @param {() => void} listener */
    on: (listener) => void listeners.push(listener),
  });

  /** @param {Partial<Looked>} changes */
  function change(changes) {
    Object.assign(looked, changes);
    for (const listener of listeners) listener();
  }

  return selection;
}

/** @typedef {ReturnType<typeof createSelection>} Selection */
