// WebKit under the locale C names a language that does not exist, and the charts' package formats numbers in that language
// as soon as it is loaded. Without this the tabs with charts would not open there.

try {
  new Intl.NumberFormat(navigator.language);
} catch {
  Object.defineProperty(navigator, 'language', { value: 'en', configurable: true });
}
