import { messageOf } from '../session.js';
import { button, h, write } from '../ui/dom.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { text } from '../ui/strings.en.js';
import { createScenarioFiles } from '../views/scenariofiles.js';
import { createChartsTab } from '../views/soccer/chartstab.js';
import { createCoachTab } from '../views/soccer/coachtab.js';
import { createCoachText } from '../views/soccer/coachtext.js';
import { createSoccerControls } from '../views/soccer/controls.js';
import { createSoccerFoot } from '../views/soccer/foot.js';
import { createHandles } from '../views/soccer/handles.js';
import { createSoccerInspector } from '../views/soccer/inspector.js';
import { callTitle, createLogTab } from '../views/soccer/logtab.js';
import { createOrganisationTab } from '../views/soccer/organisationtab.js';
import { createPitch } from '../views/soccer/pitch.js';
import { createPitchLegend } from '../views/soccer/legend.js';
import { createRolesTab } from '../views/soccer/rolestab.js';
import { createScopes } from '../views/soccer/scopes.js';
import { createSituations } from '../views/soccer/situations.js';
import { createSoccerTransport } from '../views/soccer/transport.js';
import { createDrive } from './drive.js';
import { arranged } from './film.js';
import { BALL, createHold, moved } from './hold.js';
import { createShapes } from './shapes.js';
import { createStretches } from './stretches.js';

/** @import { PitchTheme } from '../draw/soccer.js' */
/** @import { Engine } from '../engine.js' */
/** @import { State } from '../state.js' */
/** @import { ThemeSwitch } from '../ui/theme.js' */
/** @import { SoccerFrame } from '../views/soccer/frame.js' */
/** @import { SoccerCompare } from './compare.js' */
/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { SoccerSession } from './session.js' */
/** @import { Tournament } from './tournament.js' */
/** @import { Moment } from './types.js' */

const LOOK_MS = 90; // while it plays, the inspector is written at most eleven times a second
const CALL_TICKS = 90; // for how long a call stays on screen after play has gone on
const ADDRESS_MS = 250;

/**
 * Everything of the tab put together: what is on screen follows from the film, the moment, and what was done to the match.
 *
 * @param {{ element: HTMLElement, frame: SoccerFrame, state: State, engine: Pick<Engine, 'request'>, match: SoccerMatch, playback: SoccerPlayback,
 *   session: SoccerSession, themes: ThemeSwitch, spawn: () => Worker, broke: (message: string) => void, openTree: (xml: string, title: string) => Promise<void>,
 *   say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void, announce: (message: string) => void }} parts
 */
