#!/bin/sh
# Success of both presets, and of the paper's setting with the child always taken up, over seeds 1 to 32 (or SEEDS).
# One line of tab-separated values each: scenario, runs that succeeded, runs, mean and range of the share delivered.
set -eu
cargo build --release --quiet
always=$(mktemp)
trap 'rm -f "$always"' EXIT
printf '{"world": "geese", "title": "The paper, child always taken", "swap-rule": "always"}' > "$always"
for scenario in scenarios/foraging.json scenarios/foraging-paper.json "$always"; do
  for seed in $(seq 1 "${SEEDS:-32}"); do
    target/release/swarm-playground run "$scenario" --seed "$seed"
  done | node scripts/seeds.mjs "$scenario"
done
