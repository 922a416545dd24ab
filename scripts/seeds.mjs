// Sums up the lines of `swarm-playground run` on standard input: successes, runs, mean, least and most delivered.

import { readFileSync } from 'node:fs';

const { title } = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const lines = readFileSync(0, 'utf8').trim().split('\n');
const outcomes = lines.map((line) => JSON.parse(line).outcome);
const shares = outcomes.map((outcome) => outcome.share);
const mean = shares.reduce((sum, share) => sum + share, 0) / shares.length;
const percent = (share) => `${(100 * share).toFixed(1)} %`;
const succeeded = outcomes.filter((outcome) => outcome.success).length;
const range = `${percent(Math.min(...shares))} to ${percent(Math.max(...shares))}`;
console.log([title, `${succeeded} of ${shares.length} runs`, `mean ${percent(mean)}`, range].join('\t'));
