# Every command of the project: `make` alone lists them.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help play test build bench clean tools packages engine check check-port

PORT ?= 8080
export PORT

# First on PATH, since wasm-pack takes the wasm-bindgen and the wasm-opt it finds there: another version of the one
# would not fit, and some distributions' version of the other breaks the page without an error.
export PATH := $(CURDIR)/.tools/bin:$(CURDIR)/node_modules/.bin:$(PATH)

help:
	@echo 'make play     build what is missing and serve the playground (PORT=8080 chooses the port)'
	@echo 'make test     run every test and check; ends with "N passed, N failed"'
	@echo 'make build    build the static site into dist/; it works under any path of any server'
	@echo 'make bench    measure the engine natively and in WebAssembly (STEPS, ROUNDS and SCENARIO choose what)'
	@echo 'make clean    remove what was built, but not the tools and packages, which take minutes'

# The browser's address is printed last; the sources of the page are served, so an edit shows at once.
play: check check-port .tools/bin/wasm-pack node_modules/.package-lock.json www/engine/swarm_playground_bg.wasm \
  www/trees/engine/swarm_playground_bg.wasm www/studies/engine/swarm_playground_bg.wasm \
  www/sequence/engine/swarm_playground_bg.wasm www/schema.json www/landing.html
	@node scripts/play.mjs

test: check
	@node scripts/test.mjs

build: check node_modules/.package-lock.json engine
	@node_modules/.bin/vite build --logLevel warn
	@echo 'Built dist/.'

bench: check engine
	@node scripts/bench.mjs

clean:
	rm -rf dist www/engine www/trees/engine www/studies/engine www/sequence/engine www/schema.json www/landing.html
	cargo clean

# Steps of the above, by name for scripts/test.mjs.
tools: .tools/bin/wasm-pack
packages: node_modules/.package-lock.json
engine: www/engine/.optimised www/trees/engine/.optimised www/studies/engine/.optimised \
  www/sequence/engine/.optimised www/schema.json www/landing.html

check:
	@sh scripts/check.sh $(MAKECMDGOALS)

# Before anything is built, so that a busy port is told at once.
check-port: check
	@node scripts/play.mjs --check-port

# Cargo's notes on old code inside the tools' dependencies concern nobody here.
.tools/bin/wasm-pack: $(shell find tools/Cargo.toml tools/Cargo.lock tools/src) | check
	@echo 'Building wasm-pack and wasm-bindgen, once: two to three minutes'
	@CARGO_FUTURE_INCOMPAT_REPORT_FREQUENCY=never \
	  cargo build --locked --manifest-path tools/Cargo.toml --target-dir .tools/target
	@mkdir -p .tools/bin
	@cd .tools/target/debug && cp -f wasm-bindgen wasm-bindgen-test-runner wasm-pack ../../bin/

node_modules/.package-lock.json: package-lock.json | check
	@echo 'Installing the npm packages'
	@npm ci --no-audit --no-fund --loglevel error
	@touch $@

# The engine is four wasm files: the worlds, and the tree workbench, the studies and behaviour sequencing, which the page
# loads when they are opened. Each is built in one place in two ways: quickly for `make play`, and optimised for
# everything that is given away or measured. The file .optimised says which one is there; `make play` takes either.
#   $(call wasm_pack_build,FACE,FOLDER,OPTIONS OF WASM-PACK)
# The worlds are in the first load, so they are built for size, but with more inlining than that implies: a tenth smaller
# than the fastest build, and nearly as fast.
wasm_pack_build = $(if $(filter worlds,$(1)),CARGO_PROFILE_RELEASE_OPT_LEVEL=s \
  CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS='-C llvm-args=-inline-threshold=100') \
  .tools/bin/wasm-pack --log-level warn build --mode no-install --target web --release \
  --out-dir $(2) --out-name swarm_playground --no-pack $(3) -- --no-default-features --features $(1)

# Folders are among the sources: they change when a file is removed.
engine_sources := Makefile Cargo.toml Cargo.lock $(shell find src scenarios)

www/engine/swarm_playground_bg.wasm: $(engine_sources) .tools/bin/wasm-pack | check
	@echo 'Building the engine'
	@rm -f www/engine/.optimised
	@$(call wasm_pack_build,worlds,www/engine,--no-opt)

www/engine/.optimised: $(engine_sources) .tools/bin/wasm-pack | check node_modules/.package-lock.json
	@echo 'Building the optimised engine'
	@$(call wasm_pack_build,worlds,www/engine)
	@touch $@

www/trees/engine/swarm_playground_bg.wasm: $(engine_sources) .tools/bin/wasm-pack | check
	@echo 'Building the tree workbench'
	@rm -f www/trees/engine/.optimised
	@$(call wasm_pack_build,trees,www/trees/engine,--no-opt)

www/trees/engine/.optimised: $(engine_sources) .tools/bin/wasm-pack | check node_modules/.package-lock.json
	@echo 'Building the optimised tree workbench'
	@$(call wasm_pack_build,trees,www/trees/engine)
	@touch $@

www/studies/engine/swarm_playground_bg.wasm: $(engine_sources) .tools/bin/wasm-pack | check
	@echo 'Building the engine of the studies'
	@rm -f www/studies/engine/.optimised
	@$(call wasm_pack_build,studies,www/studies/engine,--no-opt)

# The first engine has no room for what is said of parameters; another one writes it down.
www/schema.json: www/studies/engine/swarm_playground_bg.wasm scripts/schema.mjs
	@node scripts/schema.mjs

# What is seen before any script has run: a moment that the engine makes.
www/landing.html: www/engine/swarm_playground_bg.wasm scripts/still.mjs www/opening.js www/ui/strings.landing.en.js \
  www/draw/world.js www/draw/frame.js
	@node scripts/still.mjs

www/studies/engine/.optimised: $(engine_sources) .tools/bin/wasm-pack | check node_modules/.package-lock.json
	@echo 'Building the optimised engine of the studies'
	@$(call wasm_pack_build,studies,www/studies/engine)
	@touch $@

www/sequence/engine/swarm_playground_bg.wasm: $(engine_sources) .tools/bin/wasm-pack | check
	@echo 'Building the engine of behaviour sequencing'
	@rm -f www/sequence/engine/.optimised
	@$(call wasm_pack_build,sequence,www/sequence/engine,--no-opt)

www/sequence/engine/.optimised: $(engine_sources) .tools/bin/wasm-pack | check node_modules/.package-lock.json
	@echo 'Building the optimised engine of behaviour sequencing'
	@$(call wasm_pack_build,sequence,www/sequence/engine)
	@touch $@
