/**
 * What a population file says of itself, for people; null for a text that is none. The engine alone decides whether it is
 * taken.
 *
 * @param {string} written
 * @returns {{ count: number, title: string, seed: number | null, tick: number | null } | null}
 */
export function describe(written) {
  try {
    const { members, title, seed, tick } = JSON.parse(written);
    const whole = (/** @type {unknown} */ value) => (typeof value === 'number' && Number.isSafeInteger(value) ? value : null);
    return Array.isArray(members) ? { count: members.length, title: typeof title === 'string' ? title : '', seed: whole(seed), tick: whole(tick) } : null;
  } catch {
    return null;
  }
}

/** Whether a file is a population rather than a scenario, also when it is cut short. @param {string} written */
export const looksLikePopulation = (written) => /^\s*\{\s*"format"\s*:\s*"geese-population/.test(written) || /"members"\s*:/.test(written.slice(0, 2000));
