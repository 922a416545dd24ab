// WebKitGTK's small browser, driven through its own WebDriver server.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { onPath } from './system.mjs';

const START_MS = 60_000;
const LIBRARIES = ['/usr/lib', '/usr/libexec', '/usr/lib64'];

/** @returns {Promise<import('./others.mjs').Driver | string>} the browser, or why there is none */
export async function startWebKit() {
  const program = onPath(['WebKitWebDriver']);
  const browser = miniBrowser();
  if (!program || !browser) return 'no WebKit was found; install WebKitGTK with its driver (in Debian webkit2gtk-driver)';
  const screen = onPath(['xvfb-run']);
  if (!process.env.DISPLAY && !screen) return 'WebKit needs a display; install Xvfb (in Debian xvfb)';
  const port = await freePort();
  const words = [program, `--port=${port}`];
  const [first, ...rest] = process.env.DISPLAY ? words : [/** @type {string} */ (screen), '--auto-servernum', ...words];
  const folder = mkdtempSync(join(tmpdir(), 'swarm-webkit-'));
  // A group of its own, so that the display ends with it; what the display leaves is in our folder.
  const driver = spawn(first, rest, { stdio: 'ignore', detached: true, env: { ...process.env, TMPDIR: folder } });
  const end = () => {
    if (driver.pid && driver.exitCode === null) process.kill(-driver.pid, 'SIGKILL');
    rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  };

  /** @param {string} method @param {string} path @param {object} [body] @returns {Promise<any>} */
  async function command(method, path, body) {
    const response = await fetch(`http://127.0.0.1:${port}${path}`, { method, body: body && JSON.stringify(body) });
    const { value } = await response.json();
    if (!response.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  }

  try {
    await listening(port, driver);
    const options = { binary: browser, args: ['--automation'] };
    const { sessionId, capabilities } = await command('POST', '/session', { capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': options } } });
    const session = `/session/${sessionId}`;
    return {
      name: `WebKit, ${capabilities.browserName} ${capabilities.browserVersion}`,
      open: (url) => command('POST', `${session}/url`, { url }),
      ask: (expression) => command('POST', `${session}/execute/sync`, { script: `return ${expression};`, args: [] }),
      async close() {
        await command('DELETE', session).catch(() => {});
        end();
      },
    };
  } catch (error) {
    end();
    throw error;
  }
}

/** The browser that the driver steers, which is on no PATH. */
function miniBrowser() {
  for (const library of LIBRARIES.filter(existsSync)) {
    for (const folder of ['', ...readdirSync(library)]) {
      for (const webkit of ['webkitgtk-6.0', 'webkit2gtk-4.1', 'webkit2gtk-4.0']) {
        const path = join(library, folder, webkit, 'MiniBrowser');
        if (existsSync(path)) return path;
      }
    }
  }
  return null;
}

/** @returns {Promise<number>} */
async function freePort() {
  const probe = createServer().listen(0, '127.0.0.1');
  await once(probe, 'listening');
  const { port } = /** @type {import('node:net').AddressInfo} */ (probe.address());
  probe.close();
  return port;
}

/** @param {number} port @param {import('node:child_process').ChildProcess} driver */
async function listening(port, driver) {
  const end = Date.now() + START_MS;
  while (Date.now() < end && driver.exitCode === null) {
    const answered = await fetch(`http://127.0.0.1:${port}/status`).then(() => true, () => false);
    if (answered) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`its driver ended, or did not listen within ${START_MS / 1000} s`);
}
