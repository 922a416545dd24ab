import { button, h, write } from './dom.js';
import { text } from './strings.en.js';
import { recall, remember } from './storage.js';
import { readTheme } from '../draw/theme.js';

/** @import { Theme } from '../draw/theme.js' */

const CHOICES = /** @type {const} */ (['system', 'light', 'dark']);

/** The colours in force and a button that changes them. */
export function createThemeSwitch() {
  const root = document.documentElement;
  /** @type {(() => void)[]} */
  const listeners = [];
  let choice = CHOICES.find((name) => name === recall('theme')) ?? 'system';
  const shown = h('span', { class: 'theme-name' }, text.theme[choice]);
  const element = button('', () => {
    choice = CHOICES[(CHOICES.indexOf(choice) + 1) % CHOICES.length];
    remember('theme', choice === 'system' ? null : choice);
    apply();
  });
  element.id = 'theme';
  element.append(h('span', { class: 'wide' }, text.theme.label), h('span', { class: 'narrow' }, '◐ '), shown);
  /** @type {Theme} */
  let theme;

  function apply() {
    if (choice === 'system') delete root.dataset.theme;
    else root.dataset.theme = choice;
    write(shown, text.theme[choice]);
    element.setAttribute('aria-label', text.theme.label + text.theme[choice]);
    theme = readTheme(root);
    for (const listener of listeners) listener();
  }

  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', apply);
  apply();
  return { element, theme: () => theme, on: (/** @type {() => void} */ listener) => void listeners.push(listener) };
}

/** @typedef {ReturnType<typeof createThemeSwitch>} ThemeSwitch */
