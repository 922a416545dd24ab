// Firefox, driven through WebDriver BiDi, which it speaks by itself.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import WebSocket from 'ws';
import { onPath } from './system.mjs';

const START_MS = 60_000;

/** @returns {Promise<import('./others.mjs').Driver | string>} the browser, or why there is none */
export async function startFirefox() {
  const program = process.env.FIREFOX || onPath(['firefox-esr', 'firefox']);
  if (!program) return 'no Firefox was found; install Firefox, or set FIREFOX to the path of one';
  const profile = mkdtempSync(join(tmpdir(), 'swarm-firefox-'));
  const browser = spawn(program, ['--headless', '--no-remote', '--profile', profile, '--remote-debugging-port=0', 'about:blank'], { stdio: ['ignore', 'ignore', 'pipe'] });
  const socket = new WebSocket(`${await address(browser)}/session`);
  await once(socket, 'open');

  let last = 0;
  /** @type {Map<number, { resolve: (result: any) => void, reject: (error: Error) => void }>} */
  const waiting = new Map();
  socket.on('message', (data) => {
    const { id, type, result, message } = JSON.parse(String(data));
    const asked = waiting.get(id);
    waiting.delete(id);
    if (type === 'error') asked?.reject(new Error(message));
    else asked?.resolve(result);
  });
  /** @param {string} method @param {object} params @returns {Promise<any>} */
  const command = (method, params) =>
    new Promise((resolve, reject) => {
      waiting.set((last += 1), { resolve, reject });
      socket.send(JSON.stringify({ id: last, method, params }));
    });

  const { capabilities } = await command('session.new', { capabilities: {} });
  const { contexts } = await command('browsingContext.getTree', {});
  const { context } = contexts[0];
  return {
    name: `Firefox ${capabilities.browserVersion}`,
    open: (url) => command('browsingContext.navigate', { context, url, wait: 'complete' }),
    async ask(expression) {
      const { type, result, exceptionDetails } = await command('script.evaluate', { expression, target: { context }, awaitPromise: true });
      if (type !== 'success') throw new Error(exceptionDetails.text);
      return result.value;
    },
    async close() {
      await command('browser.close', {}).catch(() => {}); // it may be gone before it answers
      socket.close();
      if (browser.exitCode === null) await Promise.race([once(browser, 'exit'), new Promise((resolve) => setTimeout(resolve, 5000))]);
      browser.kill('SIGKILL');
      rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
  };
}

/** Where the browser listens, which it tells when it is ready. @param {import('node:child_process').ChildProcess} browser */
async function address(browser) {
  const limit = setTimeout(() => browser.kill('SIGKILL'), START_MS);
  const lines = createInterface({ input: /** @type {import('node:stream').Readable} */ (browser.stderr) });
  for await (const line of lines) {
    const found = /WebDriver BiDi listening on (ws:\S+)/.exec(line);
    if (!found) continue;
    clearTimeout(limit);
    browser.stderr?.resume(); // what it says from now on is let through, or it would wait for a reader
    return found[1];
  }
  throw new Error(`it ended, or did not listen within ${START_MS / 1000} s`);
}
