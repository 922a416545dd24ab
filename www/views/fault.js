import { button, h } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { copy } from '../ui/share.js';

/**
 * A failure in place of the world: what happened, what is kept, what to do.
 *
 * @param {HTMLElement} pane
 * @param {(message: string) => void} say
 */
export function createFault(pane, say) {
  const box = h('div', { class: 'fault', role: 'alert', hidden: true });
  pane.append(box);

  return {
    /**
     * @param {string} message
     * @param {{ kept: string, report: string, offer: string, press: () => void }} way out of it
     */
    show(message, way) {
      box.replaceChildren(h('p', { class: 'message' }, message));
      box.hidden = false;
      const report = async () => {
        if (await copy(way.report)) say(text.fault.reported);
        else say(text.foot.notCopied(way.report));
      };
      box.append(h('p', {}, way.kept), h('div', { class: 'row' }, button(way.offer, way.press, { class: 'primary' }), button(text.fault.report, () => void report())));
    },
    hide: () => void (box.hidden = true),
  };
}
