# make run    the app on http://localhost:5006/        make run PORT=8000   on another port
# make run HOST=0.0.0.0   for the network too: a live class joins from its phones
# make test   what a change may break, in a real Chromium too      make rest   what takes long, before it is given on
# make load | accuracy | bench   the measurements
PORT ?= 5006
HOST ?= localhost
VENV ?= .venv
BIN := $(VENV)/bin
# A file in each environment that make created. No other folder is ever cleared or removed.
OURS := $(VENV)/created-by-make
# The first Python of 3.11 to 3.13 that can make a virtual environment.
CAN := import sys, venv, ensurepip; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))
PYTHON ?= $(shell for p in python3 python3.13 python3.12 python3.11; do $$p -c '$(CAN)' 2>/dev/null && echo $$p && break; done)
INSTALL := $(BIN)/pip install --quiet --disable-pip-version-check --require-hashes
LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
	--no-emit-index-url --no-strip-extras --custom-compile-command "make lock"
# Each core begins with half of the tests, in order; who is done takes over from the other.
BOTH_CORES := -n 2 --dist worksteal
# Pages wait for frames and timers: three at a time keep two cores busy.
THREE_PAGES := -n 3 --dist worksteal
BROWSER = CHROMIUM="$$($(BIN)/python -m tests.browser.chromium)"
# A text browser must not take the terminal: a page is opened only where there is a screen.
SHOW := $(if $(or $(DISPLAY),$(WAYLAND_DISPLAY),$(filter Darwin,$(shell uname))),--show)

.PHONY: run test rest test-all browsers scene lint format types hooks fast coverage attack audit digests reconnect load course soak \
	deploy-test class up upgrade accuracy mutants pictures engines animation bench walk protocol readme lock docker clean

run: $(VENV)/run.stamp
	$(BIN)/python -m components.serving --address $(HOST) --port $(PORT) $(SHOW)

# What one worker or server has compiled, the others read.
test rest test-all scene fast: export PYTHONDONTWRITEBYTECODE =

# In two runs: Playwright leaves an event loop running in a process, which other tests must not meet.
test: lint
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and not slow"
	$(BROWSER) $(BIN)/pytest $(THREE_PAGES) -m "browser and not slow"

# What takes seconds to hold what a quicker test holds in part: every scene, deployment, timers waited for.
rest: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and slow"
	$(BROWSER) $(BIN)/pytest $(BOTH_CORES) -m "browser and slow"

# Safari's engine and Firefox from Debian: without them make rest skips their tests, and says so.
browsers: $(VENV)/test.stamp
	$(BIN)/python -m tests.browser.installing

# Both, with every grid walked whole.
test-all:
	GRIDS=whole $(MAKE) test rest

lint: $(VENV)/test.stamp
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m tools.house_rules
	$(BIN)/python -m tools.plain_english
	$(BIN)/oxfmt --check '**/*.{js,css}'
	$(BIN)/oxlint static
	$(BIN)/python -m tools.script_types

# Writes all code as the linters want it.
format: $(VENV)/test.stamp
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .
	$(BIN)/oxfmt '**/*.{js,css}'

# The scripts against the page language: needs npm's registry once, and says so where it cannot be reached.
types: $(VENV)/test.stamp
	$(BIN)/python -m tools.script_types

# The same tools before each commit, from this environment.
hooks: $(VENV)/test.stamp
	$(BIN)/pre-commit install

# One scene while it is written: make scene SCENE=damped. It reads only the tests that go through all scenes or name it.
OF_SCENES = $(shell grep -rlE --include='test_*.py' 'SCENES|"$(SCENE)"' tests/scenes tests/page tests/components)
scene: lint
	$(BIN)/pytest $(BOTH_CORES) -m "not browser and not slow" -k "$(SCENE) or table_of_scenes" $(OF_SCENES) \
		tests/tooling/test_commands.py
	$(BROWSER) $(BIN)/pytest $(BOTH_CORES) -m "browser and not slow" -k "$(SCENE)" \
		tests/browser/test_screens.py tests/browser/test_texts.py tests/browser/test_page.py tests/browser/test_grabs.py \
		tests/browser/test_views.py

# What needs no browser.
fast: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) -m "not browser"

# The same, with the lines and branches that no test runs: what servers and workers run too. Pages in build/coverage.
coverage: $(VENV)/test.stamp
	$(BIN)/pytest $(BOTH_CORES) --cov --cov-report=term --cov-report=html -m "not browser"

# Twenty faults in a copy of the project, and the tests that find them.
mutants: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.mutants $(ARGS)

attack: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tests.attack $(ARGS)

reconnect: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tests.reconnect $(ARGS)

load: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tests.bench.load $(ARGS)
	$(BIN)/python -m tests.bench.course
	$(BROWSER) $(BIN)/python -m tests.bench.slow_phone

