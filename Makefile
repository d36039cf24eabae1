# make run    the app on http://localhost:5006/        make run PORT=8000   on another port
# make test   every check, in a real Chromium too      make load | accuracy | bench   the measurements
PORT ?= 5006
VENV ?= .venv
BIN := $(VENV)/bin
# The first Python of 3.11 to 3.13 that can make a virtual environment.
CAN := import sys, venv, ensurepip; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))
PYTHON ?= $(shell for p in python3 python3.13 python3.12 python3.11; do $$p -c '$(CAN)' 2>/dev/null && echo $$p && break; done)
INSTALL := $(BIN)/pip install --quiet --disable-pip-version-check --require-hashes
LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
	--no-emit-index-url --custom-compile-command "make lock"
# A text browser must not take the terminal: a page is opened only where there is a screen.
SHOW := $(if $(or $(DISPLAY),$(WAYLAND_DISPLAY),$(filter Darwin,$(shell uname))),--show)

.PHONY: run test lint types fast load accuracy bench lock docker clean

run: $(VENV)/run.stamp
	$(BIN)/panel serve app.py --index app --static-dirs assets=static --address localhost --port $(PORT) \
		--allow-websocket-origin localhost:$(PORT) --allow-websocket-origin 127.0.0.1:$(PORT) $(SHOW)

test: lint
	CHROMIUM="$$($(BIN)/python -m tests.chromium)" $(BIN)/pytest

lint: $(VENV)/test.stamp
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

# What needs no browser and no server.
fast: $(VENV)/test.stamp
	$(BIN)/pytest -m "not browser"

load: $(VENV)/test.stamp
	CHROMIUM="$$($(BIN)/python -m tests.chromium)" $(BIN)/python -m tests.bench.load $(ARGS)

accuracy: $(VENV)/test.stamp
	$(BIN)/python -m tests.bench.accuracy_table $(ARGS)

bench: $(VENV)/test.stamp
	$(BIN)/python -m tests.bench.error_vs_time $(ARGS)

# Pins stay as they are unless asked for: make lock ARGS=--upgrade
lock: $(VENV)/test.stamp
	$(LOCK) $(ARGS) requirements.in --output-file requirements.txt
	$(LOCK) $(ARGS) requirements-test.in --output-file requirements-test.txt

docker:
	docker build --tag oscillations .

clean:
	rm -rf $(VENV) build .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache

$(VENV)/run.stamp: requirements.txt
	@test -n "$(PYTHON)" || { echo "Needs Python 3.11, 3.12 or 3.13 with venv: make PYTHON=/path/to/python3.12"; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
	$(INSTALL) -r requirements.txt
	@touch $@

$(VENV)/test.stamp: requirements-test.txt $(VENV)/run.stamp
	$(INSTALL) -r requirements-test.txt
	@touch $@
