# The two commands: `make demo` runs the 1971 chain, `make test` runs every check.
# Each makes its own virtual environment in .venv; Python 3.11 or later, pip and make are all it needs.

PYTHON ?= python3
BIN := .venv/bin

.PHONY: demo test lint format clean

demo: .venv/ready
	mkdir -p demo
	$(BIN)/pdp8 part circle > demo/circle.asc
	$(BIN)/pdp8 run eia.pal < demo/circle.asc > demo/circle.eia
	$(BIN)/pdp8 tape info demo/circle.asc demo/circle.eia

test: lint
	$(BIN)/pytest -q -n auto

lint: .venv/ready-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

format: .venv/ready-dev
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

.venv/ready: pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/pip install -q --disable-pip-version-check -e .
	touch $@

.venv/ready-dev: .venv/ready
	$(BIN)/pip install -q --disable-pip-version-check -e ".[dev]"
	touch $@

clean:
	rm -rf .venv demo build dist *.egg-info
