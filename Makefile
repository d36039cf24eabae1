# make run                 starts the app at http://localhost:5006/; make run PORT=8000 uses another port
# make run HOST=0.0.0.0    also serves the network, so that phones can join a live class
# make test                runs the fast tests, some in Chromium; make rest runs the slow ones
# make load, accuracy, bench    run the measurements; CONTRIBUTING.md has all commands
PORT ?= 5006
HOST ?= localhost
VENV ?= .venv
BIN := $(VENV)/bin
# A file in each environment that make created. No other folder is ever cleared or removed.
OURS := $(VENV)/created-by-make
# The first Python of 3.11 to 3.13 that can make a virtual environment.
CAN := import sys, venv, ensurepip; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))
PYTHON ?= $(shell for p in python3 python3.13 python3.12 python3.11; do $$p -c '$(CAN)' 2>/dev/null && echo $$p && break; done)
PIP := $(BIN)/pip install --quiet --disable-pip-version-check --require-hashes
# uv installs in seconds what takes pip more than a minute. pip installs where uv does not run, or finds no package
# registry because only pip's settings name one.
install = $(BIN)/uv pip install --quiet --compile-bytecode --python $(BIN)/python --require-hashes -r $(1) || $(PIP) -r $(1)
LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
	--no-emit-index-url --no-strip-extras --custom-compile-command "make lock"
# Each of two processes starts with half of the tests; the faster one takes tests from the other.
BOTH_CORES := -n 2 --dist worksteal
# A test with a page that fails runs once more, because a busy machine can delay a frame; the summary lists it as RERUN.
ONCE_MORE := --reruns 1 -raR
# Pages wait for frames and timers: three at a time keep two cores busy.
THREE_PAGES := -n 3 --dist worksteal
BROWSER = CHROMIUM="$$($(BIN)/python -m tools.browsers.chromium)"
# Open a page only if there is a screen, because a text browser would take over the terminal.
SHOW := $(if $(or $(DISPLAY),$(WAYLAND_DISPLAY),$(filter Darwin,$(shell uname))),--show)

.PHONY: run test rest test-all browsers scene lint python-types checks format types hooks fast coverage attack audit digests \
	reconnect load course soak deploy-test class up upgrade accuracy mutants nightly pictures engines animation bench walk protocol readme lock docker clean

run: $(VENV)/run.stamp
	$(BIN)/python -m components.serving --address $(HOST) --port $(PORT) $(SHOW)

# Let the processes of the tests share compiled bytecode.
test rest test-all scene fast: export PYTHONDONTWRITEBYTECODE =

# Two runs, because Playwright leaves an event loop running in its process, which disturbs other tests.
test: lint
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and not slow"
	$(BROWSER) $(BIN)/pytest $(THREE_PAGES) $(ONCE_MORE) -m "browser and not slow"

# The slow tests: real timers, an installed package, other browsers, whole walks.
rest: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and slow and not nightly"
	$(BROWSER) $(BIN)/pytest $(THREE_PAGES) $(ONCE_MORE) -m "browser and slow and not nightly"

# Installs Safari's engine and Firefox from Debian. Without them make rest skips their tests, and says so.
browsers: $(VENV)/test.stamp
	$(BIN)/python -m tools.browsers.installing

# All tests, with every value of each grid.
test-all:
	GRIDS=whole $(MAKE) test rest

# All tests, with every scene, view and walk and with examples of the day; then faults of the day.
# make nightly SEED=20261127 repeats a night.
nightly: export SEED ?= $(shell date +%Y%m%d)
nightly: export GRIDS = whole
nightly: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) -m "not browser" --hypothesis-seed=$(SEED)
	$(BROWSER) $(BIN)/pytest $(BOTH_CORES) $(ONCE_MORE) -m browser
	$(BROWSER) $(BIN)/python -m tools.mutants --seed $(SEED) $(ARGS)

# The checks of types take as long as all others: both at once.
lint: $(VENV)/test.stamp
	$(MAKE) --jobs 2 python-types checks

python-types: $(VENV)/test.stamp
	$(BIN)/mypy

checks: $(VENV)/test.stamp
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/python -m tools.house_rules
	$(BIN)/python -m tools.plain_english
	$(BIN)/python -m tools.docstrings
	$(BIN)/oxfmt --check '**/*.{js,css}'
	$(BIN)/oxlint static
	$(BIN)/python -m tools.script_types

# Formats all code.
format: $(VENV)/test.stamp
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .
	$(BIN)/oxfmt '**/*.{js,css}'

# Checks the scripts against the types of messages. It needs npm's registry once, and says so if it cannot reach it.
types: $(VENV)/test.stamp
	$(BIN)/python -m tools.script_types

# Installs hooks that run the same tools before each commit, from this environment.
hooks: $(VENV)/test.stamp
	$(BIN)/pre-commit install

# Tests one scene: make scene SCENE=damped. It reads only test modules that cover all scenes or name this one.
OF_SCENES = $(shell grep -rlE --include='test_*.py' 'SCENES|"$(SCENE)"' tests/scenes tests/page tests/components)
scene: lint
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and not slow" -k "$(SCENE) or table_of_scenes" $(OF_SCENES) \
		tests/tooling/test_commands.py
	GRIDS=whole $(BROWSER) $(BIN)/pytest $(BOTH_CORES) -m browser -k "$(SCENE)" \
		tests/browser/test_views.py tests/browser/test_page.py tests/browser/test_gestures.py tests/browser/test_files.py

# The tests that need no browser.
fast: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) -m "not browser"

