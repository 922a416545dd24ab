// The service worker: keeps every file of one build and answers with it, whether the network is there or not. A newer one
// waits until the visitor asks for it (keep.js), so old and new files never meet. It answers for the page and its files
// only: older versions live below it, at /vX.Y.Z/, with service workers of their own.

import { cleanupOutdatedCaches, precacheAndRoute } from 'workbox-precaching';

/** The files of this build, put in by vite.config.js. @typedef {{ url: string, revision: string | null }[]} Kept */

const worker = /** @type {{ skipWaiting(): Promise<void>, clients: { claim(): Promise<void> } } & EventTarget} */ (/** @type {unknown} */ (self));

cleanupOutdatedCaches();
precacheAndRoute(/** @type {{ KEPT: Kept }} */ (/** @type {unknown} */ (self)).KEPT);
worker.addEventListener('message', (event) => {
  if (/** @type {MessageEvent} */ (event).data?.type === 'SKIP_WAITING') void worker.skipWaiting();
});
// So that what the first visit opens late comes from the same build too.
worker.addEventListener('activate', (event) => /** @type {any} */ (event).waitUntil(worker.clients.claim()));
