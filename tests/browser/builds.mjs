// Builds of the page on servers of their own: the present one, and one that could be the next.
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPage } from './browser.mjs';
import { serve } from './serve.mjs';

/** @typedef {import('./browser.mjs').Open} Open */
/** @typedef {import('./browser.mjs').Opened} Opened */

export const dist = fileURLToPath(new URL('../../dist', import.meta.url));
export const HASHED = /-[\w-]{8}\.\w+$/;

/** A copy of the build as the next one would be: each file under another name, and none of the old ones. @param {string} folder */
export function nextBuild(folder) {
  cpSync(dist, folder, { recursive: true });
  const assets = join(folder, 'assets');
  const renamed = readdirSync(assets).map((name) => /** @type {const} */ ([name, name.replace(HASHED, (end) => end.replace(/^-./, end[1] === 'x' ? '-y' : '-x'))]));
  for (const [name, next] of renamed) renameSync(join(assets, name), join(assets, next));
  for (const file of readdirSync(folder, { recursive: true, withFileTypes: true })) {
    if (!file.isFile() || !['.js', '.css', '.html'].includes(extname(file.name))) continue;
    const path = join(file.parentPath, file.name);
    let text = readFileSync(path, 'utf8');
    for (const [name, next] of renamed) text = text.replaceAll(name, next);
    if (file.name === 'sw.js') text = text.replace(/(url:.index\.html.,revision:.)\w{8}/, '$100000000');
    writeFileSync(path, text);
  }
}

/**
 * Runs a test on a server of its own whose folder can be changed.
 *
 * @param {Open} open only to know the browser
 * @param {(parts: { visit: (hash?: string) => Promise<Opened>, stop: () => void, replace: (folder: string) => void, temporary: string, url: string }) => Promise<void | string>} test
 */
export async function ownServer(open, test) {
  const browser = /** @type {import('playwright-core').Browser} */ ((await open('#/trees')).page.context().browser());
  const temporary = mkdtempSync(join(tmpdir(), 'swarm-offline-'));
  const served = join(temporary, 'served');
  cpSync(dist, served, { recursive: true });
  const server = await serve(served, '/class/');
  /** @type {Opened[]} */
  const opened = [];
  const visit = async (hash = '') => {
    const page = await openPage(browser, server.url, hash, { serviceWorkers: 'allow' });
    opened.push(page);
    return page;
  };
  const replace = (/** @type {string} */ folder) => {
    rmSync(served, { recursive: true });
    cpSync(folder, served, { recursive: true });
  };
  try {
    return await test({ visit, stop: server.close, replace, temporary, url: server.url });
  } finally {
    for (const { close } of opened) await close();
    server.close();
    rmSync(temporary, { recursive: true });
  }
}

/** Waits until every file of the build is kept and the page is served from there. @param {Opened} opened */
export const kept = ({ until }) => until(() => navigator.serviceWorker.controller?.state === 'activated');

/** The script that the page began with. @param {Opened} opened */
export const script = ({ page }) => page.locator('script[type=module]').first().getAttribute('src');
