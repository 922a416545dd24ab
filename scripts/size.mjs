// Weighs dist/ as a server would send it, gzip -9, against the budget; status 1 when anything is over it.
// All of dist/ counts as the first load, except source maps, which only an open debugger fetches.

import { readFileSync, readdirSync } from 'node:fs';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';

// In kilobytes of 1000 bytes.
const BUDGET = { wasm: 150, js: 45, css: 8, all: 250 };

const files = readdirSync('dist', { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && !entry.name.endsWith('.map'))
  .map((entry) => join(entry.parentPath, entry.name))
  .map((path) => ({ kind: extname(path).slice(1), bytes: gzipSync(readFileSync(path), { level: 9 }).length }));

let over = false;
for (const [kind, limit] of Object.entries(BUDGET)) {
  const counted = files.filter((file) => kind === 'all' || file.kind === kind);
  const size = counted.reduce((sum, file) => sum + file.bytes, 0) / 1000;
  const verdict = counted.length === 0 ? 'MISSING' : size > limit ? 'TOO LARGE' : 'ok';
  over ||= verdict !== 'ok';
  console.log(`${kind.padEnd(4)} ${size.toFixed(1).padStart(6)} of ${limit} KB gzipped, ${counted.length} files: ${verdict}`);
}
process.exitCode = over ? 1 : 0;
