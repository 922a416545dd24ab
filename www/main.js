import './ui/language.js';
import { EngineError } from './engine.js';
import { createRouter } from './router.js';
import { createForage } from './tabs/forage.js';
import { button, find, h, write } from './ui/dom.js';
import { createKeys } from './ui/keys.js';
import { embedded } from './ui/storage.js';
import { text } from './ui/strings.en.js';
import { createThemeSwitch } from './ui/theme.js';

/** @import { SoccerTab } from './tabs/soccer.js' */
/** @import { TreesTab } from './tabs/trees.js' */

const live = find('#live');
const themes = createThemeSwitch();
const nav = h('nav', { 'aria-label': text.tabs.label });
const tools = h('div', { class: 'tools' });
const keys = createKeys({
  keys: () => void keys.open(),
  'tab-forage': () => void router.visit('forage'),
  'tab-trees': () => void router.visit('trees'),
  'tab-studies': () => void router.visit('studies'),
  'tab-sequence': () => void router.visit('sequence'),
  'tab-soccer': () => void router.visit('soccer'),
  'tab-learn': () => void router.visit('learn'),
});
const router = createRouter({
  nav,
  keys,
  tools,
  places: [
    {
      name: 'forage',
      label: text.tabs.forage,
      element: find('#forage'),
      load: async (parts) => createForage({ ...parts, live, themes, openTree }),
    },
    {
      name: 'sequence',
      label: text.tabs.sequence,
      element: find('#sequence'),
      load: async (parts) => (await import('./tabs/sequence.js')).createSequence({ ...parts, element: find('#sequence'), live, themes }),
    },
    {
      name: 'soccer',
      label: text.tabs.soccer,
      element: find('#soccer'),
      load: async (parts) => (await import('./tabs/soccer.js')).createSoccer({ ...parts, element: find('#soccer'), live, themes, openTree }),
    },
    {
      name: 'trees',
      label: text.tabs.trees,
      element: find('#trees'),
      load: async (parts) => (await import('./tabs/trees.js')).createTrees({ ...parts, element: find('#trees'), live, playCoach }),
    },
    {
      name: 'studies',
      label: text.tabs.studies,
      element: find('#studies'),
      deep: true,
      load: async (parts) => (await import('./tabs/studies.js')).createStudies({ ...parts, element: find('#studies'), live }),
    },
    {
      name: 'learn',
      label: text.tabs.learn,
      element: find('#learn'),
      deep: true,
      load: async (parts) => (await import('./tabs/learn.js')).createLearn({ ...parts, element: find('#learn'), live }),
    },
    {
      name: 'bench',
      label: text.tabs.bench,
      element: find('#bench'),
      aside: true,
      load: async (parts) => (await import('./tabs/measure.js')).createMeasure({ ...parts, element: find('#bench'), live }),
    },
  ],
});

tools.append(themes.element, button(text.keys, () => void keys.open(), { action: 'keys' }), button(text.share, () => void share(), { action: 'share' }));
find('#top').append(h('h1', {}, text.title), nav, tools);
document.addEventListener('visibilitychange', () => {
  if (document.hidden) router.pause();
});
window.addEventListener('unhandledrejection', (event) => {
  if (event.reason instanceof EngineError && event.reason.fatal) event.preventDefault(); // told by the tab whose engine it is
});
if (embedded) void import('./embed.js').then(({ createEmbed }) => createEmbed({ active: router.active }));
void router.arrive(location.hash).then(keep);

/** Keeps the page for visits without the network, once it stands; an embedded page keeps nothing. */
async function keep() {
  if (!import.meta.env.PROD || embedded) return;
  try {
    const { keepOffline } = await import('./offline/keep.js');
    await keepOffline({ head: find('#top'), announce: (message) => write(live, message) });
  } catch {
    // the network has gone since: nothing is kept yet
  }
}

/** What can be given away of the open tab: links, a frame, a file, a citation. */
async function share() {
  const { openShare } = await import('./share/dialog.js');
  await openShare(router.active());
}

/** Shows a tree in the workbench. @param {string} xml @param {string} title what it is, for people */
async function openTree(xml, title) {
  const tab = /** @type {TreesTab | null} */ (await router.visit('trees'));
  tab?.openTree(xml, title);
}

/** Lets a tree of the workbench coach the blue team. @param {string} xml */
async function playCoach(xml) {
  const tab = /** @type {SoccerTab | null} */ (await router.visit('soccer'));
  await tab?.playCoach(xml);
}
