# make demo and make test set up everything themselves, in a virtual environment in .venv.
ifndef PYTHON
PYTHON := $(shell for p in python3.13 python3.12 python3.11 python3 python; do \
	command -v $$p >/dev/null 2>&1 && $$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	>/dev/null 2>&1 && { echo $$p; break; }; done)
export PYTHON
endif
comma := ,
VENV := .venv
BIN := $(VENV)/bin
OUT ?= out
# extras of pyproject.toml that are installed for tests
EXTRAS ?= dev
PIP = $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile \
	--constraint requirements-dev.lock
# uv installs in a third of pip's time; pip, where there is none or it fails
INSTALL = install() { $(BIN)/uv pip install --quiet --no-cache --system-certs --python $(BIN)/python \
	--constraint requirements-dev.lock "$$@" 2> /dev/null || $(PIP) "$$@"; }; install

.PHONY: help demo planned quick test soak interpreted lint examples pictures docs bench fuzz fmus check-platforms \
	generate golden lock wheel check-wheel release clean
.DEFAULT_GOAL := demo

# what pyproject.toml asks for: for the package alone, or for extras
define REQUIREMENTS
import sys, tomllib
project = tomllib.load(open("pyproject.toml", "rb"))["project"]
extras = [project["optional-dependencies"][name] for name in sys.argv[1:]]
print(*(sum(extras, []) if extras else project["dependencies"]), sep="\n")
endef
export REQUIREMENTS

# the library of an FMU, into the cache where its build looks for it
define LIBRARY
import sys
from segfmu.fmu.native.archive import sources
from segfmu.fmu.native.binaries import binary
from segfmu.fmu.native.compilers import host
binary(sys.argv[1], sources(sys.argv[1], 2), host())
endef
export LIBRARY

# modules that commands load
LOADED := fmpy, matplotlib.backends.backend_agg, scipy.linalg, segfmu.cli, segfmu.cosim, \
	segfmu.validation.plots, segfmu.validation.report, segfmu.validation.runs

FOR_PACKAGE := pyproject.toml requirements-dev.lock
FOR_KERNELS := pyproject.toml setup.py $(wildcard src/segfmu/kernels/c/* src/segfmu/cosim/c/*)

# the package and what it needs to run: one core compiles the kernels while the other one installs
$(VENV)/package: $(FOR_PACKAGE) $(FOR_KERNELS) | $(BIN)/python
	@$(MAKE) --no-print-directory --jobs 2 $(VENV)/compiled $(VENV)/loaded
	@touch $@

$(BIN)/python:
	@test -n "$(PYTHON)" || { echo "segfmu needs Python 3.11 or newer; none was found"; exit 1; }
	@# By the pip of that Python, where it has one: venv takes longer to unpack its own. uv knows no
	@# settings of pip: where these name other places of packages, pip installs everything.
	@$(PYTHON) -m venv --without-pip $(VENV)
	@uv=$$($(PYTHON) -m pip config list 2> /dev/null | grep -Eq 'index|find-links' || echo uv); \
		$(PYTHON) -m pip --python $@ install --quiet --disable-pip-version-check --no-compile \
		--only-binary :all: --constraint requirements-dev.lock pip $$uv 2> /dev/null || \
		$(PYTHON) -m venv $(VENV)

$(VENV)/required: $(FOR_PACKAGE)
	@$(BIN)/python -c "$$REQUIREMENTS" > $@.txt
	@$(INSTALL) --requirement $@.txt
	@touch $@

# bytecode of what the first commands load, written while the kernels compile
$(VENV)/loaded: $(VENV)/required
	@PYTHONDONTWRITEBYTECODE= PYTHONPATH=src SEGFMU_INTERPRETED=1 $(BIN)/python -c "import $(LOADED)"
	@touch $@

$(VENV)/compiled: $(FOR_KERNELS)
	@# a module of an older build would be found first
	@rm -f src/segfmu/kernels/_compiled.cpython-* src/segfmu/kernels/_compiled.cp3*
	@rm -f src/segfmu/cosim/_loop.cpython-* src/segfmu/cosim/_loop.cp3*
	@# uv would lock the environment meanwhile
	@$(PIP) --no-deps --editable .
	@$(BIN)/python -c "from importlib.util import find_spec; find_spec('segfmu.kernels._compiled') or \
		print('note: no C compiler found; the kernels run interpreted, only slower')"
	@touch $@

# where it cannot be done, the demo tells why
$(VENV)/library-%: $(VENV)/required $(FOR_KERNELS)
	@PYTHONPATH=src SEGFMU_INTERPRETED=1 $(BIN)/python -c "$$LIBRARY" $* 2> /dev/null || true
	@touch $@

# further packages
$(VENV)/installed: EXTRA = $(EXTRAS)
$(VENV)/installed-docs: EXTRA = dev,docs
$(VENV)/installed-bench: EXTRA = dev,bench
$(VENV)/installed-platforms: EXTRA = dev,platforms
EXTENDED := $(addprefix $(VENV)/installed,-docs -bench -platforms)
$(EXTENDED): $(VENV)/installed
$(VENV)/installed $(EXTENDED): $(VENV)/package
	@$(BIN)/python -c "$$REQUIREMENTS" $(subst $(comma), ,$(EXTRA)) > $@.txt
	@$(INSTALL) --requirement $@.txt
	@# at once on all cores, without their tests; warnings on the sources of others are not for ours
	@$(BIN)/python -W ignore -m compileall -qq -j 0 -x '/site-packages/.*/tests/' $(VENV) || true
	@touch $@

help: ## this list
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)$$/\1@\2/p' $(MAKEFILE_LIST) | \
		awk -F@ '{ printf "make %-16s %s\n", $$1, $$2 }'

