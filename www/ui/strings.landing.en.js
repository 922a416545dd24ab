/** Texts that stand in the page before any script has run; scripts/still.mjs writes them there. */
export const landingText = {
  lede: 'Nobody wrote these behaviours: the robots evolve them while they work. Click a robot.',
  label: 'Where to begin',
  fromRandom: 'Start from random',
  or: 'or',
  still: 'A hundred robots between hub and food',
  /** @type {[href: string, label: string][]} */
  links: [
    ['#/learn', 'learn it in lessons'],
    ['#/sequence', 'plan for a swarm'],
    ['#/soccer', 'coach a match'],
    ['#/trees', 'build a tree'],
    ['#/studies', 'repeat the papers'],
  ],
};
