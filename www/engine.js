/** A failure the engine reported; `fatal` means that it must not be used again. */
export class EngineError extends Error {
  /** @param {string} message @param {boolean} fatal */
  constructor(message, fatal) {
    super(message);
    this.fatal = fatal;
  }
}

/**
 * The page's side of the worker: every request gets one answer, some report progress before it.
 *
 * @param {(message: string) => void} onFatal called once when the engine has broken; the worker is ended already
 * @param {() => Worker} spawn starts a worker that answers the requests
 */
export function createEngine(onFatal, spawn) {
  /** @type {Map<number, { resolve: (answer: any) => void, reject: (error: Error) => void, progress?: (tick: number) => void }>} */
  const waiting = new Map();
  /** @type {Worker | null} */
  let worker = null;
  let nextId = 1;

  /** Ends the worker, and starts a new one: a broken instance is never used again. */
  function start() {
    end('the engine was started again');
    const fresh = spawn();
    worker = fresh;
    fresh.onmessage = (event) => fresh === worker && receive(event.data);
    fresh.onerror = (event) => {
      event.preventDefault();
      if (fresh === worker) broken(event.message || 'the engine could not be started in a module worker');
    };
  }

  /** @param {string} reason */
  function end(reason) {
    worker?.terminate();
    worker = null;
    for (const { reject } of waiting.values()) reject(new EngineError(reason, true));
    waiting.clear();
  }

  /** @param {string} message */
  function broken(message) {
    if (!worker) return;
    end(message);
    onFatal(message);
  }

  /** @param {{ id: number, type: string, message?: string, fatal?: boolean, tick?: number }} answer */
  function receive(answer) {
    if (answer.type === 'error' && answer.fatal) {
      broken(answer.message ?? '');
      return;
    }
    const entry = waiting.get(answer.id);
    if (!entry) return;
    if (answer.type === 'progress') {
      entry.progress?.(answer.tick ?? 0);
      return;
    }
    waiting.delete(answer.id);
    if (answer.type === 'error') entry.reject(new EngineError(answer.message ?? '', false));
    else entry.resolve(answer);
  }

  /**
   * @param {string} type
   * @param {object} [body]
   * @param {Transferable[]} [transfer]
   * @param {(tick: number) => void} [progress]
   * @returns {Promise<any>} the answer; rejects with an `EngineError`
   */
  function request(type, body = {}, transfer = [], progress = undefined) {
    if (!worker) return Promise.reject(new EngineError('the engine has ended', true));
    const id = nextId++;
    const answer = new Promise((resolve, reject) => waiting.set(id, { resolve, reject, progress }));
    worker.postMessage({ id, type, ...body }, transfer);
    return answer;
  }

  return { start, request, cancel: () => worker?.postMessage({ type: 'cancel' }), end: () => end('the engine is not needed any more') };
}

/** @typedef {ReturnType<typeof createEngine>} Engine */
