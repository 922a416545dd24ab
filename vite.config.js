// @ts-expect-error the types of Node are not installed: nothing of the page may use it
import { readFileSync } from 'node:fs';
import { build, defineConfig } from 'vite';

const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** Forbids the built page every host but its own. The development server is left out: it injects styles and a socket. */
const contentPolicy = {
  name: 'content-policy',
  apply: /** @type {const} */ ('build'),
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: { 'http-equiv': 'Content-Security-Policy', content: POLICY },
      injectTo: /** @type {const} */ ('head-prepend'),
    },
  ],
};

/** Puts the first picture, which scripts/still.mjs drew, into the page: it is seen before any script has run. */
const landing = {
  name: 'landing',
  transformIndexHtml: (/** @type {string} */ html) => html.replace('<!-- landing -->', () => readFileSync('www/landing.html', 'utf8')),
};

/**
 * Writes sw.js, which keeps every file of the build for visits without the network (www/offline/worker.js). It is built last
 * and on its own, because it has to know the others and to be one file under a name that stays.
 */
const offline = {
  name: 'offline',
  apply: /** @type {const} */ ('build'),
  /** @param {{ dir?: string }} options @param {import('vite').Rolldown.OutputBundle} bundle */
  async writeBundle({ dir }, bundle) {
    // Vite's names change with the content; the page's own name does not.
    const kept = Object.values(bundle).map(async (file) => ({ url: file.fileName, revision: file.fileName === 'index.html' ? await hash(file) : null }));
    await build({
      configFile: false,
      logLevel: 'warn',
      define: { 'self.KEPT': JSON.stringify(await Promise.all(kept)) },
      build: { target: 'es2022', outDir: dir, emptyOutDir: false, copyPublicDir: false, rolldownOptions: { input: 'www/offline/worker.js', output: { format: 'iife', entryFileNames: 'sw.js' } } },
    });
  },
};

/** @param {import('vite').Rolldown.OutputAsset | import('vite').Rolldown.OutputChunk} file */
async function hash(file) {
  const content = file.type === 'asset' ? file.source : file.code;
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content);
  return [...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)).slice(0, 8)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

// On a busy machine each of the page's workers would be told off for the seconds it took to build.
const rolldownOptions = { checks: { bundlerTimings: false } };

export default defineConfig({
  base: './',
  plugins: [contentPolicy, landing, offline],
  worker: { format: 'es', rolldownOptions },
  build: {
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 700, // kB before compression; the editor of the tab Trees is the largest
    rolldownOptions,
  },
});
