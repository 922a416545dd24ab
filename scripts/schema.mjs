// Writes what the engine says of its parameters into www/schema.json, which the page loads first: the engine of the
// studies has the texts, that of the worlds has no room for them. Both are of one source, so they agree. The parameters of
// worlds that the first engine does not have are left out.

import { readFileSync, writeFileSync } from 'node:fs';
import { initSync, schema } from '../www/studies/engine/swarm_playground.js';

initSync({ module: readFileSync('www/studies/engine/swarm_playground_bg.wasm') });
/** @type {{ key: string }[]} */
const parameters = JSON.parse(schema());
writeFileSync('www/schema.json', JSON.stringify(parameters.filter(({ key }) => key === 'seed' || key.startsWith('geese.'))));
