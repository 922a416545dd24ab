/** @import { EntryWrite, HaltEvent, LeafAnswer, ScriptEvent, Status } from './types.js' */

/** @typedef {{ running: number, then: Status, writes: Record<string, string> }} Answer what a leaf does */

/** @type {Answer} what a leaf does that the script does not mention */
export const UNSCRIPTED = { running: 0, then: 'SUCCESS', writes: {} };

/** @param {ScriptEvent} event @returns {event is LeafAnswer} */
export const isAnswer = (event) => 'leaf' in event;
/** @param {ScriptEvent} event @returns {event is EntryWrite} */
export const isWrite = (event) => 'set' in event;
/** @param {ScriptEvent} event @returns {event is HaltEvent} */
export const isHalt = (event) => 'halt' in event;

/**
 * The script with another answer of a leaf from a tick on: it takes the place of one given at the same tick, and is
 * left out when it says what is in force anyway.
 *
 * @param {ScriptEvent[]} script
 * @param {string} leaf
 * @param {number} tick
 * @param {Answer} answer
 */
export function withAnswer(script, leaf, tick, answer) {
  const others = script.filter((event) => !(isAnswer(event) && event.leaf === leaf && event.tick === tick));
  if (same(answer, inForce(others, leaf, tick))) return others;
  const { running, then, writes } = answer;
  return placed(others, { tick, leaf, running, then, ...(Object.keys(writes).length > 0 ? { writes } : {}) });
}

/**
 * The script with an entry written by hand; it takes the place of one written at the same tick.
 *
 * @param {ScriptEvent[]} script
 * @param {number} tick
 * @param {string} name
 * @param {string} value
 */
export function withWrite(script, tick, name, value) {
  const others = script.filter((event) => !(isWrite(event) && event.set === name && event.tick === tick));
  return placed(others, { tick, set: name, value });
}

/** The script with the whole tree halted at a tick, once. @param {ScriptEvent[]} script @param {number} tick */
export function withHalt(script, tick) {
  return script.some((event) => isHalt(event) && event.tick === tick) ? script : placed(script, { tick, halt: true });
}

/** @param {ScriptEvent[]} script @param {number} index */
export const without = (script, index) => script.filter((_, other) => other !== index);

/** What a leaf does after `tick` ticks. @param {ScriptEvent[]} script @param {string} leaf @param {number} tick @returns {Answer} */
export function inForce(script, leaf, tick) {
  /** @type {LeafAnswer | null} */
  let found = null;
  for (const event of script) if (isAnswer(event) && event.leaf === leaf && event.tick <= tick && event.tick >= (found?.tick ?? 0)) found = event;
  return found ? { running: found.running, then: found.then, writes: found.writes ?? {} } : UNSCRIPTED;
}

/** @param {Answer} one @param {Answer} other */
function same(one, other) {
  const ports = Object.keys(one.writes);
  return (
    one.then === other.then &&
    (one.then === 'RUNNING' || one.running === other.running) &&
    ports.length === Object.keys(other.writes).length &&
    ports.every((port) => one.writes[port] === other.writes[port])
  );
}

/** Events by tick; a new one comes last of its tick. @param {ScriptEvent[]} script @param {ScriptEvent} event */
function placed(script, event) {
  return [...script, event].sort((a, b) => a.tick - b.tick);
}

/** The script as text, the same for scripts that say the same. @param {ScriptEvent[]} script */
export const written = (script) => JSON.stringify(script.map(plain).sort((a, b) => a.tick - b.tick));

/** @param {ScriptEvent} event @returns {ScriptEvent} fields in one order, defaults filled in */
function plain(event) {
  const { tick } = event;
  if (isWrite(event)) return { tick, set: event.set, value: event.value };
  if (isHalt(event)) return { tick, halt: true };
  const { leaf, running = 0, then = 'SUCCESS', writes = {} } = event;
  return { tick, leaf, running, then, ...(Object.keys(writes).length > 0 ? { writes } : {}) };
}
