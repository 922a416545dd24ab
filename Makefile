# Every command of the project: `make` alone lists them.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help play test build bench docs package workflow workflow-env clean tools packages engine check check-port

PORT ?= 8080
export PORT

# Where the engine is built to, a folder for each face, see below.
engine_one := www/studies/engine www/sequence/engine
engine_two := www/engine www/trees/engine www/soccer/engine
engine_folders := $(engine_one) $(engine_two)

# First on PATH, since wasm-pack takes the wasm-bindgen and the wasm-opt it finds there: another version of the one
# would not fit, and some distributions' version of the other breaks the page without an error.
export PATH := $(CURDIR)/.tools/bin:$(CURDIR)/node_modules/.bin:$(PATH)

help:
	@echo 'make play     build what is missing and serve the playground (PORT=8080 chooses the port)'
	@echo 'make test     run every test and check; ends with "N passed, N failed"'
	@echo 'make build    build the static site into dist/; it works under any path of any server'
	@echo 'make bench    measure the engine natively and in WebAssembly (STEPS, ROUNDS and SCENARIO choose what)'
	@echo 'make docs     write the papers map and the documentation of the library'
	@echo 'make package  build the npm package into target/npm/'
	@echo 'make workflow run a study in shards that can be killed (STUDY, SIZE, CORES); docs/scaling.md tells of clusters'
	@echo 'make clean    remove what was built, but not the tools and packages, which take minutes'

# The browser's address is printed last; the sources of the page are served, so an edit shows at once.
play: check check-port .tools/bin/wasm-pack node_modules/.package-lock.json \
  $(engine_folders:%=%/swarm_playground_bg.wasm) www/schema.json www/landing.html
	@node scripts/play.mjs

test: check
	@node scripts/test.mjs

build: check node_modules/.package-lock.json engine
	@node_modules/.bin/vite build --logLevel warn
	@echo 'Built dist/.'

bench: check engine
	@node scripts/bench.mjs

# Warnings fail it, so that no link in the documentation leads nowhere.
docs: check
	@node scripts/papers.mjs
	@RUSTDOCFLAGS='-D warnings' cargo doc --no-deps --locked --quiet
	@echo 'Wrote target/doc/swarm_playground/index.html.'

package: check .tools/bin/wasm-pack node_modules/.package-lock.json
	@node scripts/package.mjs

workflow-env:
	@python3 scripts/workflow.py install

STUDY ?= studies/figure-2a.json
SIZE ?= paper
CORES ?= all
workflow: check workflow-env
	@cargo build --release --locked --quiet
	@.tools/workflow/bin/snakemake --snakefile workflow/Snakefile --cores $(CORES) --config study=$(STUDY) size=$(SIZE)

clean:
	rm -rf dist $(engine_folders) www/schema.json www/landing.html
	cargo clean

# Steps of the above, by name for scripts/test.mjs.
tools: .tools/bin/wasm-pack
packages: node_modules/.package-lock.json

# Two faces at a time, since the compiler works at one on one processor for most of its time. Cargo builds one thing at a time
# in a folder, so the second half has one of its own. Each half takes about as long as the other.
faces = $(MAKE) --no-print-directory $(patsubst %,%/.optimised,$(1))
engine: check .tools/bin/wasm-pack node_modules/.package-lock.json
	@CARGO_TARGET_DIR='$(CURDIR)/target/two' $(call faces,$(engine_two)) & two=$$!; \
	  $(call faces,$(engine_one)); one=$$?; wait $$two && exit $$one
	@$(MAKE) --no-print-directory www/schema.json www/landing.html

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

# The engine is five wasm files: the worlds, and the tree workbench, the studies, behaviour sequencing and robot soccer,
# which the page loads when they are opened. Each is built in one place in two ways: quickly for `make play`, and optimised for
# everything that is given away or measured. The file .optimised says which one is there; `make play` takes either.
#   $(call wasm_pack_build,FACE,FOLDER,OPTIONS OF WASM-PACK)
# The worlds are in the first load, so they are built for size, but with more inlining than that implies: a tenth smaller
# than the fastest build, and nearly as fast.
wasm_pack_build = $(if $(filter worlds,$(1)),CARGO_PROFILE_RELEASE_OPT_LEVEL=s \
  CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS='-C llvm-args=-inline-threshold=100') \
  .tools/bin/wasm-pack --log-level warn build --mode no-install --target web --release \
  --out-dir $(2) --out-name swarm_playground --no-pack $(3) -- --no-default-features --features $(1)

# Folders are among the sources: they change when a file is removed.
engine_sources := Makefile Cargo.toml Cargo.lock $(shell find src scenarios trees/soccer)

# The two rules of a face.
#   $(call engine_rules,FACE,FOLDER,WHAT IT IS CALLED)
define engine_rules
$(2)/swarm_playground_bg.wasm: $$(engine_sources) .tools/bin/wasm-pack | check
	@echo 'Building the $(3)'
	@rm -f $(2)/.optimised
	@$$(call wasm_pack_build,$(1),$(2),--no-opt)

$(2)/.optimised: $$(engine_sources) .tools/bin/wasm-pack | check node_modules/.package-lock.json
	@echo 'Building the optimised $(3)'
	@$$(call wasm_pack_build,$(1),$(2))
	@touch $$@

endef

$(eval $(call engine_rules,worlds,www/engine,engine))
$(eval $(call engine_rules,trees,www/trees/engine,tree workbench))
$(eval $(call engine_rules,studies,www/studies/engine,engine of the studies))
$(eval $(call engine_rules,sequence,www/sequence/engine,engine of behaviour sequencing))
$(eval $(call engine_rules,soccer-page,www/soccer/engine,engine of robot soccer))

# The first engine has no room for what is said of parameters; another one writes it down.
www/schema.json: www/studies/engine/swarm_playground_bg.wasm scripts/schema.mjs
	@node scripts/schema.mjs

# What is seen before any script has run: a moment that the engine makes.
www/landing.html: www/engine/swarm_playground_bg.wasm scripts/still.mjs www/opening.js www/ui/strings.landing.en.js \
  www/draw/world.js www/draw/frame.js
	@node scripts/still.mjs
