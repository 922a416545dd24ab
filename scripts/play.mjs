// `make play`: serves the page from its sources until it is stopped. With --check-port it only says whether the port
// can be had, with status 1 if not.

import { createServer } from 'node:net';
import { relative, sep } from 'node:path';

const HOST = '127.0.0.1';

// Folders at the root that are no part of the page: builds in them must not reload it, and they hold many files.
const UNWATCHED = ['.tools', 'src', 'target', 'tools'];

/** @param {string} message */
function fail(message) {
  console.error(message);
  process.exit(1);
}

/** What keeps the port from being opened, as an error code, or null. @param {number} port */
function obstacle(port) {
  return new Promise((resolve) => {
    const probe = createServer();
    probe.once('error', (error) => resolve(error.code));
    probe.listen({ host: HOST, port }, () => probe.close(() => resolve(null)));
  });
}

const text = process.env.PORT ?? '8080';
const port = Number(text);
if (!/^\d+$/.test(text) || port < 1 || port > 65535) {
  fail(`PORT is "${text}", but must be a whole number from 1 to 65535.`);
}
const code = await obstacle(port);
if (code === 'EADDRINUSE') {
  fail(`Port ${port} is in use by another program: choose another one, as in "make play PORT=${port < 65535 ? port + 1 : 8080}".`);
} else if (code) {
  fail(`Port ${port} cannot be opened (${code}): choose another one, as in "make play PORT=8080".`);
}

if (!process.argv.includes('--check-port')) {
  const vite = await import('vite');
  const server = await vite.createServer({
    logLevel: 'warn',
    clearScreen: false,
    server: {
      host: HOST,
      port,
      strictPort: true,
      watch: { ignored: (path) => UNWATCHED.includes(relative('.', path).split(sep)[0]) },
    },
    optimizeDeps: { entries: ['index.html'] }, // not the pages that `cargo doc` leaves in target/
  });
  await server.listen();
  for (const signal of ['SIGINT', 'SIGTERM']) {
    process.once(signal, () => server.close().finally(() => process.exit(0)));
  }
  console.log('The playground is ready. Ctrl-C stops it.');
  console.log(`http://${HOST}:${port}/`);
}
