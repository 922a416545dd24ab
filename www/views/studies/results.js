import { button, h, write } from '../../ui/dom.js';
import { copy } from '../../ui/share.js';
import { text as page } from '../../ui/strings.en.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { createReportTable } from './table.js';

/** @import { State } from '../../state.js' */
/** @import { Committed, Shown } from '../../studies/committed.js' */
/** @import { StudyRun } from '../../studies/run.js' */
/** @import { StudySession } from '../../studies/session.js' */
/** @import { Speed } from '../../studies/speed.js' */
/** @import { Reported } from '../../studies/types.js' */

const LARGE_SECONDS = 600; // one worker
const LARGE_STEPS = 100_000_000; // robots times steps, while it is not known how fast this computer is

/**
 * The results pane: what the study is about, how much of it is there, figure, tables and tests. Committed results stand in
 * for those that were not made here, and say so.
 *
 * @param {{ pane: HTMLElement, run: StudyRun, session: StudySession, state: State, speed: Speed, committed: Committed,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts
 */
export function createStudyResults({ pane, run, session, state, speed, committed, say }) {
  const title = h('h2', { id: 'studies-title' });
  const tag = h('p', { class: 'tag' });
  const about = h('p', { class: 'studies-about' });
  const stale = h('p', { class: 'stale', hidden: true });
  const command = h('code', { class: 'command', tabindex: 0 });
  const largeWhy = h('p', {});
  const saveFirst = h('p', { class: 'secondary' }, text.results.saveFirst);
  const large = h('div', { class: 'studies-large', hidden: true }, largeWhy, h('div', { class: 'row' }, command, button(text.results.copy, () => void copyCommand())), saveFirst);
  const mine = whoseButton('yours');
  const theirs = whoseButton('committed');
  const whose = h('div', { class: 'row studies-whose', role: 'group', 'aria-label': text.results.whose, hidden: true }, mine, theirs);
  const source = h('p', { class: 'studies-source', hidden: true });
  const extent = h('p', { class: 'studies-extent' });
  const failures = h('div', {});
  const figure = h('img', { class: 'studies-figure', hidden: true, width: 760, height: 500 });
  const figureBox = h('div', { class: 'scroll studies-figure-box', tabindex: 0, role: 'region', 'aria-label': text.results.figureBox, hidden: true }, figure);
  const verdicts = h('p', { class: 'studies-verdicts' });
  const tables = h('div', {});
  const others = h('div', {});
  const more = h('details', { class: 'studies-more', hidden: true }, h('summary', {}, text.results.more), others);
  pane.append(
    h('div', { class: 'world-head' }, h('div', { class: 'studies-heading' }, h('a', { href: '#/studies', class: 'back' }, text.back), title), tag),
    about,
    stale,
    large,
    whose,
    source,
    extent,
    failures,
    figureBox,
    verdicts,
    tables,
    more,
  );

  /** @type {Map<string, ReturnType<typeof createReportTable>>} */
  const shownTables = new Map();
  /** @type {'yours' | 'committed'} */
  let chosen = 'yours';
  /** @type {Shown | null} */
  let loaded = null;
  let drawn = '';
  let study = ''; // what the tables are of

  /** @param {'yours' | 'committed'} which */
  function whoseButton(which) {
    return button(which === 'committed' ? text.results.committed : '', () => {
      chosen = which;
      void load();
    });
  }

  async function copyCommand() {
    const line = command.textContent ?? '';
    say(await copy(line) ? text.results.copied : page.foot.notCopied(line));
  }

  /** Fetches the committed results when they are what is shown. */
  async function load() {
    const name = session.outline?.name ?? '';
    loaded = null;
    if (chosen === 'committed' && committed.has(name)) {
      try {
        const read = await committed.read(name);
        if (chosen === 'committed' && session.outline?.name === name) loaded = read;
      } catch (error) {
        chosen = 'yours';
        say(text.results.committedBad(`results/${name}.csv`, error instanceof Error ? error.message : String(error)), 'problem');
      }
    }
    show();
  }

  /** Another study or size: committed results stand in where there is nothing of one's own. */
  function opened() {
    const has = offers();
    chosen = has && run.done() === 0 ? 'committed' : 'yours';
    void load();
  }

  const offers = () => session.size === 'paper' && committed.has(session.outline?.name ?? '');

  function show() {
    const { outline, fault } = session;
    write(title, outline?.title || outline?.name || text.pane.form);
    write(about, outline?.about ?? '');
    write(tag, stateWord());
    stale.hidden = !fault;
    write(stale, outline ? text.fault.last : text.fault.none);
    showLarge();
    whose.hidden = !offers();
    write(mine, text.results.yours(run.done(), run.plan?.runs ?? 0));
    mine.setAttribute('aria-pressed', String(chosen === 'yours'));
    theirs.setAttribute('aria-pressed', String(chosen === 'committed'));
    source.hidden = chosen !== 'committed' || !loaded;
    if (loaded) write(source, [text.results.committedAbout(loaded.file), loaded.hash === run.plan?.hash ? '' : text.results.committedOther].join(' '));
    showReport(chosen === 'committed' ? (loaded?.reported ?? null) : run.reported);
  }

  function stateWord() {
    if (state.name === 'busy') return text.state.running;
    if (state.name === 'finished') return text.state.finished;
    if (!run.plan || state.name !== 'paused') return '';
    if (run.underWay() > 0) return text.state.paused;
    return run.done() > 0 ? text.state.partial : text.state.fresh;
  }

  function showLarge() {
    const outline = session.outline?.sizes.find(({ size }) => size === session.size);
    const range = outline && session.outline ? speed.estimate(session.outline.world, outline.robot_steps, run.workers) : null;
    const isLarge = outline !== undefined && (session.tooMany || (range ? range[1] > LARGE_SECONDS : outline.robot_steps > LARGE_STEPS));
    large.hidden = !isLarge || state.name === 'finished';
    if (!outline || !isLarge) return;
    const name = session.outline?.name ?? '';
    write(largeWhy, session.tooMany ? text.results.tooMany(outline.runs) : text.results.large(outline.runs, range));
    write(command, `cargo run --release -- study studies/${name}.json${session.size === 'paper' ? '' : ` --size ${session.size}`} --out ${name}.csv`);
    saveFirst.hidden = session.pristine();
  }

  /** @param {Reported | null} reported */
  function showReport(reported) {
    const empty = !reported || reported.results.indexOf('\n') === reported.results.length - 1;
    write(extent, empty ? `${text.results.none} ${text.results.start}` : text.results.extent(reported.report.extent));
    failures.replaceChildren(...(reported?.report.failures ?? []).map(([reason, count]) => h('p', { class: 'field-error' }, text.results.failed(reason, count))));
    draw(empty ? null : reported.figure, reported?.report.title ?? '');
    showTables(empty ? null : reported);
  }

  /** As an image, which follows the theme and holds its own styles. @param {string | null} svg @param {string} heading */
  function draw(svg, heading) {
    figureBox.hidden = figure.hidden = svg === null;
    if (svg === null || svg === drawn) return;
    drawn = svg;
    figure.alt = text.results.figure(heading);
    const before = figure.src;
    figure.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    figure.decode().catch(() => {}).finally(() => URL.revokeObjectURL(before));
  }

  /** @param {Reported | null} reported */
  function showTables(reported) {
    const sections = reported?.report.sections ?? [];
    const plotted = figureMetric();
    const rank = (/** @type {string} */ name) => (name === 'paper' || name.startsWith('matches-') ? 0 : name === plotted ? 1 : name === 'tests' ? 2 : 3);
    const ordered = sections.map((section, index) => ({ section, index })).sort((a, b) => rank(a.section.name) - rank(b.section.name) || a.index - b.index);
    const names = ordered.map(({ section }) => section.name).join(' ');
    if (names !== study) {
      study = names;
      shownTables.clear();
      for (const { section } of ordered) shownTables.set(section.name, createReportTable(section.name));
      const elements = (/** @type {boolean} */ first) => ordered.filter(({ section }) => rank(section.name) < 3 === first).map(({ section }) => /** @type {HTMLElement} */ (shownTables.get(section.name)?.element));
      tables.replaceChildren(...elements(true));
      others.replaceChildren(...elements(false));
    }
    for (const section of sections) shownTables.get(section.name)?.show(section);
    more.hidden = others.children.length === 0;
    showVerdicts(sections.find(({ name }) => name === 'paper')?.rows ?? []);
  }

  /** @param {string[][]} rows */
  function showVerdicts(rows) {
    /** @type {Map<string, number>} */
    const counts = new Map();
    for (const row of rows) counts.set(row[row.length - 1], (counts.get(row[row.length - 1]) ?? 0) + 1);
    write(verdicts, counts.size > 0 ? text.results.verdicts([...counts]) : '');
    verdicts.hidden = counts.size === 0;
  }

  function figureMetric() {
    try {
      return JSON.parse(run.complete()).figure?.metric ?? '';
    } catch {
      return ''; // no study is open yet
    }
  }

  run.on('plan', opened);
  run.on('report', show);
  run.on('moved', (what) => {
    if (what === 'started' && chosen === 'committed') chosen = 'yours';
    show();
  });
  session.on(show);
  state.on(show);

  return {
    /** The results on screen, for taking them away. @returns {Promise<Reported | null>} */
    shown: async () => (chosen === 'committed' && loaded ? loaded.reported : run.results()),

    /** The study that the results on screen were made from. */
    origin: () => (chosen === 'committed' && loaded ? loaded : { spec: run.complete(), hash: run.plan?.hash ?? '' }),
  };
}
