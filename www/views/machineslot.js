import { h } from '../ui/dom.js';

/** @import { Machine } from '../types.js' */
/** @typedef {typeof import('./machinefigure.js')} Figures */

/**
 * A place for a state machine, whose view is loaded when the first one comes.
 *
 * @param {Parameters<Figures['createMachineFigure']>[0]} options
 */
export function createMachineSlot(options) {
  const element = h('div', { hidden: true });
  /** @type {ReturnType<Figures['createMachineFigure']> | null} */
  let figure = null;
  /** @type {[Machine, { shape: string, group: boolean, selected?: number | null }] | null} */
  let wanted = null;

  async function load() {
    const { createMachineFigure } = await import('./machinefigure.js');
    if (figure) return;
    figure = createMachineFigure(options);
    element.append(figure.element);
    if (wanted) figure.show(...wanted);
  }

  return {
    element,

    /** @param {Machine | null | undefined} machine none hides the place @param {{ shape: string, group: boolean, selected?: number | null }} how */
    show(machine, how) {
      element.hidden = !machine;
      wanted = machine ? [machine, how] : null;
      if (!machine) return;
      if (figure) figure.show(machine, how);
      else void load();
    },

    /** @param {number | null} rule */
    point: (rule) => figure?.point(rule),
  };
}