# The second half of it alone: every scene, a class that arrives, and those in it who drag.
course: $(VENV)/test.stamp
	$(BIN)/python -m tests.bench.course $(ARGS)

# Five rounds of a thousand visitors: what of them stays.
soak: $(VENV)/test.stamp
	$(BIN)/python -m tests.bench.soak $(ARGS)

# Two replicas behind the real proxy, on this machine: one is killed, then all are upgraded.
deploy-test: $(VENV)/test.stamp
	$(BIN)/python -m tests.deploy $(ARGS)

# The live class: 300 and 3,000 followers, answers, sketches, and two replicas of which one is killed.
class: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tests.bench.classroom $(ARGS)

audit: $(VENV)/test.stamp
	$(BIN)/python -m tools.audit

# Before a change that is to keep every picture, and after it: make pictures ARGS="shoot build/before", then
# ARGS="shoot build/after", then ARGS="compare build/before build/after".
pictures: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.pictures $(ARGS)

# All scenes in Chromium, Safari's engine and Firefox, side by side.
engines: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.engines $(or $(ARGS),build/engines)

# The moving picture of README.md, of the page as it is.
animation: $(VENV)/test.stamp
	$(BROWSER) $(BIN)/python -m tools.animation

accuracy: $(VENV)/test.stamp
	$(BIN)/python -m tests.bench.accuracy_table $(ARGS)

bench: $(VENV)/test.stamp
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m tests.bench.error_vs_time $(ARGS)

# Checks guided walks: make walk FILE=my-walk.toml. With ARGS=--look it also measures each step in a browser, as a hall sees
# it; ARGS=--pictures writes pictures of each step to build/walk; ARGS=--serve also serves the walk.
LOOKS := $(filter --look --pictures --serve,$(ARGS))
walk: $(VENV)/$(if $(LOOKS),test,run).stamp
	$(if $(LOOKS),$(BROWSER)) $(BIN)/python -m tools.walk $(ARGS) $(FILE)

protocol: $(VENV)/test.stamp
	$(BIN)/python -m tools.protocol

readme: $(VENV)/test.stamp
	$(BIN)/python -m tools.readme

# Pins stay as they are unless asked for: make lock ARGS=--upgrade
lock: $(VENV)/test.stamp
	$(LOCK) $(ARGS) pyproject.toml --output-file requirements.txt
	$(LOCK) $(ARGS) pyproject.toml --extra notebook -c requirements.txt --output-file requirements-notebook.txt
	$(LOCK) $(ARGS) requirements-test.in --output-file requirements-test.txt

docker:
	docker build --tag oscillations .

# The lecture behind a proxy: make up REPLICAS=4 SITE=lecture.example
up: secret store-password
	docker compose up --build --wait

# The next version, without anybody noticing: as many replicas stand in while the others are replaced. Where they do not
# come up, the others stay.
upgrade: RELIEVED = docker compose --profile relief rm --stop --force relief
upgrade: secret store-password
	docker compose build lecture
	docker compose --profile relief up --detach --no-deps --wait relief || { $(RELIEVED); exit 1; }
	docker compose up --detach --no-deps --wait lecture
	$(RELIEVED)

# They are mounted as they are: who makes them and the user of the containers, 1000, can read them, nobody else.
secret store-password:
	umask 077 && head -c 32 /dev/urandom | base64 > $@
	chown 1000 $@ 2>/dev/null || setfacl -m u:1000:r $@ 2>/dev/null || { rm $@; \
		echo "Nobody but the user 1000 of the containers may read the file $@: run sudo make $@, or install setfacl."; exit 1; }

# The images of the containers by the digests that their registry has today.
digests:
	$(BIN)/python -m tools.digests

clean:
	rm -rf build node_modules .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	@test ! -e $(OURS) || rm -rf $(VENV)
	@test ! -e $(VENV) || echo "$(VENV) stays: it has no file created-by-make."

# A change of requirements.txt builds the environment again, so that it has no package that is not needed any more. An
# environment that make did not create keeps all that it has.
$(VENV)/run.stamp: requirements.txt
	@test -n "$(PYTHON)" || { echo "Needs Python 3.11, 3.12 or 3.13 with venv: make PYTHON=/path/to/python3.12"; exit 1; }
	@test ! -e $(OURS) || rm -rf $(VENV)
	@test -n "$$(ls -A $(VENV) 2>/dev/null)" || { mkdir -p $(VENV) && touch $(OURS) && $(PYTHON) -m venv $(VENV); }
	@test -x $(BIN)/pip || { echo "$(VENV) is not empty and no virtual environment with pip: make VENV=another"; exit 1; }
	$(INSTALL) -r requirements.txt
	@touch $@

$(VENV)/test.stamp: requirements-test.txt $(VENV)/run.stamp
	$(INSTALL) -r requirements-test.txt
	@touch $@
