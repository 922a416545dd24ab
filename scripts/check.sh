#!/bin/sh
# Names, in one sentence, the first thing that is missing on this machine, and exits with status 1.
# Adds the wasm32 target, which rustup brings in seconds.

missing() {
  echo "$1" >&2
  exit 1
}

# at_least MAJOR.MINOR of "1.95.0" or "v20.19.1", MAJOR, MINOR
at_least() {
  version=${1#v}
  major=${version%%.*}
  rest=${version#*.}
  minor=${rest%%.*}
  [ "$major" -gt "$2" ] || { [ "$major" -eq "$2" ] && [ "$minor" -ge "$3" ]; }
}

command -v cargo >/dev/null && command -v rustc >/dev/null ||
  missing "Rust is missing: install it with rustup, see https://rustup.rs."
rust=$(rustc --version 2>/dev/null | cut -d ' ' -f 2)
[ -n "$rust" ] || missing "Rust has no toolchain yet: run 'rustup default stable'."
at_least "$rust" 1 89 || missing "Rust $rust is too old, 1.89 or later is needed: run 'rustup update'."

command -v cc >/dev/null || missing "A C compiler is missing, which Rust links with: install gcc or clang."

command -v node >/dev/null && command -v npm >/dev/null ||
  missing "Node.js or its npm is missing: install Node.js 20.19 or later, see https://nodejs.org."
node=$(node --version)
{ at_least "$node" 20 19 && ! at_least "$node" 21 0; } || at_least "$node" 22 12 ||
  missing "Node.js $node does not suit: install 20.19 or a later 20, or 22.12 or later, see https://nodejs.org."

if [ ! -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
  command -v rustup >/dev/null ||
    missing "The Rust target wasm32-unknown-unknown is missing, and so is rustup to add it: see https://rustup.rs."
  rustup target add wasm32-unknown-unknown ||
    missing "The Rust target wasm32-unknown-unknown could not be added: see the message above."
fi

if [ "$1" = test ]; then
  case $PWD in
    *' '*) missing "The tests in WebAssembly cannot run below a folder with a space in its name: move this one." ;;
  esac
  cargo fmt --version >/dev/null 2>&1 && cargo clippy --version >/dev/null 2>&1 ||
    missing "Rust's formatter or linter is missing: run 'rustup component add rustfmt clippy'."
fi
