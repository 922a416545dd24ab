// Writes what the engine says of its parameters into www/schema.json, which the page loads first: the engine of the
// studies has the texts, that of the worlds has no room for them. Both are of one source, so they agree.

import { readFileSync, writeFileSync } from 'node:fs';
import { initSync, schema } from '../www/studies/engine/swarm_playground.js';

initSync({ module: readFileSync('www/studies/engine/swarm_playground_bg.wasm') });
writeFileSync('www/schema.json', schema());
