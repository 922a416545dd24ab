// Writes www/landing.html: what the page shows before any script has run. The engine makes the opening scenario's moment,
// and the picture of it is the one that the live world begins with. www/opening.js names the moment.

import { readFileSync, writeFileSync } from 'node:fs';
import { World, initSync } from '../www/engine/swarm_playground.js';
import { crownOf, sinkOf } from '../www/draw/world.js';
import { locate } from '../www/draw/frame.js';
import { OPENING } from '../www/opening.js';
import { landingText as text } from '../www/ui/strings.landing.en.js';

const MOST_BYTES = 12_000; // of the drawing
const UNIT = 10; // units of the drawing for one of the arena: places are whole numbers
const MARGIN = 1.08; // the world's own

const { memory } = initSync({ module: readFileSync('www/engine/swarm_playground_bg.wasm') });
const preset = JSON.parse(readFileSync(`scenarios/${OPENING.preset}.json`, 'utf8'));
const world = new World(JSON.stringify({ ...preset, seed: OPENING.seed }));
world.advance(OPENING.tick);
/** @type {import('../www/types.js').Layout} */
const layout = JSON.parse(world.layout());
const frame = new Float32Array(memory.buffer, world.frame_pointer(), world.frame_length());
const at = locate(layout);

const whole = (/** @type {number} */ value) => Math.round(value * UNIT);
const x = whole;
const y = (/** @type {number} */ value) => -whole(value) || 0; // up in the arena, down in the drawing

/** Edge with a mark every ten units, as the world draws it. */
function edge() {
  const half = layout.arena.half;
  const marks = [];
  for (let mark = -half; mark <= half; mark += 10) {
    const length = mark % 50 === 0 ? 11 : 7;
    marks.push(`M${x(mark)} ${whole(half)}v${length}M${-whole(half)} ${y(mark)}h${-length}`);
  }
  return `<path class="e" d="M${-whole(half)} ${-whole(half)}h${whole(2 * half)}v${whole(2 * half)}h${-whole(2 * half)}z${marks.join('')}"/>`;
}

function places() {
  return layout.places.map((place) => {
    const [crownX, crownY] = crownOf(place);
    const said = place.kind === sinkOf(layout) ? ` ${frame[at.delivered]} / ${frame[at.total]}` : '';
    const name = place.kind.charAt(0).toUpperCase() + place.kind.slice(1);
    return `<circle class="${place.kind}" cx="${x(place.x)}" cy="${y(place.y)}" r="${whole(place.radius)}"/><text x="${x(crownX)}" y="${y(crownY) - 16}">${name}${said}</text>`;
  });
}

function food() {
  const squares = [];
  for (let item = 0; item < at.items; item += 1) {
    const base = at.itemStart + item * at.itemStride;
    if (frame[base + at.itemState] === 0) squares.push(`M${x(frame[base + at.itemX]) - 4} ${y(frame[base + at.itemY]) - 4}h8v8h-8z`);
  }
  return `<path class="f" d="${squares.join('')}"/>`;
}

function robots() {
  const marks = [];
  for (let id = 0; id < at.agents; id += 1) {
    const base = at.agentStart + id * at.agentStride;
    const turn = Math.round((-frame[base + at.heading] * 180) / Math.PI);
    const kind = frame[base + at.carrying] !== 0 ? 'c' : 'r';
    marks.push(`<use href="#still-${kind}" transform="translate(${x(frame[base + at.x])} ${y(frame[base + at.y])})rotate(${turn})"/>`);
  }
  return marks.join('');
}

const side = whole(2 * layout.arena.half * MARGIN);
const robot = '<circle r="12.5"/><path d="M4.4 0h8.1"/>';
const drawing =
  `<svg id="still" viewBox="${-side / 2} ${-side / 2} ${side} ${side}" role="img" aria-label="${text.still}" data-preset="${OPENING.preset}" ` +
  `data-seed="${OPENING.seed}" data-tick="${OPENING.tick}" data-fingerprint="${world.fingerprint()}">` +
  `<defs><g id="still-r">${robot}</g><g id="still-c">${robot}<circle class="l" r="7"/></g></defs>` +
  `${edge()}${places().join('')}${food()}${robots()}</svg>`;
if (drawing.length > MOST_BYTES) throw new Error(`the still has ${drawing.length} bytes, ${MOST_BYTES} are allowed`);

const links = text.links.map(([href, label]) => `<a href="${href}">${label}</a>`).join(' ');
writeFileSync(
  'www/landing.html',
  `<div class="world-head"><p class="lede">${text.lede}</p></div>\n` +
    `<nav class="landing" id="landing" aria-label="${text.label}"><button type="button" class="primary" id="from-random" disabled>${text.fromRandom}</button> <span>${text.or}</span> ${links}</nav>\n` +
    `<div class="stage">${drawing}</div>\n`,
);
