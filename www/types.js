/**
 * Shapes that cross the boundary between engine, worker and page. Types only, no code.
 *
 * @typedef {number | boolean | string} Value
 * @typedef {{ tick: number, key: string, value: Value }} LiveEvent a change made while the world ran
 * @typedef {{ world: string, seed: number, events?: LiveEvent[] } & Record<string, any>} Scenario
 *
 * @typedef {object} Parameter one entry of the engine's schema
 * @property {string} key full name, as in links: `geese.agents`, or `seed`
 * @property {'int' | 'float' | 'bool' | 'choice' | 'text' | 'list' | 'seed'} type
 * @property {Value} default
 * @property {number} [min]
 * @property {number} [max] end of the slider
 * @property {number} [hard_max] largest value the engine takes
 * @property {number} [step]
 * @property {string} [unit]
 * @property {'linear' | 'log'} [scale]
 * @property {'live' | 'restart' | 'view'} apply
 * @property {string} group
 * @property {string} label
 * @property {string} help
 * @property {string} source
 * @property {{ value: string, label: string }[]} [choices]
 *
 * @typedef {{ offset: number, stride: number, count: number, fields: string[] }} Block
 * @typedef {object} Layout where things stand in a frame; arena units, y up
 * @property {number} length
 * @property {{ offset: number, fields: string[] }} counts
 * @property {Block} agents
 * @property {Block} items
 * @property {string[]} actions names by number, 0 is none
 * @property {{ half: number }} arena
 * @property {'food' | 'debris'} item what is carried
 * @property {Place[]} places
 *
 * @typedef {object} Place
 * @property {string} kind
 * @property {number} x
 * @property {number} y
 * @property {number} radius
 * @property {[[number, number], [number, number]]} [square] lower left and upper right corner, where places are cells
 *
 * @typedef {object} TreeNode a node in preorder; the index is the id
 * @property {number} id
 * @property {number | null} parent
 * @property {number} end one past the last descendant
 * @property {string} kind
 * @property {string} label
 * @property {string | null} tag
 * @property {boolean} negated
 * @property {string | null} [status]
 * @property {number} [reached_now]
 * @property {number} [reached_recently]
 *
 * @typedef {object} AgentDetail
 * @property {number} id
 * @property {number} x
 * @property {number} y
 * @property {number} heading
 * @property {boolean} carrying
 * @property {boolean} alive
 * @property {string[]} knows
 * @property {string[]} inside
 * @property {number} fitness
 * @property {number} diversity
 * @property {number} exploration
 * @property {number} feedback
 * @property {number} prospective items carried
 * @property {number} task items delivered by the whole swarm
 * @property {string[]} counts the fitness types that count
 * @property {number} since_swap
 * @property {number} swaps
 * @property {{ donor: number, fitness: number, diversity: number }[]} stored
 * @property {string | null} last_action
 * @property {number[]} genome
 * @property {number} used
 * @property {number} memory the blend factor beta
 * @property {string} program
 * @property {string | null} [replaced_by] the tree that runs next, when the one shown was replaced in the last tick
 *
 * @typedef {object} Detail answer to `inspect`
 * @property {number} tick
 * @property {{ count: number, top: { id: string, agents: number, text: string, first: number }[] }} programs
 * @property {{ name: string, agents: number, ticked: number, succeeded: number }[]} behaviours
 * @property {AgentDetail | null} agent
 * @property {{ program: string, text: string, agents: number[], nodes: TreeNode[], machine: Machine | null } | null} tree the program shown; a machine has no nodes
 * @property {number[] | null} reached
 *
 * @typedef {{ codon: number, value: number, rule: string, alternatives: number, choice: number, text: string, depth: number, node: number | null }} Derivation
 * @typedef {object} Derived answer to `derive`
 * @property {boolean} valid
 * @property {string | null} reason
 * @property {number} used
 * @property {number} depth
 * @property {string | null} phenotype
 * @property {number | null} diversity
 * @property {Derivation[]} steps
 * @property {TreeNode[] | null} nodes of a tree
 * @property {Machine | null} machine
 *
 * @typedef {object} MachineRule
 * @property {string[]} from states in which it can fire
 * @property {string[]} wanted tests, such as `not IsCarrying Food`
 * @property {boolean} equals false: it fires unless all tests are as wanted
 * @property {string} goto
 * @property {number} goto_probability
 * @property {[string, number] | null} set what is set, such as `X, true`, and how likely
 * @property {number} reached_now
 * @property {number} reached_recently
 *
 * @typedef {object} Machine a state machine; the shares are of the robots shown, in the last tick
 * @property {{ label: string, now: number, succeeded: number }[]} states
 * @property {{ label: string, now: number }[]} tests
 * @property {MachineRule[]} rules
 *
 * @typedef {{ every: number, from: number, delivered: number[], programs: number[], carrying: number[], swaps: number[] }} History
 *
 * @typedef {object} FrameAnswer
 * @property {number} tick
 * @property {number} done ticks made
 * @property {string | null} finished
 * @property {ArrayBuffer} buffer
 * @property {number} ms
 * @property {string} [fingerprint]
 * @property {number} [fingerprintTick] where it is not that of `tick`
 * @property {string[]} [marks] fingerprints by tick, from the one asked for on
 */
export {};
