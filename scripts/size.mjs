// Weighs dist/ as a server would send it, gzip -9, against the budget; status 1 when anything is over it.
//
// What counts is the first load: index.html, what it names, and what those scripts import or make a URL of; `first` is
// all of it together. Parts that a script imports later, when they are asked for, count nowhere, and neither do source
// maps: only an open debugger fetches them.

import { readFileSync, readdirSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';

// In kilobytes of 1000 bytes.
const BUDGET = { wasm: 150, js: 45, css: 8, first: 250 };

const files = new Map(
  readdirSync('dist', { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith('.map'))
    .map((entry) => [entry.name, readFileSync(join(entry.parentPath, entry.name))]),
);

/** Names in a page or script of files that load with it: not those in import(...). */
function named(name, text) {
  const pattern =
    extname(name) === '.html' ? /(?:src|href)="([^"]+)"/g : /(?:new URL\(|\bfrom|\bimport) ?[`"']([^`"']+)[`"']/g;
  return [...text.matchAll(pattern)].map((match) => basename(match[1]));
}

const first = new Set(['index.html']);
for (const name of first) {
  if (!['.html', '.js'].includes(extname(name))) continue;
  for (const next of named(name, files.get(name).toString('utf8'))) if (files.has(next)) first.add(next);
}

let over = false;
for (const [kind, limit] of Object.entries(BUDGET)) {
  const counted = [...files.keys()].filter((name) => first.has(name) && (kind === 'first' || extname(name) === `.${kind}`));
  const size = counted.reduce((sum, name) => sum + gzipSync(files.get(name), { level: 9 }).length, 0) / 1000;
  const verdict = counted.length === 0 ? 'MISSING' : size > limit ? 'TOO LARGE' : 'ok';
  over ||= verdict !== 'ok';
  console.log(`${kind.padEnd(5)} ${size.toFixed(1).padStart(6)} of ${limit} KB gzipped, ${counted.length} files: ${verdict}`);
}
process.exitCode = over ? 1 : 0;
