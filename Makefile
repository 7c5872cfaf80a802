# make demo and make test set up everything themselves, in a virtual environment in .venv.
PYTHON ?= $(shell for p in python3.13 python3.12 python3.11 python3 python; do \
	command -v $$p >/dev/null 2>&1 && $$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	>/dev/null 2>&1 && { echo $$p; break; }; done)
VENV := .venv
BIN := $(VENV)/bin
OUT ?= out
# what is installed beside segfmu; .ci/run installs all that it needs at once
EXTRAS ?= dev

.PHONY: help demo quick test interpreted lint examples pictures docs bench fuzz fmus check-platforms \
	generate golden lock wheel check-wheel release clean
.DEFAULT_GOAL := demo

$(VENV)/installed: pyproject.toml setup.py requirements-dev.lock \
		$(wildcard src/segfmu/kernels/c/* src/segfmu/cosim/c/*)
	@test -n "$(PYTHON)" || { echo "segfmu needs Python 3.11 or newer; none was found"; exit 1; }
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@# a module of an older build would be found first
	@rm -f src/segfmu/kernels/_compiled.cpython-* src/segfmu/kernels/_compiled.cp3*
	@rm -f src/segfmu/cosim/_loop.cpython-* src/segfmu/cosim/_loop.cp3*
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint requirements-dev.lock --editable '.[$(EXTRAS)]'
	@$(BIN)/python -c "from segfmu.kernels.backend import COMPILED; \
		COMPILED or print('note: no C compiler found; the kernels run interpreted, only slower')"
	@touch $@

help: ## this list
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)$$/\1@\2/p' $(MAKEFILE_LIST) | \
		awk -F@ '{ printf "make %-16s %s\n", $$1, $$2 }'

demo: $(VENV)/installed ## plan, invert, pack, co-simulate and judge the paper's mission
	$(BIN)/segfmu plan models/paper.toml --output $(OUT)
	$(BIN)/segfmu simulate models/paper.toml --output $(OUT)

# the tests that fail for most mistakes in kernels, planner, crane, FMUs and generated files
QUICK := tests/codegen tests/golden tests/property tests/kernels/test_backend.py \
	tests/kernels/numerics tests/kernels/crane tests/planning tests/fmu/standard/test_description.py \
	tests/test_layers.py tests/validation/files/test_crane_file.py \
	tests/validation/files/test_files.py::test_reference_page_is_that_of_the_models

# workers on all cores; one that is done takes over tests of the others
PYTEST := $(BIN)/python -m pytest -q -n auto --dist worksteal

quick: $(VENV)/installed ## the tests that fail for most mistakes, in half a minute
	$(PYTEST) $(QUICK)

test: $(VENV)/installed ## all tests, on all cores
	$(PYTEST)

interpreted: $(VENV)/installed ## some tests on the interpreted kernels, as where no C compiler is
	SEGFMU_INTERPRETED=1 $(PYTEST) -m interpreted

lint: $(VENV)/installed ## static checks
	$(BIN)/ruff check .
	$(BIN)/mypy

examples: $(VENV)/installed ## run every example
	@set -e; for example in examples/[0-9]*.py; do echo "$$example"; $(BIN)/python $$example; done
	@set -e; for notebook in examples/[0-9]*.ipynb; do \
		echo "$$notebook"; $(BIN)/jupyter-execute $$notebook; done

pictures: $(VENV)/installed ## pictures of tutorial and reports in the documentation; needs Chromium
	$(BIN)/python -m tests.tutorial
	$(BIN)/python -m tests.validation.report.pictures docs/images

$(VENV)/installed-docs: $(VENV)/installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint requirements-dev.lock --editable '.[dev,docs]'
	@touch $@

docs: $(VENV)/installed-docs ## the documentation site, into out/site
	$(BIN)/sphinx-build -W --keep-going -q docs $(OUT)/site

$(VENV)/installed-bench: $(VENV)/installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint requirements-dev.lock --editable '.[dev,bench]'
	@touch $@

bench: $(VENV)/installed-bench ## measure beside the peers; BENCH="--quick --only a,b"
	$(BIN)/python -m benchmarks --output $(OUT)/benchmarks.json $(BENCH)

fuzz: $(VENV)/installed ## a million random call sequences against each native FMU, with sanitizers
	$(BIN)/python -m tests.fmu.native.fuzz

$(VENV)/installed-platforms: $(VENV)/installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint requirements-dev.lock --editable '.[dev,platforms]'
	@touch $@

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
