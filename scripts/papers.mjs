// Writes docs/papers.md, the map from the papers to the code, from the `Source:` lines of the doc comments in src/. With
// --check it writes nothing, and says with status 1 when the map is not that of the sources. `make docs` calls it.

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const MAP = 'docs/papers.md';
const FOLDERS = [
  ['geese', 'BeTr-GEESE: the swarm that evolves its behaviour trees'],
  ['evolution', 'Grammatical evolution'],
  ['sequencing', 'Behaviour sequencing: the cheapest order of swarm behaviours'],
  ['soccer', 'Robot soccer'],
  ['bt', 'Behaviour trees'],
  ['study', 'Statistics of the studies'],
];
const ITEM = /^\s*(?:pub(?:\([a-z]+\))? )?(?:const |async )*(?:fn|struct|enum|const|static|trait|type|mod) (\w+)|^\s*(\w+)(?:[:,({]| =)/;
const EQUATIONS = /\beqs?\. ?\((\d+)\)(?:(?:,| and| to) \((\d+)\))?/g;

/**
 * @typedef {object} Entry one `Source:` line
 * @property {string} file below src/
 * @property {string} item the name of what is documented; empty for a whole file
 * @property {string} what the first sentence of the documentation; empty when that is the source
 * @property {string} source
 */

/** Every Rust file of a folder, in order. @param {string} folder @returns {string[]} */
function files(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => (entry.isDirectory() ? files(join(folder, entry.name)) : entry.name.endsWith('.rs') ? [join(folder, entry.name)] : []));
}

/** The doc comments of a file, each with what it documents. @param {string} file */
function documented(file) {
  const lines = readFileSync(file, 'utf8').split('\n');
  /** @type {{ item: string, text: string[] }[]} */
  const found = [];
  for (let at = 0; at < lines.length; at += 1) {
    const mark = /^\s*(\/\/[/!])/.exec(lines[at])?.[1];
    if (!mark) continue;
    const text = [];
    for (; lines[at]?.trimStart().startsWith(mark); at += 1) text.push(lines[at].trimStart().slice(3).replace(/^ /, ''));
    let next = at;
    while (/^\s*#!?\[/.test(lines[next] ?? '')) next += 1; // attributes, of one line each or more
    const item = mark === '//!' ? '' : (ITEM.exec(lines.slice(next, next + 12).find((line) => ITEM.test(line)) ?? '') ?? []).slice(1).find(Boolean);
    found.push({ item: item ?? '', text });
  }
  return found;
}

/** The paragraph that begins at a line. @param {string[]} text @param {number} at */
function paragraph(text, at) {
  const end = text.findIndex((line, index) => index >= at && line.trim() === '');
  return text.slice(at, end < 0 ? undefined : end).join(' ').replace(/\s+/g, ' ').trim();
}

/** The first sentence. @param {string} text */
const sentence = (text) => /^.*?[.:](?= [A-Z`]|$)/.exec(text)?.[0] ?? text;

/** @param {string} folder @returns {Entry[]} */
function entries(folder) {
  return files(join('src', folder)).flatMap((file) =>
    documented(file).flatMap(({ item, text }) =>
      text.flatMap((line, at) => {
        if (!line.startsWith('Source: ')) return [];
        const source = paragraph(text, at).slice('Source: '.length);
        return [{ file: file.slice('src/'.length), item, what: at === 0 ? '' : sentence(paragraph(text, 0)), source }];
      }),
    ),
  );
}

/** Where comments name an equation, by its number. @param {string} folder */
function equations(folder) {
  /** @type {Map<number, Set<string>>} */
  const named = new Map();
  for (const file of files(join('src', folder))) {
    for (const line of readFileSync(file, 'utf8').split('\n').filter((text) => text.includes('//'))) {
      for (const [all, first, last] of line.matchAll(EQUATIONS)) {
        const numbers = last && all.includes(' to ') ? range(Number(first), Number(last)) : [first, last].filter(Boolean).map(Number);
        for (const number of numbers) named.set(number, (named.get(number) ?? new Set()).add(file.slice('src/'.length)));
      }
    }
  }
  return [...named].sort(([a], [b]) => a - b);
}

/** @param {number} first @param {number} last */
const range = (first, last) => Array.from({ length: last - first + 1 }, (_, index) => first + index);

/** A text as a cell of a table. @param {string} text */
const cell = (text) => text.replaceAll('|', '\\|').replace(/\[(`[^`]+`)\](?:\([^)]*\))?/g, '$1');

function map() {
  const parts = [
    '# Where what the papers say stands in the code',
    'Made by `make docs` from the `Source:` lines of the code, which say what each part was taken from, where it differs, and what is our choice; `make test` checks that it is up to date. The sources of single parameters stand with the parameters: `swarm-playground schema` prints them, and the page shows them beside each control. Which claims of the papers are borne out: [reproduction.md](reproduction.md), [reproduction-sequencing.md](reproduction-sequencing.md).',
  ];
  for (const [folder, title] of FOLDERS) {
    const found = entries(folder);
    if (found.length === 0) continue;
    const rows = found.map(({ file, item, what, source }) => `| ${cell(source)} | \`${file}\`${item && `, \`${item}\``} | ${cell(what)} |`);
    parts.push(`## ${title}`, ['| source | where | what |', '|---|---|---|', ...rows].join('\n'));
    const numbered = equations(folder);
    if (numbered.length === 0) continue;
    const places = numbered.map(([number, where]) => `| (${number}) | ${[...where].map((file) => `\`${file}\``).join(', ')} |`);
    parts.push('Equations by their numbers, and the files whose comments name them:', ['| equation | files |', '|---|---|', ...places].join('\n'));
  }
  return `${parts.join('\n\n')}\n`;
}

const wanted = map();
if (!process.argv.includes('--check')) {
  writeFileSync(MAP, wanted);
  console.log(`Wrote ${MAP}.`);
} else if (readFileSync(MAP, 'utf8') !== wanted) {
  console.error(`${MAP} is not the map of the sources any more: run make docs.`);
  process.exitCode = 1;
}
