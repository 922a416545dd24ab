import { h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/**
 * The panes of the tab, in reading order: pitch, controls, inspector, transport, footer.
 *
 * @param {HTMLElement} element
 */
export function createSoccerFrame(element) {
  const pane = h('section', { class: 'world-pane soccer-pane', 'aria-label': soccerText.pane.pitch });
  const controls = h('section', { class: 'controls-pane', 'aria-label': soccerText.pane.controls });
  const inspector = h('section', { class: 'inspector-pane', 'aria-label': soccerText.pane.inspector });
  const main = h('main', { class: 'frame soccer-frame' }, pane, controls, inspector);
  const transport = h('section', { class: 'transport soccer-transport', 'aria-label': soccerText.transport.region });
  const foot = h('footer', { class: 'foot' });
  element.append(main, transport, foot);

  const side = (/** @type {string} */ team) => ({ name: h('span', { class: 'side-name' }), goals: h('b', { class: 'goals', id: `soccer-goals-${team}` }), team });
  const [blue, yellow] = [side('blue'), side('yellow')];
  const badge = (/** @type {string} */ team) => h('span', { class: `badge ${team}`, 'aria-hidden': 'true' });
  const board = h(
    'p',
    { class: 'lede scoreboard', id: 'soccer-score' },
    h('span', { class: 'side' }, badge('blue'), blue.name),
    h('span', { class: 'result' }, blue.goals, ' : ', yellow.goals),
    h('span', { class: 'side' }, yellow.name, badge('yellow')),
  );
  const time = h('p', { class: 'match-time', id: 'soccer-time' });
  const tag = h('p', { class: 'tag', id: 'soccer-tag' });
  const head = h('div', { class: 'world-head' }, board, time, tag);
  const stages = h('div', { class: 'soccer-stages' });
  pane.append(h('h2', { class: 'unseen' }, soccerText.pane.pitch), head, stages);

  return {
    main,
    pane,
    head,
    stages,
    controls,
    inspector,
    transport,
    foot,

    /** @param {{ names: string[], goals: number[], time: string, tag: string }} shown */
    show(shown) {
      write(blue.name, shown.names[0]);
      write(yellow.name, shown.names[1]);
      write(blue.goals, shown.goals[0]);
      write(yellow.goals, shown.goals[1]);
      write(time, shown.time);
      write(tag, shown.tag);
      tag.classList.toggle('blank', shown.tag === '');
    },
  };
}

/** @typedef {ReturnType<typeof createSoccerFrame>} SoccerFrame */
