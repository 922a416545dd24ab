// `make package`: builds the npm package into target/npm/package and packs it beside: all faces of the engine in one wasm
// file with its types, an entry for Node beside the one for bundlers, the presets, README and licences.

import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';

const FACES = 'worlds,trees,studies,sequence,soccer-page';
const HOME = 'target/npm';
const FOLDER = `${HOME}/package`;
const LICENCES = ['LICENSE-MIT', 'LICENSE-APACHE'];

/** A field of Cargo.toml's first section. @param {string} name */
function field(name) {
  const found = new RegExp(`^${name} = "(.*)"$`, 'm').exec(readFileSync('Cargo.toml', 'utf8'));
  if (!found) throw new Error(`Cargo.toml has no ${name}`);
  return found[1];
}

const manifest = {
  name: field('name'),
  version: field('version'),
  description: field('description'),
  license: field('license'),
  type: 'module',
  main: './node.js',
  types: './swarm_playground.d.ts',
  exports: {
    '.': { types: './swarm_playground.d.ts', node: './node.js', default: './swarm_playground.js' },
    './swarm_playground_bg.wasm': './swarm_playground_bg.wasm',
    './scenarios/*': './scenarios/*',
    './package.json': './package.json',
  },
  files: ['node.js', 'swarm_playground.js', 'swarm_playground.d.ts', 'swarm_playground_bg.wasm', 'swarm_playground_bg.wasm.d.ts', 'scenarios', ...LICENCES],
  engines: { node: '>=18' },
  keywords: ['behavior-trees', 'grammatical-evolution', 'swarm', 'simulation', 'wasm'],
};

rmSync(HOME, { recursive: true, force: true });
mkdirSync(FOLDER, { recursive: true });
const wasmPack = ['--log-level', 'warn', 'build', '--mode', 'no-install', '--target', 'web', '--release'];
const options = ['--out-dir', FOLDER, '--out-name', 'swarm_playground', '--no-pack', '--', '--no-default-features', '--features', FACES];
execFileSync('wasm-pack', [...wasmPack, ...options], { stdio: 'inherit' });
for (const name of LICENCES) cpSync(name, `${FOLDER}/${name}`);
for (const name of ['README.md', 'node.js']) cpSync(`package/${name}`, `${FOLDER}/${name}`);
cpSync('scenarios', `${FOLDER}/scenarios`, { recursive: true });
// The types name Symbol.dispose, which not every program's own libraries have.
const types = `${FOLDER}/swarm_playground.d.ts`;
writeFileSync(types, `/// <reference lib="esnext.disposable" />\n${readFileSync(types, 'utf8')}`);
writeFileSync(`${FOLDER}/package.json`, `${JSON.stringify(manifest, null, 2)}\n`);
const [packed] = JSON.parse(execFileSync('npm', ['pack', `./${FOLDER}`, '--pack-destination', HOME, '--json'], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
console.log(`Packed ${HOME}/${packed.filename}: ${packed.files.length} files, ${(packed.size / 1000).toFixed(0)} KB.`);