# The same, with a report of lines and branches that no test runs, including servers and workers: build/coverage.
coverage: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) --cov --cov-report=term --cov-report=html -m "not browser"

# Breaks a copy of the project by each known fault and by 100 random ones, and lists the tests that find them.
mutants: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.mutants $(ARGS)

attack: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.attack $(ARGS)

reconnect: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.reconnect $(ARGS)

load: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.bench.load $(ARGS)
	$(BIN)/python -m tools.bench.course
	$(BROWSER) $(BIN)/python -m tools.bench.slow_phone
	$(BROWSER) $(BIN)/python -m tools.bench.player

# Only the second half of make load: every scene, and a class that arrives and drags.
course: $(VENV)/test.stamp
	$(BIN)/python -m tools.bench.course $(ARGS)

# Opens and closes a thousand sessions, five times, and reports the memory that remains.
soak: $(VENV)/test.stamp
	$(BIN)/python -m tools.bench.soak $(ARGS)

# Starts two replicas behind the real proxy on this machine, kills one, then upgrades all.
deploy-test: $(VENV)/test.stamp
	$(BIN)/python -m tools.deploy $(ARGS)

# Measures a live class: 300 and 3,000 followers, answers, sketches, and two replicas of which one is killed.
class: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.bench.classroom $(ARGS)

audit: $(VENV)/test.stamp
	$(BIN)/python -m tools.audit

# To check that a change keeps every picture, run make pictures ARGS="shoot build/before" before it, then
# ARGS="shoot build/after" and ARGS="compare build/before build/after".
pictures: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.pictures $(ARGS)

# Takes pictures of all scenes in Chromium, Safari's engine and Firefox, side by side.
engines: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.engines $(or $(ARGS),build/engines)

# Makes the animation of README.md from the current page.
animation: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.animation

accuracy: $(VENV)/test.stamp
	$(BIN)/python -m tools.bench.accuracy_table $(ARGS)

bench: $(VENV)/test.stamp
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m tools.bench.error_vs_time $(ARGS)

# Checks a guided walk: make walk FILE=my-walk.toml. ARGS=--look also measures each step in a browser in hall mode,
# ARGS=--pictures writes pictures of each step to build/walk, ARGS=--serve also serves the walk.
LOOKS := $(filter --look --pictures --serve,$(ARGS))
walk: $(VENV)/$(if $(LOOKS),test,run).stamp
	$(if $(LOOKS),$(BROWSER)) $(BIN)/python -m tools.walk $(ARGS) $(FILE)

protocol: $(VENV)/test.stamp
	$(BIN)/python -m tools.protocol

readme: $(VENV)/test.stamp
	$(BIN)/python -m tools.readme

# Keeps existing pins; make lock ARGS=--upgrade pins newer versions.
lock: $(VENV)/test.stamp
	$(LOCK) $(ARGS) pyproject.toml --output-file requirements.txt
	$(LOCK) $(ARGS) pyproject.toml --extra notebook -c requirements.txt --output-file requirements-notebook.txt
	$(LOCK) $(ARGS) requirements-test.in --output-file requirements-test.txt

docker:
	docker build --tag oscillations .

# Starts the lecture behind a proxy: make up REPLICAS=4 SITE=lecture.example
up: secret store-password
	docker compose up --build --wait

# Upgrades without a break: starts as many new replicas, replaces the old ones, and removes the additional ones. If
# the new replicas do not start, the old ones stay.
upgrade: RELIEVED = docker compose --profile relief rm --stop --force relief
upgrade: secret store-password
	docker compose build lecture
	docker compose --profile relief up --detach --no-deps --wait relief || { $(RELIEVED); exit 1; }
	docker compose up --detach --no-deps --wait lecture
	$(RELIEVED)

# Compose mounts these files. Only their owner and the user 1000 of the containers can read them.
secret store-password:
	umask 077 && head -c 32 /dev/urandom | base64 > $@
	chown 1000 $@ 2>/dev/null || setfacl -m u:1000:r $@ 2>/dev/null || { rm $@; \
		echo "Nobody but the user 1000 of the containers may read the file $@: run sudo make $@, or install setfacl."; exit 1; }

# Pins the images of the containers to today's digests.
digests:
	$(BIN)/python -m tools.digests

clean:
	rm -rf build node_modules .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	@test ! -e $(OURS) || rm -rf $(VENV)
	@test ! -e $(VENV) || echo "$(VENV) stays: it has no file created-by-make."

# If requirements.txt changes, the environment is built again, so that it has no unneeded packages. An environment
# that make did not create keeps its packages.
$(VENV)/run.stamp: requirements.txt
	@test -n "$(PYTHON)" || { echo "Needs Python 3.11, 3.12 or 3.13 with venv: make PYTHON=/path/to/python3.12"; exit 1; }
	@test ! -e $(OURS) || rm -rf $(VENV)
	@test -n "$$(ls -A $(VENV) 2>/dev/null)" || { mkdir -p $(VENV) && touch $(OURS) && $(PYTHON) -m venv $(VENV); }
	@test -x $(BIN)/pip || { echo "$(VENV) is not empty and no virtual environment with pip: make VENV=another"; exit 1; }
	-sed -n '/^uv==/,/# via/p' requirements-test.txt | $(PIP) -r /dev/stdin
	$(call install,requirements.txt)
	@touch $@

$(VENV)/test.stamp: requirements-test.txt $(VENV)/run.stamp
	$(call install,requirements-test.txt)
	@touch $@
