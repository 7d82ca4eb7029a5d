# make           set up everything, write and compile the PUMA 560's kernels, show the counts
# make test      set up everything, run the tests that a change needs at once; make test-all: what CI runs
# make help      the rest

PYTHON ?= python3
ROBOT ?= puma560.yaml
WORKERS ?= 2
EXTRAS ?= test,lint
AXE := 4.14.1

VENV := .venv
PEERS := .venv-peers
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check --no-input install --quiet --quiet
# The tests of a file stay together: what they share is computed once. Who is done first takes from the others.
PYTEST := $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal

SHELL := /bin/sh
.DELETE_ON_ERROR:
.SUFFIXES:
.NOTPARALLEL:

.PHONY: kernels
kernels: $(VENV)/.installed
	@$(BIN)/robodyn gen $(ROBOT) --compile

.PHONY: test
test: $(VENV)/.installed-dev
	$(PYTEST)

.PHONY: test-all
test-all: $(VENV)/.installed-dev  ## what `make test` runs, and all further cases: what CI runs
	$(PYTEST) -m "not slow"

.PHONY: prove-all
prove-all: $(VENV)/.installed-dev  ## the long comparisons that `make test-all` leaves out
	@$(PIP) 'atheris>=2.3' || echo "no atheris for this Python: the robot files are not fuzzed" >&2
	$(PYTEST) -m slow -rP

.PHONY: generated
generated: $(VENV)/.installed  ## write the kernels of all bundled robots into generated/, and robodyn.lock
	@$(BIN)/robodyn build

.PHONY: generated-check
generated-check: $(VENV)/.installed  ## fail where generated/ is not what would be written, or a count got worse
	@$(BIN)/robodyn build --check

.PHONY: flops-record
flops-record: $(VENV)/.installed  ## prove the shipped records; fail where what fast takes got worse
	$(BIN)/python benchmarks/flops_record.py $(UPDATE)

.PHONY: mutants
mutants: $(VENV)/.installed-dev  ## change single operators and numbers, and say which of it no test notices
	$(BIN)/python benchmarks/mutants.py $(MUTANTS)

.PHONY: benchmarks
benchmarks: $(PEERS)/.peers  ## race our kernels against their peers; writes benchmarks/results/
	$(PEERS)/bin/python -m benchmarks.peers $(BENCHMARKS)

.PHONY: tutorials
tutorials: $(VENV)/.installed-dev  ## follow the tutorials literally, in a fresh environment with a home of its own
	$(BIN)/python -m pytest -m thorough tests/documents/test_tutorials.py

.PHONY: docs
docs: $(VENV)/.installed-docs  ## build the documentation site into build/site; a warning is an error
	@NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict --quiet
	@echo "build/site/index.html opens without a server"

.PHONY: lint
lint: $(VENV)/.installed-dev  ## ruff and mypy
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

.PHONY: format
format: $(VENV)/.installed-dev  ## let ruff mend what it can
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

.PHONY: axe
axe:  ## axe-core from npm: with it the tests of pages look for what is not accessible
	@npm install --loglevel=error --no-update-notifier --no-audit --no-fund --no-save --prefix build/npm axe-core@$(AXE)

.PHONY: clean
clean:  ## remove the environment, build outputs and caches; generated/ stays
	rm -rf $(VENV) $(PEERS) build dist .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find benchmarks cli codegen tests -name __pycache__ -type d -prune -exec rm -rf {} +

.PHONY: help
help:
	@echo "make                  set up everything, write and compile the kernels of $(ROBOT), show the counts"
	@echo "make test             set up everything, run the tests"
	@sed -n 's/^\([a-z-]*\):.*  ## \(.*\)/make \1|\2/p' $(MAKEFILE_LIST) | awk -F'|' '{printf "%-21s %s\n", $$1, $$2}'
	@echo "Variables: PYTHON=$(PYTHON) (3.11 or newer), ROBOT=$(ROBOT), WORKERS=$(WORKERS) (tests at a time)"

# The environment. Debian's python3 comes without ensurepip, which `venv` needs; there pip itself fills the gap.

$(VENV)/.created:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	    echo "robodyn needs Python 3.11 or newer, and $(PYTHON) is $$($(PYTHON) --version 2>&1);" \
	        "name another with: make PYTHON=python3.12" >&2; exit 1; }
	@echo "Setting up $(VENV), once" >&2
	@rm -rf $(VENV)
	@$(PYTHON) -m venv $(VENV) >/dev/null 2>&1 \
	    || { $(PYTHON) -m venv --clear --without-pip $(VENV) \
	         && $(PYTHON) -m pip --disable-pip-version-check --python $(VENV)/bin/python install --quiet --quiet pip; } \
	    || { rm -rf $(VENV); \
	         echo "Could not set up $(VENV); on Debian and Ubuntu: apt-get install python3-venv python3-pip" >&2; exit 1; }
	@touch $@

# The peers are optional, one by one: what cannot be installed is named in the results.
$(PEERS)/.peers: pyproject.toml benchmarks/peers/requirements.txt
	@$(MAKE) --no-print-directory VENV=$(PEERS) $(PEERS)/.created
	@$(PEERS)/bin/python -m pip --disable-pip-version-check --no-input install --quiet --quiet --editable .
	@grep -v '^#' benchmarks/peers/requirements.txt | while read -r peer; do \
	    $(PEERS)/bin/python -m pip --disable-pip-version-check --no-input install --quiet --quiet "$$peer" \
	        || echo "$$peer cannot be installed; it will not race" >&2; done
	@touch $@

$(VENV)/.installed: pyproject.toml $(VENV)/.created
	@$(PIP) --editable .
	@touch $@

$(VENV)/.installed-dev: pyproject.toml $(VENV)/.created
	@echo "Installing robodyn with what its tests need" >&2
	@$(PIP) --editable '.[$(EXTRAS)]'
	@touch $@ $(VENV)/.installed

$(VENV)/.installed-docs: pyproject.toml $(VENV)/.created
	@echo "Installing robodyn with what its documentation site needs" >&2
	@$(PIP) --editable '.[docs]'
	@touch $@ $(VENV)/.installed
