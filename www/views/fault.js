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
     * The engine broke.
     *
     * @param {string} message
     * @param {{ version: string, tick: number, again: (() => void) | null, words?: { reload: string, kept: string } }} way
     *   `again` takes a new engine to the tick that was reached; null when nothing was there yet
     */
    broke(message, { version, tick, again, words = { reload: text.fault.reload(tick), kept: text.fault.kept } }) {
      const report = [message, `${text.title} ${version}`, location.href, `tick ${tick}`, navigator.userAgent].join('\n');
      const copyReport = async () => {
        if (await copy(report)) say(text.fault.reported);
        else say(text.foot.notCopied(report));
      };
      const reload = () => {
        box.hidden = true;
        again?.();
      };
      const way = again ? button(words.reload, reload, { class: 'primary' }) : button(text.fault.retry, () => location.reload(), { class: 'primary' });
      box.replaceChildren(
        h('p', { class: 'message' }, again ? text.fault.broken(message) : text.fault.start(message)),
        h('p', {}, again ? words.kept : text.fault.commandLine),
        h('div', { class: 'row' }, way, button(text.fault.report, () => void copyReport())),
      );
      box.hidden = false;
    },
  };
}
