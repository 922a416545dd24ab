/**
 * What a worker that owns an engine does with requests: it answers them one at a time, in order, and never runs by itself.
 *
 * @typedef {{ id: number, type: string } & Record<string, any>} Request
 * @typedef {Record<string, (request: Request) => [message: object, transfer?: Transferable[]]>} Answers
 */

const port = /** @type {{ postMessage(message: object, transfer?: Transferable[]): void, onmessage: ((event: MessageEvent) => void) | null }} */ (
  /** @type {unknown} */ (self)
);

/**
 * Answers from now on. Called before wasm is initialised, or the first request would be lost.
 *
 * @param {{ start: () => Promise<unknown>, answers: Answers, refuses: Set<string> }} parts
 *   `start` loads the engine at the first request; `refuses` are the requests that may fail because of what was asked: any
 *   other failure means that the engine is broken
 */
export function answerRequests({ start, answers, refuses }) {
  /** @type {Promise<unknown> | undefined} */
  let ready;
  let queue = Promise.resolve();

  port.onmessage = ({ data }) => {
    queue = queue.then(() => answer(data));
  };

  /** @param {Request} request */
  async function answer(request) {
    try {
      ready ??= start();
      await ready;
      const [message, transfer = []] = answers[request.type](request);
      port.postMessage({ id: request.id, type: request.type, ...message }, transfer);
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      const refused = refuses.has(request.type) && !(error instanceof WebAssembly.RuntimeError) && !/panicked at/.test(message);
      port.postMessage({ id: request.id, type: 'error', message, fatal: !refused });
    }
  }
}
