/** @import { Check, Words } from '../learn/lessons.js' */

const percent = (/** @type {number} */ value) => `${Math.round(value)}\u00a0%`;
const metres = (/** @type {number} */ length) => `${length.toFixed(1)} m`;

/** The same numbers by name; those that a lesson's file holds. @typedef {Record<string, number>} Facts */

/** Texts of the tab Learn. Numbers in the words of a lesson come from its file, where a test compares them with the engine. */
export const learnText = {
  noWorld: 'the world beside is not there yet',
  right: 'Right: the engine finds the same.',
  wrong: 'Not this one. Look at what the engine found, and try again.',
  /** @param {boolean} right @param {number} found @param {number} least @param {number} tick */
  goal: (right, found, least, tick) => (right ? `Done: your rules bring home ${found} by tick ${tick}.` : `Not yet: your rules bring home ${found} by tick ${tick}; ${least} are wanted.`),
  /** @param {boolean} right @param {string} letters @param {boolean} collided */
  plan: (right, letters, collided) => {
    if (right) return 'You brought everybody to the target. The engine replayed your plan; compare the costs.';
    if (letters === '') return 'There is no plan of yours yet: press Begin in the panel.';
    return collided ? 'Your plan runs into something. Try again.' : 'Your plan does not reach the target. Try again.';
  },

  list: {
    title: 'Learn',
    about: 'Short lessons. Each has the real world beside it and one question. Nobody wrote the answers down: the engine runs and finds them.',
    done: '✓ done',
    teachers: 'For teachers:',
    worksheet: 'worksheet for printing',
    answers: 'answer key',
    forget: 'Forget which are done',
    /** @param {string} asked @param {number} count */
    unknown: (asked, count) => `There is no lesson '${asked}'; expected a number from 1 to ${count}.`,
  },
  lesson: {
    region: 'Lesson',
    nav: 'Lessons',
    all: '← All lessons',
    place: (/** @type {number} */ number, /** @type {number} */ count) => `${number} of ${count}`,
    ask: 'Ask the engine',
    check: 'Let the engine check',
    choose: 'Choose an answer first.',
    running: 'The engine is running.',
    progress: (/** @type {number} */ now, /** @type {number} */ of) => (of > 1 ? `Running ${now + 1} of ${of}` : 'Running'),
    failed: (/** @type {string} */ why) => `The engine could not answer: ${why}.`,
    restart: 'Restart',
    controls: 'Show all controls',
    skip: 'Skip →',
    next: 'Next lesson →',
    last: 'Back to all lessons →',
  },
  whose: /** @type {Record<string, string>} */ ({ yours: 'You', planner: 'The planner', screen: 'The world on screen' }),
  table: {
    caption: (/** @type {string} */ version) => `Found just now by engine ${version}`,
    columns: ['Answer', 'The engine', 'Right'],
    right: '✓',
    measure: {
      delivered: (/** @type {number} */ count) => `${count} brought home`,
      knowing: (/** @type {number} */ count) => `${count} know`,
    },
    wins: (/** @type {number} */ count, /** @type {number} */ seeds) => `ahead in ${count} of ${seeds} seeds`,
    /** @param {number} count @param {number} all */
    orders: (count, all) => `${count} of ${all}`,
    happened: 'this happens',
    not: 'this does not',
    noPlan: 'no plan',
    twins: (/** @type {boolean} */ same, /** @type {string[]} */ fingerprints) => (same ? `the same state: ${fingerprints[0]}` : `different: ${fingerprints.join(' and ')}`),
    /** @param {string} letters @param {boolean} goal @param {boolean} collided @param {number} cost */
    carried: (letters, goal, collided, cost) => `${letters}: ${collided ? 'a collision' : goal ? `target reached, ${metres(cost)}` : 'target missed'}`,
  },
  sheet: {
    worksheet: 'Worksheet',
    answers: 'Answer key',
    about: {
      worksheet: 'A page for each lesson. The address under each leads to the world it needs.',
      answers: 'Made just now: this page asks the engine every question. It takes about a minute.',
    },
    print: 'Print',
    name: 'Name:',
    heading: (/** @type {number} */ number, /** @type {string} */ title) => `${number} ${title}`,
    /** @param {Check} check */
    task: (check) => (check.kind === 'goal' ? `A task. It is solved when the engine counts at least ${check.least} by tick ${check.tick}.` : 'A task. It is solved when the engine replays the plan to the target without a collision.'),
  },

  /** @type {Record<string, (n: Facts) => Words>} */
  lessons: {
    'one-robot': (n) => ({
      title: 'One robot, one rule',
      body: [
        'The blue disc is a robot. It starts at the hub, its home. The green squares are food.',
        'This robot has one rule: explore. Step after step it walks on and turns a little. Press Play and watch.',
        'Sooner or later it walks across the food. Nothing happens: no rule tells it what food is for.',
      ],
      ask: 'What has to change before food comes home?',
      options: {
        many: `${n.many} robots with the same rule`,
        long: `More time: ${n.long} steps`,
        rules: 'More rules: take food, carry it home, drop it there',
      },
    }),
    running: (n) => ({
      title: 'Sequence, fallback, running',
      body: [
        'A tree of rules is read from the top, again and again. Each reading is a tick.',
        'A sequence (→) tries its children in order and stops at the first that fails. A fallback (?) stops at the first that works.',
        'What needs more time says running, and is asked again at the next tick.',
        `Step through with +1. At first no food is in sight, so the robot explores. At tick ${n.seen} it sees food and walks there. Then somebody takes the food away: at tick ${n.gone} none is in sight.`,
      ],
      ask: `What does the robot do at tick ${n.gone}?`,
      options: {
        walk: 'It walks on to where the food was',
        explore: 'It stops walking and explores again',
        take: 'It takes the food',
      },
    }),
    'hundred-robots': (n) => ({
      title: 'A hundred robots: what no robot knows',
      body: [
        `Now ${n.robots} robots follow the same few rules: take food you find, carry it home, go back to a place you know, explore otherwise.`,
        'Nobody leads, and nobody tells anybody anything. Press Play. Then pause and click a robot: the panel lists what it knows.',
        `By tick ${n.tick} the swarm has brought home ${n.home} of ${n.items} pieces of food.`,
      ],
      ask: 'By then, how many of the robots know where the place with the food is?',
      options: { all: 'All of them', most: 'At least half of them', few: 'Fewer than half of them' },
    }),
    'write-a-tree': (n) => ({
      title: `Write a tree that brings home ${n.least} food`,
      body: [
        'These are the rules of the swarm, in the box Grammar. Sel is a fallback: the first that works. Seq is a sequence: all in order.',
        'Press Play. The robots take food and carry it to the hub, but never let go of it. The rule <drop> is there, and nobody uses it.',
        'Put <drop> into the first line. Where it stands decides what is tried first. Then press Apply, and Restart to apply.',
      ],
      ask: `Bring home at least ${n.least} of ${n.items} by tick ${n.tick}.`,
      options: {},
    }),
    codons: (n) => ({
      title: 'From codons to trees',
      body: [
        'This robot gets no rules from us. It carries a row of numbers, its codons, and a grammar turns them into a tree.',
        `Where the grammar offers choices, the next codon picks one: divide it by the number of choices and look at what is left over. With ${n.choices} choices, ${n.left} leaves nothing over: the first one.`,
        'Click the robot, then point at a codon: the panel shows what it picks. The arrow keys up and down change it, and the tree below is drawn anew.',
      ],
      ask: `Codon ${n.first} picks among ${n.choices} choices, codon ${n.second} among ${n.more}, codon ${n.third} among ${n.two}. Which change gives another tree?`,
      options: {
        first: `Codon ${n.first}: ${n.firstOld} becomes ${n.firstNew}`,
        second: `Codon ${n.second}: ${n.secondOld} becomes ${n.secondNew}`,
        third: `Codon ${n.third}: ${n.thirdOld} becomes ${n.thirdNew}`,
      },
    }),
    evolve: (n) => ({
      title: 'Let it evolve',
      body: [
        'Robots that meet copy each other’s codons. Who has collected enough breeds children: two rows are cut, their tails swapped, a few numbers changed by chance. The best child takes over.',
        'Press Play, and open the charts. Nobody plans this, yet food comes home.',
        `All chance comes from one number, the seed. By tick ${n.tick} the swarm of seed ${n.one} has brought home ${n.first}, that of seed ${n.two} ${n.second}. One run proves little.`,
      ],
      ask: 'Which two runs end in exactly the same state?',
      options: {
        other: `Seed ${n.one} and seed ${n.two}`,
        twice: `Seed ${n.one}, run twice`,
        less: `Seed ${n.one}, once with ${n.all} robots and once with ${n.fewer}`,
      },
    }),
    order: (n) => ({
      title: 'Order matters',
      body: [
        `Here ${n.robots} robots move as one. Each turn of ${n.seconds} seconds, all of them do the same thing from a short list, such as flock to the north, or gather.`,
        `The planner looks for the ${n.decisions} turns that bring everybody into the circle with the least walking, without touching an obstacle. Press Play to watch its plan; the strip below shows the order.`,
        `The same ${n.decisions} things can be done in ${n.orders} different orders.`,
      ],
      ask: 'How many of these orders bring everybody into the circle?',
      options: { one: 'Only this one', half: 'About half of them', most: 'Almost all of them' },
    }),
    'real-difference': (n) => ({
      title: 'Two coaches, one ball',
      body: [
        'Two teams play soccer with the same robots. Only their coaches differ: one is a behaviour tree, the other a state machine.',
        `In ${n.games} matches, the team of the tree scored ${n.tree} goals, that of the machine ${n.machine}. Is one the better coach, or only luckier? Here is that study. The test below the tables asks how often luck alone would part two equal teams as far as this: very often. So nobody may say that either is better.`,
        'It is the same with swarms, and there you can try it.',
      ],
      ask: `In each of these pairs of swarms, the first brought home more in its first run. Who is ahead in most of ${n.seeds} seeds?`,
      options: {
        walk: `Turning a little at each step, against turning anyhow: ${n.walkA} to ${n.walkB}`,
        order: `Acting always in the same order, against a new order each step: ${n.orderA} to ${n.orderB}`,
        fewer: `${n.fewer} robots, against ${n.all}: ${n.fewerA} to ${n.fewerB}`,
      },
    }),
    'seventy-five': (n) => ({
      title: `Why did the paper get ${percent(n.paper)}?`,
      body: [
        `A paper reports that such a swarm succeeds in ${percent(n.paper)} of its runs. Its text, taken word by word, gives ${percent(n.literal)} here, in ${n.runs} runs. With four small changes it gives ${percent(n.robust)}; with trees one level deeper than that, ${n.deeper} of ${n.runs} runs succeed.`,
        `Press Play: nothing comes home. Of the robots, ${percent(n.inert)} start with a tree that can never act at all.`,
        'No paper says everything. What one left open, somebody had to decide. So every such decision is a switch here.',
      ],
      ask: `Which change alone brings anything home in ${n.tick} steps?`,
      options: {
        walk: 'Robots turn a little at each step, instead of anyhow',
        drop: 'Food may be dropped at the hub only',
        swap: 'Robots always take up the most diverse child, not only a better one',
      },
    }),
    'beat-the-planner': (n) => ({
      title: 'Beat the planner',
      body: [
        `Now it is your turn. ${n.robots} robots, ${n.decisions} turns, and the same behaviours as the planner has.`,
        'In the panel, press Begin, then choose a behaviour for each turn. The plan is hidden; you see the map and the robots.',
        'The cost is how far all robots walk together. Reaching the target is good; reaching it with less walking than the planner is better. Is that possible?',
      ],
      ask: 'Bring everybody into the target with a plan of your own.',
      options: {},
    }),
  },
};
