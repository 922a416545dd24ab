import { text } from './ui/strings.en.js';

export const LONGEST_LINK = 8000;

/**
 * What stands before and after the first `mark`; only the string when there is none.
 *
 * @param {string} string
 * @param {string} mark
 * @returns {string[]}
 */
export function splitOnce(string, mark) {
  const at = string.indexOf(mark);
  return at < 0 ? [string] : [string.slice(0, at), string.slice(at + 1)];
}

/** A part of an address as it was before it was escaped; throws a sentence. @param {string} raw */
export function decode(raw) {
  try {
    return decodeURIComponent(raw);
  } catch {
    throw new Error(text.link.escape(raw));
  }
}

/** `~` and base64url of raw deflate. @param {string} string */
export async function pack(string) {
  const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(string));
  let binary = '';
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return `~${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** What `pack` was given; a text without `~` stands for itself. Throws a sentence. @param {string} packed */
export async function unpack(packed) {
  if (!packed.startsWith('~')) return decode(packed);
  try {
    const binary = atob(packed.slice(1).replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const unpacked = await through(new DecompressionStream('deflate-raw'), bytes);
    return new TextDecoder('utf-8', { fatal: true }).decode(unpacked);
  } catch {
    throw new Error(text.link.packed);
  }
}

/** @param {CompressionStream | DecompressionStream} stream @param {Uint8Array<ArrayBuffer>} bytes */
async function through(stream, bytes) {
  const piped = new Blob([bytes]).stream().pipeThrough(/** @type {ReadableWritablePair<Uint8Array, Uint8Array>} */ (/** @type {unknown} */ (stream)));
  return new Uint8Array(await new Response(piped).arrayBuffer());
}
