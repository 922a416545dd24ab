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

export default defineConfig({
  base: './',
  plugins: [contentPolicy],
  worker: { format: 'es' },
  build: { target: 'es2022', modulePreload: { polyfill: false }, assetsInlineLimit: 0, chunkSizeWarningLimit: 700 }, // kB before compression; the editor of the tab Trees is the largest
});
