# The two commands: `make demo` runs the 1971 chain, `make test` runs every check.
# Each makes its own virtual environment in .venv; Python 3.11 or later, pip and make are all it needs.

PYTHON ?= python3
BIN := .venv/bin

# `make samples` makes the bundled tapes of tapes/ again; a test holds them against the chain.
# `make fewest` searches for the fewest blocks of the piece-wise technique again: four of the bundled tapes, in ten minutes.
# `make evidence` makes the sources of programs/ and the tables of docs/restoration.md and docs/thesis.md; a test too.
# `make figures` makes every figure, table and listing of the thesis, with a page of them, in figures/.
# `make lockstep N=1e9` runs random situations on the machine in all its forms and on the reference, for so many instructions.
# `make faults` puts every fault of tests/faults/ into a copy of the sources and says which test finds it.

.PHONY: demo
demo: .venv/ready
	mkdir -p demo
	$(BIN)/pdp8 part circle > demo/circle.asc
	$(BIN)/pdp8 run eia.pal < demo/circle.asc > demo/circle.eia
	$(BIN)/pdp8 tape info demo/circle.asc demo/circle.eia
	$(BIN)/pdp8 replay circle --out demo/afternoon --html demo/circle.html
	$(BIN)/pdp8 workbench -o demo/pdp8.html
	@echo "Now open demo/circle.html and demo/pdp8.html in a browser, or sit down at the machine: $(BIN)/pdp8 panel"

.PHONY: samples
samples: .venv/ready
	for part in circle ellipse; do \
	    $(BIN)/pdp8 part $$part -o tapes/$$part.asc && \
	    $(BIN)/pdp8 run eia.pal --reader tapes/$$part.asc --punch tapes/$$part.eia || exit 1; \
	done
	$(BIN)/pal eia.pal -o tapes/eia.bin

.PHONY: fewest
fewest: .venv/ready
	$(BIN)/python -m tests.reference.fewest

.PHONY: test
test: lint
	$(BIN)/pytest -q -n auto --dist loadfile -m "not slow"

# What is slow or rare: whole docs pages, 10^5 characters, pages in browsers, the site, Pyodide, the fuzzer.
.PHONY: check
check: .venv/ready-dev
	$(BIN)/pytest -q -n auto --dist loadfile -m slow

# Lines that the tests run, in a copy of the sources in which nothing is compiled; commands count too. There
# everything is slow: a test that fails is not what is asked.
COPY := $(CURDIR)/build/coverage
.PHONY: coverage
coverage: .venv/ready-dev
	rm -rf $(COPY) && mkdir -p $(COPY)
	git ls-files -z --cached --others --exclude-standard | tar --null -T - -cf - | tar -C $(COPY) -xf -
	-cd $(COPY) && PYTHONPATH=$(COPY) $(CURDIR)/$(BIN)/python -m coverage run -m pytest -q -n auto
	cd $(COPY) && $(CURDIR)/$(BIN)/coverage combine -q && $(CURDIR)/$(BIN)/coverage report --fail-under=98

.PHONY: evidence
evidence: .venv/ready
	$(BIN)/python -m tests.reference.variants
	$(BIN)/python -m pdp8.thesis.edition

.PHONY: figures
figures: .venv/ready
	$(BIN)/pdp8 thesis make all --out figures

N ?= 1e8
SEED ?= 0
.PHONY: lockstep
lockstep: .venv/ready-dev
	$(BIN)/python -m tests.pdp8.computer.lockstep $(N) $(SEED) $(shell nproc)

# `make leak SECONDS=600` translates the circle on the workbench at full speed, and compares the heap before and after.
SECONDS ?= 600
.PHONY: leak
leak: .venv/ready-dev
	LEAK=$(SECONDS) $(BIN)/pytest -q -rP tests/pdp8/web/test_workbench.py -k leaks

.PHONY: faults
faults: .venv/ready-dev
	$(BIN)/python -m tests.faults -j $(shell nproc)

# `make mutants ROOM=nc` changes one thing at a time in a room and says which changes no test finds.
# SAMPLE=300 draws so many a room, SINCE=main takes changed lines alone.
ROOM ?=
SAMPLE ?= 0
.PHONY: mutants
mutants: .venv/ready-dev
	nice $(BIN)/python -m tests.mutation $(ROOM) --sample $(SAMPLE) $(if $(SINCE),--since $(SINCE)) -j $(shell nproc)

# `make fuzz COUNT=1000000` calls every command with hostile inputs, from SEED on.
COUNT ?= 100000
.PHONY: fuzz
fuzz: .venv/ready-dev
	$(BIN)/python -m tests.fuzz.fuzzer --count $(COUNT) --seed $(SEED)

# Every option alone and every two together acts, or is refused; writes the table of docs/options.md.
.PHONY: options
options: .venv/ready-dev
	$(BIN)/python -m tests.options.pairs

.PHONY: lint
lint: .venv/ready-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pdp8.web.translator
	$(BIN)/mypy -n 2

.PHONY: format
format: .venv/ready-dev
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

# The documentation as a site in build/site, without a warning (mkdocs.yml).
.PHONY: docs
docs: .venv/ready-dev
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build -q --strict

# The sdist and the wheels, each installed and tried, in dist/ (release/dist.py).
.PHONY: dist
dist: .venv/bin/pip
	$(BIN)/pip install -q --disable-pip-version-check -e ".[release]"
	$(BIN)/python release/dist.py

# The compiled form of these sits beside its source and would hide what is changed there.
COMPILED := $(wildcard pal/*.pxd pdp8/computer/*/*.pxd)

BUILT_FROM := pyproject.toml setup.py release/threaded.py $(COMPILED) $(COMPILED:.pxd=.py)

# What pip does to whatever it copies; the sources of an editable installation are compiled by nobody where
# PYTHONDONTWRITEBYTECODE is set, and then at every start.
BYTECODE = $(BIN)/python -m compileall -q -j 0 tapes pal pdp8 programs nc

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
	$(call INSTALL,dev,700 MB)
	@touch .venv/ready $@

.PHONY: clean
clean:
	rm -rf .venv demo figures build dist *.egg-info pal/*.so pdp8/computer/*/*.so
