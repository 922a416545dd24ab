import { button, h, write } from '../ui/dom.js';
import { abText } from '../ui/strings.ab.en.js';
import { text } from '../ui/strings.en.js';
import { createPairChart } from '../views/ab/chart.js';
import { createSide } from '../views/ab/sides.js';
import { createWorldView } from '../views/world.js';

/** @import { Theme } from '../draw/theme.js' */
/** @import { Engine } from '../engine.js' */
/** @import { Lens } from '../lens.js' */
/** @import { Run } from '../run.js' */
/** @import { Selection } from '../selection.js' */
/** @import { State } from '../state.js' */
/** @import { WorldView } from '../views/world.js' */
/** @import { Pair } from './pair.js' */
/** @import { Side } from './parting.js' */
/** @import { Twin } from './twin.js' */

/**
 * A | B on screen: both arenas with one camera, where they part, their curves, and which of the two the inspector shows.
 *
 * @param {{ engine: Engine, other: Engine, lens: Lens, run: Run, twin: Twin, pair: () => Pair, state: State, selection: Selection, world: WorldView,
 *   theme: () => Theme, onTheme: (listener: () => void) => void, pane: HTMLElement, inspector: HTMLElement, announce: (message: string) => void }} parts
 *   `other` is B's engine and `twin` its run; `world` shows A, here and alone
 */
export function createStage({ engine, other, lens, run, twin, pair, state, selection, world, theme, onTheme, pane, inspector, announce }) {
  let on = false;
  /** @type {Side} */
  let side = 'a';
  let told = '';

  const sides = { a: createSide('a'), b: createSide('b') };
  const arena = createWorldView({
    pane: sides.b.element,
    run: twin,
    state,
    selection,
    theme,
    drawn: () => {},
    rings: () => side === 'b',
    beside: { view: world.view, invalidate: world.invalidate, zoomTo: world.zoomTo, fit: world.fit, id: 'canvas-b', describedBy: 'ab-counts-b' },
  });
  arena.canvas.setAttribute('aria-label', abText.arena('B'));
  const chart = createPairChart({ engines: () => (on ? { a: engine, b: other } : null), tick: () => run.tick, theme });
  const arenas = h('div', { class: 'ab-arenas' }, sides.a.element, sides.b.element);
  const status = h('p', { class: 'ab-status', id: 'ab-status' });
  const goThere = button('', () => void run.seek(pair().parting.parted ?? 0).catch(() => {}), { class: 'quiet' });
  const strip = h('div', { class: 'ab-strip' }, status, goThere);
  const letters = /** @type {const} */ (['a', 'b']).map((letter) => button(letter.toUpperCase(), () => look(letter), { class: 'ab-look' }));
  const looking = h('div', { class: 'scopes ab-looking', role: 'group', 'aria-label': abText.side }, h('span', { 'aria-hidden': 'true' }, abText.side), ...letters);
  onTheme(chart.restyle);
  for (const [letter, { canvas }] of /** @type {[Side, WorldView][]} */ ([['a', world], ['b', arena]])) {
    const here = () => on && letter !== side && look(letter); // who chooses a robot there looks there
    canvas.addEventListener('pointerdown', here);
    canvas.addEventListener('keydown', (event) => void (/^(Arrow|Home|End)/.test(event.key) && here()));
  }

  /** The inspector shows A or B. @param {Side} letter */
  function look(letter) {
    side = letter;
    letters.forEach((key, index) => key.setAttribute('aria-pressed', String('ab'[index] === letter)));
    for (const name of /** @type {const} */ (['a', 'b'])) sides[name].element.toggleAttribute('data-looked', name === letter);
    if (letter === 'a') lens.look({ request: engine.request, run, world: () => world, side: 'a' });
    else lens.look({ request: other.request, run: twin, world: () => arena, side: 'b' });
    world.showRinged();
    arena.showRinged();
  }

  return {
    get on() {
      return on;
    },

    /** Whether a chosen node is one of A's trees. */
    rings: () => !on || side === 'a',

    /** A was drawn: B follows. */
    drew: () => on && arena.draw(),

    /** Puts both arenas where the one was. */
    reveal() {
      on = true;
      world.head.prepend(strip);
      world.stage.before(arenas);
      sides.a.element.append(world.stage);
      arenas.after(chart.element);
      (inspector.querySelector('.sheet-body') ?? inspector).prepend(looking);
      world.canvas.setAttribute('aria-label', abText.arena('A'));
      pane.classList.add('ab');
      document.body.classList.add('ab-open');
      look('a');
    },

    conceal() {
      on = false;
      arenas.before(world.stage);
      for (const part of [strip, arenas, chart.element, looking]) part.remove();
      world.canvas.setAttribute('aria-label', text.world.label);
      pane.classList.remove('ab');
      document.body.classList.remove('ab-open');
      side = 'a';
      lens.look();
      world.showRinged();
    },

    /** @param {Record<Side, string>} names */
    name(names) {
      sides.a.name(names.a);
      sides.b.name(names.b);
    },

    /** Counts, fingerprints and curves of the present tick. */
    showTick() {
      if (!on) return;
      const at = pair().at();
      sides.a.show(run, at.a);
      sides.b.show(twin, at.b);
      chart.refresh();
    },

    /** Other runs: their curves begin anew. */
    forget: chart.forget,

    showParting() {
      const { parted, compared } = pair().parting;
      if (parted === null) write(status, abText.parting.soFar(compared()));
      else write(status, parted === 0 ? abText.parting.start : abText.parting.until(parted - 1));
      status.dataset.until = String(parted === null ? '' : parted - 1);
      goThere.hidden = parted === null || parted === 0;
      write(goThere, abText.goThere(parted ?? 0));
      const news = parted === null ? '' : (status.textContent ?? '');
      if (on && news && news !== told) announce(news);
      told = news;
    },
  };
}

/** @typedef {ReturnType<typeof createStage>} Stage */
