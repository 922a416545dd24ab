/** @import { Shared } from '../router.js' */

/** What a tab is after, as a reference. */
const PAPERS = /** @type {Record<Shared['world'], string>} */ ({
  geese: 'After: BeTr-GEESE, Cells2Societies workshop at ICLR 2022.',
  sequencing: 'After: optimal swarm behaviour sequencing.',
  trees: 'Semantics: BehaviorTree.CPP 4.10, XML format 4.',
  studies: 'The study names what it is compared with.',
  soccer: 'After: Coordinating a Robotics Multi-Agent System Using Behavior Trees.',
});

/** Texts of the share dialog. */
export const shareText = {
  title: 'Share',
  about: 'The link holds the whole scenario, the moment and its fingerprint.',
  link: 'Link',
  pinned: 'Link to this version',
  pinnedAbout: 'Opens with the same program for ever, where the site keeps old versions.',
  hide: 'Hide parts',
  hideAbout: 'What is hidden still applies. The link offers a button that shows everything again.',
  hidden: (/** @type {number} */ count) => (count > 0 ? `${count} hidden` : ''),
  frame: 'Frame for a page of your own',
  frameShows: 'The frame shows',
  frameCode: 'Line of HTML',
  frameTitle: (/** @type {string} */ title) => `Swarm playground: ${title}`,
  qr: 'QR code of the link',
  noQr: 'The link is too long for a QR code.',
  cite: 'Citation',
  file: 'Save JSON',
  noFile: 'There is no file of this list.',
  copy: 'Copy',
  copied: 'Copied.',
  notCopied: 'The browser does not allow copying. The text is selected: copy it by hand.',
  tooLong: (/** @type {number} */ length) => `The link has ${length} characters, too many for some programs. The JSON file says the same.`,
  failed: (/** @type {string} */ why) => `Nothing to share yet: ${why}.`,

  /** @param {Shared} shared @param {string} link */
  citation: ({ title, version, seed, tick, fingerprint, plan, world }, link) =>
    [
      `Swarm playground ${version}: ${title}.`,
      seed === null ? '' : `Seed ${seed}.`,
      tick === null ? '' : `Tick ${tick}.`,
      plan ? `Plan ${plan}.` : '',
      fingerprint ? `Fingerprint ${fingerprint}.` : '',
      link,
    ]
      .filter(Boolean)
      .join(' ') + `\n${PAPERS[world]}`,
};
