// The site that scripts/publish.mjs lays out: the newest version at the root, every version below it for ever.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { dist, kept, nextBuild, ownServer, script } from './builds.mjs';

const program = fileURLToPath(new URL('../../scripts/publish.mjs', import.meta.url));

/** Publishes what stands in `folder` as a version. @param {string} folder @param {string} version */
function publish(folder, version) {
  writeFileSync(join(folder, 'Cargo.toml'), `[package]\nversion = "${version}"\n`);
  return spawnSync('node', [program, 'site'], { cwd: folder, encoding: 'utf8' });
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'older_versions_stay_and_open_beside_the_newest',
    (open) =>
      ownServer(open, async ({ visit, replace, temporary, url }) => {
        const folder = join(temporary, 'project');
        mkdirSync(folder);
        cpSync(dist, join(folder, 'dist'), { recursive: true });
        assert.equal(publish(folder, '0.1.0').status, 0);
        assert.equal(publish(folder, '0.1.0').status, 0, 'the same again changes nothing');
        rmSync(join(folder, 'dist'), { recursive: true });
        nextBuild(join(folder, 'dist'));
        const refused = publish(folder, '0.1.0');
        assert.equal(refused.status, 1);
        assert.match(refused.stderr, /v0\.1\.0 is there already with another .*: a version is published once/);
        const done = publish(folder, '0.2.0');
        assert.match(done.stdout, /0\.2\.0 at the root; kept: v0\.1\.0, v0\.2\.0/);
        const site = join(folder, 'site');
        assert.deepEqual(readFileSync(join(site, 'v0.1.0/index.html')), readFileSync(join(dist, 'index.html')));
        assert.deepEqual(readdirSync(join(site, 'assets')), readdirSync(join(site, 'v0.2.0/assets')), 'nothing of the old version is left at the root');
        replace(site);
        const newest = await visit('#/forage?preset=foraging&seed=4');
        await kept(newest); // from now on it answers for the root, and must not for what lies below
        const fingerprint = await newest.seek(20);
        const { page } = newest;
        const before = await script(newest);
        await page.goto(`${url}v0.1.0/#/forage?preset=foraging&seed=4&t=20&f=${fingerprint}`);
        await newest.at(20);
        await newest.notice(/fingerprint matches/);
        assert.notEqual(await script(newest), before, 'the old version is answered by itself');
        await page.goto(url);
        await newest.inState('paused');
        assert.equal(await script(newest), before);
      }),
  ],
  [
    'publishing_names_what_is_missing',
    (open) =>
      ownServer(open, async ({ temporary }) => {
        const without = publish(temporary, '0.1.0');
        assert.deepEqual([without.status, without.stderr], [1, 'The page is not built: run make build first.\n']);
        cpSync(dist, join(temporary, 'dist'), { recursive: true });
        const odd = publish(temporary, 'next');
        assert.deepEqual([odd.status, odd.stderr], [1, 'Cargo.toml has no version of the form X.Y.Z.\n']);
      }),
  ],
];
