import { h } from './dom.js';
import { text } from './strings.en.js';

/** The way to the page that measures, for a footer. */
export const benchLink = () => h('a', { href: '#/bench' }, text.foot.bench);
