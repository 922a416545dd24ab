import { readMoment } from '../../draw/benchstate.js';
import { h, s } from '../../ui/dom.js';
import { standalone } from '../../ui/share.js';
import { createNode } from './figurenode.js';

/** @import { Label, Layout } from '../../draw/benchlayout.js' */
/** @import { BenchNode, Moment } from '../../trees/types.js' */
/** @import { Look } from './figurenode.js' */

/**
 * A whole drawing as files of their own, without what can be pressed: one for each moment asked for.
 *
 * @param {{ host: HTMLElement, title: string, nodes: BenchNode[], labels: Label[], layout: Layout, lookOf: (id: number) => Look,
 *   letters: Map<number, string> }} parts `host` lends its styles, `letters` are the breakpoints by node
 */
export function createPicture({ host, title, nodes, labels, layout, lookOf, letters }) {
  const [width, height] = [Math.ceil(layout.width), Math.ceil(layout.height)];
  const looks = layout.shown.map(({ id }) => lookOf(id)); // a film keeps the folds it began with
  const marks = new Map(letters);
  return {
    width,
    height,

    /** @param {Moment | null} moment */
    svg(moment) {
      const stateOf = readMoment(nodes, moment);
      const items = layout.shown.map((spot, index) => {
        const item = createNode(nodes[spot.id], labels[spot.id], spot, looks[index]);
        item.paint(stateOf(spot.id), marks.get(spot.id), false);
        return item.element;
      });
      const edges = s('path', { class: 'bench-edges', d: layout.links });
      const taken = s('path', { class: 'bench-edges bench-taken', d: takenEdges(layout, stateOf) });
      const drawing = s('svg', { class: 'bench-stage bench-picture' }, edges, taken, ...items);
      drawing.classList.toggle('bench-started', hasStarted(moment));
      host.append(drawing); // styles are computed in the page only
      const svg = standalone(drawing, { title, width, height, ground: getComputedStyle(host).getPropertyValue('--ground').trim() });
      drawing.remove();
      return svg;
    },
  };
}

/** The edges above the nodes that were ticked now. @param {Layout} layout @param {ReturnType<typeof readMoment>} stateOf */
export const takenEdges = ({ shown }, stateOf) => shown.map(({ id, edge }) => (stateOf(id).when === 'now' ? edge : '')).join('');

/** Whether nodes that were never ticked are drawn as such. @param {Moment | null} moment */
export const hasStarted = (moment) => moment !== null && moment.tick > 0;

/**
 * A drawing that a canvas can take.
 *
 * @param {string} svg
 * @param {{ width: number, height: number }} size
 */
export async function imageOf(svg, { width, height }) {
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = h('img', { width, height, src: address });
    await image.decode();
    return image;
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** @typedef {ReturnType<typeof createPicture>} TreePicture */
