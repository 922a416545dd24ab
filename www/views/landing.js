/** @import { Run } from '../run.js' */
/** @import { Session } from '../session.js' */

/**
 * The link to the still that the page shows first, for an address that asks for nothing; empty for any other address.
 *
 * @param {string} hash
 */
export function openingOf(hash) {
  const still = document.querySelector('#still');
  const landing = document.querySelector('#landing');
  if (!/^(#?\/?(forage)?)$/.test(hash) || !(still instanceof SVGElement)) {
    landing?.remove();
    still?.remove();
    return '';
  }
  const { preset, seed, tick, fingerprint } = still.dataset;
  return `#/forage?preset=${preset}&seed=${seed}&t=${tick}&f=${fingerprint}`;
}

/**
 * The one button under the first sentence: tick 0 at full speed, with the curves drawn as they grow. It can be pressed
 * before the engine is there; then it is done as soon as it is.
 */
export function createLanding() {
  /** @type {(() => void) | null} */
  let act = null;
  let wished = false;
  const button = document.querySelector('#from-random');
  if (button instanceof HTMLButtonElement) {
    button.disabled = false;
    button.addEventListener('click', () => {
      if (act) act();
      wished ||= act === null;
      button.setAttribute('aria-busy', String(wished));
    });
  }

  return {
    /** Whether the button was pressed before the engine was there. */
    wished: () => wished,

    /** @param {{ ready: Session, run: Run, fastest: () => void, charts: () => void }} parts */
    ready({ ready, run, fastest, charts }) {
      act = async () => {
        button?.removeAttribute('aria-busy');
        charts();
        run.cancel();
        fastest();
        if (await ready.restart()) run.play();
      };
    },

    /** Does what was wished for. */
    now: () => void act?.(),
  };
}
