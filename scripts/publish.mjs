// Lays the built page into a folder that is served: at its root, and below it at vX.Y.Z/, where it stays for ever, so that
// links which name a version can be opened with it. Older versions are left as they are.
//
//     node scripts/publish.mjs SITE
//
// A version that is there already with other content is refused: its links would no longer show what they showed.

import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const KEPT = /^(v\d+\.\d+\.\d+|CNAME|\.git|\.nojekyll)$/;

/** @param {string} message @returns {never} */
function refuse(message) {
  console.error(message);
  process.exit(1);
}

/** Every file below a folder. @param {string} folder */
const files = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1))
    .sort();

/** The first file in which two folders differ, or null. @param {string} one @param {string} other */
function difference(one, other) {
  const [ours, theirs] = [files(one), files(other)];
  const differing = ours.find((file) => !theirs.includes(file) || !readFileSync(join(one, file)).equals(readFileSync(join(other, file))));
  return differing ?? theirs.find((file) => !ours.includes(file)) ?? null;
}

const site = process.argv[2];
if (!site) refuse('Usage: node scripts/publish.mjs SITE');
if (!existsSync('dist/index.html')) refuse('The page is not built: run make build first.');
const version = /^version = "(\d+\.\d+\.\d+)"$/m.exec(readFileSync('Cargo.toml', 'utf8'))?.[1];
if (!version) refuse('Cargo.toml has no version of the form X.Y.Z.');

mkdirSync(site, { recursive: true });
const own = join(site, `v${version}`);
if (existsSync(own)) {
  const file = difference('dist', own);
  if (file) refuse(`${own} is there already with another ${file}: a version is published once. Raise the version in Cargo.toml.`);
}
for (const name of readdirSync(site)) if (!KEPT.test(name)) rmSync(join(site, name), { recursive: true });
cpSync('dist', site, { recursive: true });
cpSync('dist', own, { recursive: true });
writeFileSync(join(site, '.nojekyll'), ''); // GitHub leaves out files that begin with an underscore otherwise
const versions = readdirSync(site).filter((name) => /^v\d/.test(name)).sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
console.log(`${site}: ${version} at the root; kept: ${versions.join(', ')}`);
