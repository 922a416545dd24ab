//! The two profiles: `paper`, the text taken literally, and `published`, what the authors' last public program does.
//!
//! `paper` is [`Params::default`](super::Params); `scenarios/published.json` and `scenarios/published-nest.json` are
//! `published`: they name every parameter that differs. Where one setting says both, or both give the same runs, there is
//! no switch, and the table says why.
//!
//! | row | paper | published | switch |
//! |---|---|---|---|
//! | coordinates | real | whole, cells of 10 x 10 | `rounding`: whole whenever it rounds |
//! | footprint of places | disc | cells | `footprint` |
//! | sensing of places | inside the disc | same cell | `sensing` |
//! | sensing of items, agents | within 5 units | same cell | `sensing`; `sense-radius` for the first |
//! | edge | stay, turn round | two units back | `edge-rule` |
//! | agents, steps | 100, 12,000 | 100, 12,000 | `agents`, `steps` |
//! | start | hub | anywhere | `start-positions` |
//! | order of activation | shuffled | by number | `activation` |
//! | step length | 2 | 10 / (5 + load): 2 or 1 | `step-rule`, as half of `step-length` |
//! | rounding | none | nearest, half to even | `rounding`; `truncate` is the code before October 2021 |
//! | moves in a step | one | any number | `moves-per-step` |
//! | Explore's heading | uniform | N(0, 0.1) turn | `explore-heading`, `turn-deviation` |
//! | avoidance | tangent | edge of the bounding box | `avoid-rule`, `look-ahead` |
//! | obstacles, traps | none | none | `obstacles`, `traps` |
//! | site | angle at random | (-30, 30) | `site-placement`, by `site-distance` |
//! | items | scattered | stacked | `items`, `item-placement` |
//! | carry limit | one item | weights that allow one item | none: the same runs |
//! | nest sink | outside the circle | five cells, a sixth unscored | `nest-sink` |
//! | drop, food | anywhere | not with a boundary or an obstacle | `drop-rule`; the same runs as `anywhere`, and tested |
//! | drop, debris | anywhere | not in the hub | `drop-rule`: `outside-hub` |
//! | score | delivered / N | weight consumed / total | none: all items weigh the same |
//! | success threshold | 80 % | 5 % is a flag for sampling only | `success-threshold`: 80 % in both |
//! | known at the start | hub, boundary | hub, first boundary cell | `initial-memory` |
//! | percept blackboard | private | one for all | `blackboard`: private in both presets; `shared` is exact, its effect small |
//! | percept wipe | each tick | each look | `percept-wipe`; with it IsCarryable reads the blackboard only |
//! | MoveAway's goal | place not sensed | place sensed | `moveaway-postcondition` |
//! | CompositeDrop's goal | not carrying | none, a look around first | `drop-postcondition` |
//! | IsDropable | always | always | `is-dropable` |
//! | RUNNING, the dead | none; neither tick nor meet | none; skipped | none: the same runs |
//! | grammar | `ppa` | by task | `grammar`: the word `published` |
//! | genome | 100 codons | starts near 24, at most 100 | none: the length follows from `init` |
//! | codons | 0 to 255 | 0 to 2000 | `codon-max` |
//! | start genomes | random until valid | random derivation and a tail | `init`; of the code's three the first, so one |
//! | depth limit | 10 | 10 | `max-depth`; a root counted as 1 is `max-depth` 11 |
//! | wraps | 0 | 0 | `max-wraps` |
//! | too long | cut | pair drawn again | `length-rule` |
//! | mutation | bits, 0.01 | used codons, 0.1 | `mutation-mode`, `mutation-probability` |
//! | crossover | variable, 0.9 | variable, 0.9 | `crossover-mode`, `crossover-probability` |
//! | children | 24 | 24 | `children` |
//! | invalid children | discarded | ranked last | none: they never win, and count among the 24 in both |
//! | neighbours | others in the radius | the cell and itself, two at least | `neighbours` |
//! | interaction | 0.85 | 0.85 | `interaction-probability` |
//! | storage content | a copy | live references, every meeting | `storage-content`, `storage-value` |
//! | storage threshold | exceeds 7 | reaches 7, nest 5 | `storage-threshold`: reaches 7 is exceeds 6 |
//! | stagnation | none | 200 steps with E < 2 | `stagnation` |
//! | parents | best half, own among them | best half of the storage | `parent-share`, `own-in-pool` |
//! | child ranking | diversity | diversity | `genome-selection` |
//! | elite | 0 | 1, by fitness | `elite-size`, `elite-rank` |
//! | swap | if D is greater | always | `swap-rule` |
//! | state at a swap | all restarts | all restarts, last fitness kept | none: only `fitness` reads what is kept |
//! | A | 0.9 A + D + E + B | 0.1 of the program before + E + B | `fitness`, `fitness-memory`, `fitness-diversity` |
//! | D | names / names of the grammar | 25 m / (9 ceil(T / 9)) | `diversity` |
//! | E | unit squares | cells of 10 x 10, minus 1 | `exploration` |
//! | B | Post, Con, root | every selector | `bt-feedback` |
//! | pool of fixed programs | agents by A | distinct programs by A | `population-pool` |
//! | dealing | round-robin | round-robin, in blocks for tests | none: it only renumbers agents |
//! | blended root | success on one | on all, shuffled | none: no status of the root is read, every child ticks |
//! | test world, sampling | all runs, 5,000 steps | runs above a share | the study's own setting |
//!
//! Readings of the code where it leaves room: the child mutates while it is mapped, so exactly the codons that the
//! new derivation reads may change (the code mutates those that the old one used); a child that derives too deep is
//! invalid and passes, only its length makes a pair be drawn again; cell mates are stored in the order of their numbers,
//! not of their arrival; a look in all directions remembers an item if there is one.