export function createSoccerBoard({ element, frame, state, engine, match, playback, session, themes, spawn, broke, openTree, say, announce }) {
  const layers = { names: true, trail: true };
  const style = (/** @type {string} */ name) => getComputedStyle(element).getPropertyValue(name).trim();
  const theme = () => /** @type {PitchTheme & { yellowLine: string }} */ ({ ...themes.theme(), yellow: style('--yellow'), yellowLine: style('--yellow-line'), line: style('--line') });
  const { setting } = session;
  const shapes = createShapes(engine);
  const stretches = createStretches(match);
  /** @type {Moment | null} */
  let moment = null;

  const hold = createHold({ match, playback, session, changed: showPitch, announce });
  const wide = () => pitch.size().width >= 620;

  /** Robots and ball as they are shown: what is dragged stands where it is dragged to. */
  function shown() {
    const now = match.film.frame(playback.tick);
    const place = hold.dragged();
    if (!place || hold.chosen === null) return now;
    const spots = (/** @type {number} */ first) => [0, 1, 2].map((robot) => /** @type {[number, number, number]} */ ([...now.subarray(3 * (first + robot), 3 * (first + robot) + 3)]));
    return arranged(now, moved({ ball: [now[18], now[19]], blue: spots(0), yellow: spots(3) }, hold.chosen, place));
  }

  /** What is drawn of a moment; null while there is none. @param {number} tick @param {Float32Array} frame @param {Record<string, string>} names of the roles */
  const sceneAt = (tick, frame, names) => {
    const roles = Array.from({ length: BALL }, (_, robot) => names[setting.roles[match.film.role(tick, robot)]] ?? '');
    return match.film.count > 0 ? { walls: setting.walls, frame, film: match.film, tick, names: roles, exchanged: match.exchanged, layers } : null;
  };
  const pitch = createPitch({
    label: soccerText.pitch.label,
    scene: () => sceneAt(playback.tick, shown(), wide() ? soccerText.roles : soccerText.short),
    theme,
    drawn: () => handles.show(),
  });
  const ended = () => match.over && playback.tick >= match.front();
  const may = () => !drive.driving() && state.name !== 'error' && !match.held && !compare?.on() && !tournament?.on();
  const handles = createHandles({ pitch, hold, frame: () => (match.film.count > 0 ? shown() : null), may: () => may() && !ended(), clear: () => hold.choose(null) });
  const drive = createDrive({ match, playback, session, announce, say, changed: show, keys: element });
  const situations = createSituations({ hold, session, drive: drive.element, takeBack, stage, say });
  const legend = createPitchLegend({ layers, playback, changed: () => (pitch.invalidate(), compare?.redraw()) });
  const band = h('p', { class: 'call-band', id: 'soccer-call' });
  const scopes = createScopes(() => inspector.show());
  const files = createScenarioFiles({ element, id: 'soccer-file', open: session.openFile, say });
  const coachText = createCoachText({ session, shapes, changed: () => inspector.show() });
  const seen = () => moment;
  const coach = createCoachTab({ scopes, session, setting, shapes, moment: seen, text: coachText, openTree });
  const inspector = createSoccerInspector({
    pane: frame.inspector,
    panels: [
      { name: 'coach', label: soccerText.inspector.coach, panel: coach },
      { name: 'roles', label: soccerText.inspector.roles, panel: createRolesTab({ scopes, match, playback, session, setting, shapes, stretches, moment: seen }) },
      { name: 'organisation', label: soccerText.inspector.organisation, panel: createOrganisationTab({ scopes, setting, moment: seen }) },
      { name: 'log', label: soccerText.inspector.log, panel: createLogTab({ match, playback }) },
      { name: 'charts', label: soccerText.inspector.charts, panel: createChartsTab({ match, playback, theme, onTheme: themes.on }) },
    ],
  });
  createSoccerControls({
    pane: frame.controls,
    session,
    open: files.choose,
    edit(team, what) {
      scopes.choose(team);
      inspector.open('coach');
      inspector.spread(true);
      void coachText.show(team, what);
    },
  });
  const transport = createSoccerTransport({ pane: frame.transport, match, playback, session, say });
  const foot = createSoccerFoot({
    pane: frame.foot,
    match,
    playback,
    session,
    scene: (tick) => sceneAt(tick, tick === playback.tick ? shown() : match.film.frame(tick), soccerText.roles),
    theme,
    names,
    beside: () => (compare?.on() ? compare : null),
    still: drive.end,
    say,
  });

  pitch.canvas.tabIndex = 0;
  pitch.canvas.setAttribute('role', 'application');
  pitch.canvas.setAttribute('aria-describedby', 'soccer-summary');
  pitch.stage.classList.add('own');
  frame.stages.append(pitch.stage, situations.refusal);
  frame.pane.append(band, legend.element);
  const narrow = matchMedia('(max-width: 899px)');
  narrow.addEventListener('change', place);
  place();
  themes.on(pitch.invalidate);

  /** On phones the pitch comes first. */
  function place() {
    if (narrow.matches) frame.pane.append(situations.element);
    else frame.stages.before(situations.element);
  }

  /** A | B and the tournament are loaded when they are first asked for. @type {Promise<SoccerCompare> | null} */
  let loadingCompare = null;
  /** @type {SoccerCompare | null} */
  let compare = null;
  /** @type {Promise<Tournament> | null} */
  let loadingTournament = null;
  /** @type {Tournament | null} */
  let tournament = null;
  const comparing = button(soccerText.compare.label, toggleCompare, { action: 'compare', title: soccerText.compare.title });
  const playing = button(soccerText.tournament.open, () => void toggleTournament());
  for (const key of [comparing, playing]) key.setAttribute('aria-pressed', 'false');
  frame.head.append(playing, comparing);

  /** Opens A | B. @param {string | null} kind who coaches blue in B; null for the usual other one */
  async function showCompare(kind = null) {
    try {
      loadingCompare ??= import('./compare.js').then(({ createSoccerCompare }) => createSoccerCompare({ frame, session, playback, match, layers, spawn, theme, onTheme: themes.on, broke, announce }));
      compare = await loadingCompare;
    } catch (error) {
      loadingCompare = null; // a later wish tries again
      say(soccerText.compare.missing(messageOf(error)), 'problem');
      session.compare(null);
      return;
    }
    if (tournament?.on()) tournament.close();
    await drive.end();
    hold.choose(null);
    compare.open(kind);
    show();
  }

  function closeCompare() {
    session.compare(null);
    if (compare?.on()) compare.close();
    show();
  }

  function toggleCompare() {
    if (compare?.on()) closeCompare();
    else void showCompare();
  }

  /** A | B as the session asks for it: after a link, and after an engine that had ended. */
  async function besideAsAsked() {
    if (session.beside !== null) await showCompare(session.beside);
    else if (compare?.on()) closeCompare();
  }

  async function toggleTournament() {
    try {
      loadingTournament ??= import('./tournament.js').then(({ createTournament }) => createTournament({ frame, session, watch, announce }));
      tournament = await loadingTournament;
    } catch (error) {
      loadingTournament = null;
      say(soccerText.compare.missing(messageOf(error)), 'problem');
      return;
    }
    if (compare?.on()) closeCompare();
    if (tournament.on()) tournament.close();
    else {
      await drive.end();
      playback.pause();
      hold.choose(null);
      tournament.open();
    }
    show();
  }

  /** Shows a game of the tournament. @param {Record<string, string | number | boolean>} scenario */
  async function watch(scenario) {
    tournament?.close();
    show();
    await session.play(scenario);
  }

  /** Stages a situation at the moment on screen. @param {object} value @param {string} label */
  async function stage(value, label) {
    playback.pause();
    const refusal = await session.act('soccer.restart', value);
    if (!refusal) {
      say(soccerText.situation.staged(label));
      await playback.reach(playback.tick + 1); // where it stands
    }
    return refusal;
  }

  /** Plays the match as it was before anything was done to it. */
  function takeBack() {
    const { tick } = playback;
    void match.open({ ...session.scenario(), events: [] }).then(() => {
      session.tell();
      void playback.reach(tick);
      void session.writeAddress();
    });
  }

  /** What the teams are called. */
  function names() {
    const now = session.scenario();
    return /** @type {const} */ (['blue', 'yellow']).map((team) => {
      const kind = soccerText.kinds[now[team]] ?? String(now[team]);
      return now[`${team}-coach`] || now[`${team}-roles`] ? soccerText.own(kind) : kind;
    });
  }

  /** State and words follow from what goes on. */
  function settle() {
    if (state.name === 'error' || match.film.count === 0) return;
    const name = drive.driving() || playback.playing ? 'running' : ended() ? 'finished' : 'paused';
    if (state.name === name) return;
    if (name === 'running' && state.name === 'finished') state.to('paused');
    state.to(name, name === 'finished' ? match.finished : '');
  }

  function show() {
    settle();
    const on = compare?.on() ? 'comparing' : tournament?.on() ? 'tournament' : '';
    frame.pane.dataset.shows = on;
    comparing.setAttribute('aria-pressed', String(on === 'comparing'));
    playing.setAttribute('aria-pressed', String(on === 'tournament'));
    situations.enable(may());
    transport.enable(!drive.driving() && on !== 'tournament');
    showMoment();
  }

  /** Everything that changes with the tick. */
  function showMoment() {
    if (match.film.count === 0) return;
    const { tick } = playback;
    const { phase, seconds } = match.film.clock(tick);
    const goals = match.film.goals(tick);
    const penalties = ended() ? match.outcome?.shoot_out : undefined;
    const time = penalties ? soccerText.board.shootOut(penalties) : soccerText.board.time(phase, seconds);
    const tag = drive.driving() ? soccerText.drive.live : state.name === 'running' ? '' : text.tag(state.name, state.reason);
    frame.show({ names: names(), goals, time, tag });
    showCall(tick);
    const roles = [0, 3].map((first, index) => soccerText.pitch.names(index === 0 ? soccerText.teams.blue : soccerText.teams.yellow, [0, 1, 2].map((robot) => soccerText.roles[setting.roles[match.film.role(tick, first + robot)]])));
    legend.show(soccerText.pitch.summary(time, goals, roles.join(' '), match.film.ball(tick)));
    foot.show();
    showPitch();
    look();
  }

  /** The call that led to what is on screen, for a moment. @param {number} tick */
  function showCall(tick) {
    const call = match.calls.findLast((entry) => entry.frame <= tick);
    const fresh = call && (tick - call.frame < CALL_TICKS || call.command === 'halt') ? call : null;
    band.classList.toggle('blank', fresh === null);
    if (fresh) band.replaceChildren(h('b', {}, callTitle(fresh)), ' ', soccerText.call.because(fresh.reason));
    else write(band, '');
  }

  function showPitch() {
    pitch.invalidate();
    situations.show();
  }

  let looking = false;
  let looked = -Infinity;
  let wanted = -1; // tick whose moment is wanted
  let later = 0;

  /** Fetches the moment on screen; while one is fetched, only the last wish counts. */
  function look() {
    wanted = playback.tick;
    if (looking || later) return;
    const wait = playback.playing || drive.driving() ? looked + LOOK_MS - performance.now() : 0;
    if (wait > 0) later = window.setTimeout(() => ((later = 0), void fetchMoment()), wait);
    else void fetchMoment();
  }

  async function fetchMoment() {
    looking = true;
    try {
      const asked = wanted;
      moment = await match.look(asked);
      looked = performance.now();
      looking = false;
      inspector.show();
      if (wanted !== asked) look();
    } catch {
      looking = false; // the engine has ended; the tab says so
    }
  }

  session.onLink(() => void besideAsAsked());
  session.on(() => {
    coachText.refresh();
    show();
  });
  match.on('opened', () => {
    hold.choose(null);
    show();
  });
  match.on('grown', () => (drive.driving() ? show() : foot.show()));
  match.on('cut', show);
  match.on('over', () => {
    if (match.outcome && !tournament?.on()) announce(soccerText.said.over(match.finished, match.outcome.goals));
    show();
    inspector.show();
  });
  let writing = 0;
  let played = false;
  playback.on(() => {
    if (playback.playing && !played) {
      hold.choose(null);
      announce(soccerText.said.playing);
    }
    played = playback.playing;
    settle();
    situations.enable(may());
    showMoment();
    if (playback.playing) return;
    clearTimeout(writing); // the address is written once the moment rests
    writing = window.setTimeout(() => void session.writeAddress(), ADDRESS_MS);
  });
  state.on((name) => {
    if (name !== 'loading') showMoment();
  });
  inspector.open('coach');

  return {
    show,
    besideAsAsked,
    pause() {
      void drive.end();
      compare?.hold();
      tournament?.pause();
    },
    resume: () => compare?.resume(),
    /** The engine has ended. */
    abandon() {
      drive.abandon();
      if (compare?.on()) compare.close();
    },
    actions: {
      toggle: () => !drive.driving() && playback.toggle(),
      forward: () => transport.step(1),
      back: () => transport.step(-1),
      'far-forward': () => transport.far(1),
      'far-back': () => transport.far(-1),
      restart: () => playback.seek(0),
      'new-seed': transport.newMatch,
      faster: transport.faster,
      slower: transport.slower,
      compare: toggleCompare,
      clear: () => (inspector.spread(false), hold.choose(null)),
    },
  };
}

/** @typedef {ReturnType<typeof createSoccerBoard>} SoccerBoard */