# the library that takes longer first; to plan needs none
demo: | $(BIN)/python ## plan, invert, pack, co-simulate and judge the paper's mission
	@$(MAKE) --no-print-directory --jobs 2 $(VENV)/library-GantryFeedforward $(VENV)/library-GantryCrane planned
	@touch $(VENV)/package
	$(BIN)/segfmu simulate models/paper.toml --output $(OUT)

planned: $(VENV)/compiled $(VENV)/loaded
	$(BIN)/segfmu plan models/paper.toml --output $(OUT)

# the tests that fail for most mistakes in kernels, planner, crane, FMUs and generated files
QUICK := tests/golden tests/property tests/kernels/test_backend.py \
	tests/kernels/numerics tests/kernels/crane tests/planning tests/fmu/standard/test_description.py \
	tests/test_layers.py tests/validation/files/test_crane_file.py \
	tests/validation/files/test_files.py::test_reference_page_is_that_of_the_models

# Workers on all cores; one that is done takes over tests of the others. Threads of OpenBLAS would
# wait for cores that other workers have. Tests start hundreds of commands, whose modules are kept
# compiled also where the environment, as that of many containers, asks for the opposite.
PYTEST := PYTHONDONTWRITEBYTECODE= OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -q -n auto --dist worksteal

# what generated files are made from and by, and the files
TRANSLATED := $(shell find src/segfmu/kernels src/segfmu/codegen src/segfmu/crane tests/codegen \
	-name '*.py' -o -name '*.[ch]' -o -name '*.pyi') requirements-dev.lock

quick: $(VENV)/installed ## the tests that fail for most mistakes, without long ones; translates what has changed
	@$(MAKE) --no-print-directory $(VENV)/translated
	$(PYTEST) -m "not long and not soak" $(QUICK)

$(VENV)/translated: $(TRANSLATED)
	$(PYTEST) tests/codegen
	@touch $@

test: $(VENV)/installed ## all tests, on all cores
	$(PYTEST)

soak: $(VENV)/installed ## the random campaigns of the tests, with 2 to 100 times as many problems
	SEGFMU_SOAK=1 $(PYTEST) -m soak

interpreted: $(VENV)/installed ## some tests on the interpreted kernels, as where no C compiler is
	@# of the files that have some: to collect all would take as long as many of them
	SEGFMU_INTERPRETED=1 $(PYTEST) -m interpreted $$(grep -rl --include='*.py' mark.interpreted tests)

lint: $(VENV)/installed ## static checks
	$(BIN)/ruff check .
	$(BIN)/mypy

examples: $(VENV)/installed ## run every example
	@set -e; for example in examples/[0-9]*.py; do echo "$$example"; $(BIN)/python $$example; done
	@set -e; for notebook in examples/[0-9]*.ipynb; do \
		echo "$$notebook"; $(BIN)/jupyter-execute $$notebook; done

pictures: $(VENV)/installed ## pictures of tutorial, reports and pages in the documentation; needs Chromium
	$(BIN)/python -m tests.tutorial
	$(BIN)/python -m tests.validation.report.pictures docs/images
	$(BIN)/python -m tests.validation.live.picture docs/images

docs: $(VENV)/installed-docs ## the documentation site, into out/site
	$(BIN)/sphinx-build -W --keep-going -q docs $(OUT)/site

bench: $(VENV)/installed-bench ## measure beside the peers; BENCH="--quick --only a,b"
	$(BIN)/python -m benchmarks --output $(OUT)/benchmarks.json $(BENCH)

fuzz: $(VENV)/installed ## random call sequences against each native FMU: a million with sanitizers, 500 in Valgrind
	$(BIN)/python -m tests.fmu.native.fuzz
	$(BIN)/python -m tests.fmu.native.fuzz --memcheck --sequences 500

fmus: $(VENV)/installed-platforms ## both FMUs, FMI 2 and 3, with the binaries of all platforms
	$(BIN)/segfmu build --platforms all --output fmus/dist/fmi2
	$(BIN)/segfmu build --platforms all --fmi 3 --output fmus/dist/fmi3

check-platforms: $(VENV)/installed-platforms ## run binaries under Wine and qemu, where installed
	$(BIN)/python -m tests.fmu.native.platforms
	$(BIN)/python -m tests.fmu.native.foreign

generate: $(VENV)/installed ## write the generated files again
	SEGFMU_INTERPRETED=1 $(BIN)/python -m segfmu.codegen
	$(BIN)/python -m segfmu.fmu.modelica models/modelica
	$(BIN)/python -m segfmu.validation.files.reference docs/mission-reference.md

golden: $(VENV)/installed ## write the golden files again
	SEGFMU_UPDATE_GOLDEN=1 $(BIN)/python -m pytest -q tests/golden

lock: $(VENV)/installed ## update the packages of all extras and write the lock file again
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --upgrade \
		--upgrade-strategy eager --editable '.[dev,docs,bench,platforms]'
	$(BIN)/python -m pip freeze --exclude-editable > requirements-dev.lock

wheel: $(VENV)/installed-platforms ## source distribution and wheel with all binaries, into dist/
	$(BIN)/python -m segfmu.fmu.native.prebuild
	rm -rf build
	$(BIN)/python -m build --sdist --outdir dist
	$(BIN)/python -m build --wheel --outdir dist

release: $(VENV)/installed-platforms ## both distributions into dist/, checked; nothing is uploaded
	$(BIN)/python -m tests.release
	$(BIN)/python -m tests.wheel --keep dist $(PYTHONS)

check-wheel: $(VENV)/installed-platforms ## install the wheel elsewhere and run its commands; PYTHONS="..."
	$(BIN)/python -m tests.wheel $(PYTHONS)

clean: ## remove the environment and all that was built
	rm -rf $(VENV) $(OUT) build dist
