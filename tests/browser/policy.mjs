// What the page may load: nothing but its own files, by its own policy, and nothing else is ever asked for.
import assert from 'node:assert/strict';

const POLICY = {
  'default-src': "'none'",
  'script-src': "'self' 'wasm-unsafe-eval'",
  'worker-src': "'self'",
  'connect-src': "'self'",
  'style-src': "'self'",
  'img-src': "'self' data: blob:",
  'base-uri': "'none'",
  'form-action': "'none'",
};

/** Notes each breach of the policy where the test finds it. */
const NOTE_BREACHES = () => {
  const breaches = /** @type {string[]} */ ((/** @type {any} */ (window).breaches = []));
  document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, sourceFile, lineNumber }) => breaches.push(`${effectiveDirective} ${blockedURI} ${sourceFile}:${lineNumber}`));
};

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'the_policy_of_the_built_page_allows_its_own_files_and_wasm_only',
    async (open, url) => {
      const html = await (await fetch(url)).text();
      assert.match(html.slice(0, html.indexOf('Content-Security-Policy')), /^(?!.*<(?:script|link|style))/s, 'the policy stands before everything it governs');
      const { page } = await open();
      const found = await page.evaluate((source) => {
        const parsed = new DOMParser().parseFromString(source, 'text/html');
        const written = [...parsed.querySelectorAll('*')].flatMap(({ localName, attributes }) => [...attributes].map(({ name, value }) => ({ localName, name, value })));
        return {
          policy: parsed.querySelector('meta[http-equiv=Content-Security-Policy]')?.getAttribute('content') ?? '',
          inline: parsed.querySelectorAll('script:not([src]), style').length,
          attributes: written.filter(({ name }) => name === 'style' || name.startsWith('on')),
          addresses: written.filter(({ name, value }) => ['src', 'href'].includes(name) && !/^(\.\/|#)/.test(value)),
        };
      }, html);
      const policy = Object.fromEntries(found.policy.split('; ').map((part) => [part.slice(0, part.indexOf(' ')), part.slice(part.indexOf(' ') + 1)]));
      assert.deepEqual({ ...found, policy }, { policy: POLICY, inline: 0, attributes: [], addresses: [] });
    },
  ],
  [
    'eval_inline_code_inline_style_and_other_hosts_are_refused',
    async (open) => {
      const { page } = await open();
      const refused = await page.evaluate(async () => {
        /** @type {string[]} */
        const breaches = [];
        document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => breaches.push(effectiveDirective));
        const script = document.createElement('script');
        script.textContent = 'document.title = "inline"';
        document.body.append(script);
        document.body.setAttribute('style', 'color: red');
        let evaluated = false;
        await new Promise((resolve) => setTimeout(resolve)); // from here on it is the page's own code, which no debugger lets do more
        try {
          evaluated = new Function('return true')();
        } catch {
          // as it should be
        }
        const foreign = await fetch('http://127.0.0.1:1/').then(() => true, () => false);
        await new Promise((resolve) => setTimeout(resolve)); // breaches are told in a task of their own
        return { breaches: breaches.sort(), evaluated, foreign, title: document.title };
      });
      assert.deepEqual(refused.breaches, ['connect-src', 'script-src', 'script-src-elem', 'style-src-attr']);
      assert.deepEqual([refused.evaluated, refused.foreign], [false, false]);
      assert.notEqual(refused.title, 'inline');
    },
  ],
  [
    'no_tab_asks_another_host_or_breaks_the_policy',
    async (open, url) => {
      const { page, inState, problems } = await open();
      await page.addInitScript(NOTE_BREACHES);
      /** @type {Set<string>} */
      const asked = new Set();
      page.context().on('request', (request) => asked.add(request.url()));
      await page.reload();
      await inState('paused', 'finished');
      const tabs = await page.locator('#top nav a').evaluateAll((links) => links.map((link) => link.getAttribute('href') ?? ''));
      assert.ok(tabs.length >= 4, tabs.join(' '));
      for (const tab of [...tabs, '#/studies/agents', '#/bench']) {
        await page.evaluate((hash) => void (location.hash = hash), tab);
        await inState('paused', 'finished', 'running', 'busy');
        await page.locator('.page-tab:visible').first().waitFor();
      }
      await page.waitForLoadState('networkidle');
      const foreign = [...asked].filter((address) => !address.startsWith(url) && !/^(data|blob):/.test(address));
      assert.deepEqual(foreign, []);
      assert.deepEqual(await page.evaluate(() => /** @type {any} */ (window).breaches), []);
      assert.deepEqual(problems, []);
      return `${tabs.length + 2} addresses, ${asked.size} requests`;
    },
  ],
];
