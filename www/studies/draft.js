/** @typedef {(string | number)[]} Path the fields that lead to a value */

/**
 * The value at a path; undefined where there is none.
 *
 * @param {any} value
 * @param {Path} path
 * @returns {any}
 */
export function at(value, path) {
  return path.reduce((inside, key) => (inside !== null && typeof inside === 'object' ? inside[key] : undefined), value);
}

/**
 * A copy with another value at a path; `undefined` removes the field or element. Objects are made on the way.
 *
 * @param {any} value
 * @param {Path} path
 * @param {any} next
 * @returns {any}
 */
export function changed(value, path, next) {
  if (path.length === 0) return next;
  const [key, ...rest] = path;
  const inside = value?.[key];
  const replaced = changed(inside, rest, next);
  if (Array.isArray(value)) return replaced === undefined ? value.filter((_, index) => index !== key) : Object.assign([...value], { [key]: replaced });
  if (replaced !== undefined) return { ...value, [key]: replaced };
  const { [key]: _, ...others } = value ?? {};
  return others;
}

/**
 * A copy in which a field has another name and the same place among its neighbours.
 *
 * @param {any} value
 * @param {Path} path of the object
 * @param {string} from
 * @param {string} to
 * @param {any} next its value
 */
export function renamed(value, path, from, to, next) {
  const fields = Object.entries(at(value, path) ?? {}).map(([key, field]) => (key === from ? [to, next] : [key, field]));
  return changed(value, path, Object.fromEntries(fields));
}

/** As the study files are written. @param {any} value */
export const written = (value) => `${JSON.stringify(value, null, 2)}\n`;

/** A path as the engine names it, such as `cells[2].set.geese.agents`. @param {Path} path */
export function pathName(path) {
  return path.reduce((/** @type {string} */ name, key) => (typeof key === 'number' ? `${name}[${key}]` : name === '' ? key : `${name}.${key}`), '');
}

/**
 * Where in a JSON text a field stands whose path the engine named, or the nearest one above it that is there.
 *
 * @param {string} json
 * @param {string} path
 * @returns {[start: number, end: number] | null} null when the text is no JSON, or the path leads nowhere
 */
export function placeOf(json, path) {
  try {
    JSON.parse(json);
  } catch {
    return null;
  }
  /** @type {{ name: string, start: number, end: number }[]} */
  const fields = [];
  let spot = 0;
  const white = () => {
    while (/\s/.test(json[spot] ?? '')) spot += 1;
  };
  const string = () => {
    const start = spot;
    for (spot += 1; json[spot] !== '"'; spot += 1) if (json[spot] === '\\') spot += 1;
    spot += 1;
    return JSON.parse(json.slice(start, spot));
  };
  /** @param {string} name */
  const value = (name) => {
    white();
    const open = json[spot];
    if (open === '"') string();
    else if (open === '{' || open === '[') {
      spot += 1;
      for (let index = 0; ; index += 1) {
        white();
        if (json[spot] === ',') {
          spot += 1;
          white();
        }
        if (json[spot] === '}' || json[spot] === ']') break;
        const start = spot;
        let inside = `${name}[${index}]`;
        if (open === '{') {
          const key = string();
          inside = name === '' ? key : `${name}.${key}`;
          white();
          spot += 1; // the colon
        }
        value(inside);
        fields.push({ name: inside, start, end: spot });
      }
      spot += 1;
    } else while (/[^\s,\]}]/.test(json[spot] ?? '')) spot += 1;
  };
  value('');
  const found = fields.filter(({ name }) => path === name || path.startsWith(`${name}.`) || path.startsWith(`${name}[`)).sort((a, b) => b.name.length - a.name.length)[0];
  return found ? [found.start, found.end] : null;
}
