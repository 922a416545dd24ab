// @ts-expect-error the types of Node are not installed: nothing of the page may use it
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';

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

export default defineConfig({
  base: './',
  plugins: [contentPolicy, landing],
  worker: { format: 'es' },
  build: { target: 'es2022', modulePreload: { polyfill: false }, assetsInlineLimit: 0, chunkSizeWarningLimit: 700 }, // kB before compression; the editor of the tab Trees is the largest
});
