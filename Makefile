# Thin front for the common tasks. Each installs the Debian packages it needs (.ci/setup) and says so.
.PHONY: help build module test demo install bench format lint asan compat
.DEFAULT_GOAL := help

help:           ## this list
	@sed -n 's|^\([a-z]*\):[a-z ]*## |  make \1\t|p' $(MAKEFILE_LIST)

build:          ## the core, the program, the Python module in workbench/osculate
	.ci/setup build test freecad
	cmake --preset release
	cmake --build --preset release

module:         ## the Python module alone
	.ci/setup build test freecad
	cmake --preset release
	cmake --build --preset release --target _core

test: build asan        ## everything: core under the sanitizers, Python, program, FreeCAD, GUI, consumer, demo
	.ci/setup gui
	ctest --preset release -j$(shell nproc)

demo: module    ## analyses real models; report, JSON, CSV, FCStd and picture in demo-output/
	.ci/setup gui
	resources/demo/run demo-output

install: module ## the add-on into FreeCAD's Mod folder, or into PREFIX=<folder of the add-on>
	.ci/install-addon build/release $(PREFIX)

bench:          ## timings beside those of OpenCASCADE, and of a report from Python
	.ci/setup build freecad bench
	cmake --preset bench
	cmake --build --preset bench
	.ci/bench build/bench

format:         ## rewrites the C++ sources in the project's format
	.ci/setup format
	git ls-files '*.h' '*.cpp' | xargs clang-format -i

lint:           ## format, clang-tidy, flake8, every public header on its own
	.ci/setup build test freecad lint
	cmake --preset default
	.ci/lint build/default

asan:           ## the core's tests under AddressSanitizer and UndefinedBehaviorSanitizer
	.ci/setup build test asan
	cmake --preset asan
	cmake --build --preset asan
	ctest --preset asan -j$(shell nproc)

compat:         ## build and test inside Debian 13 and Debian sid (needs root for chroot)
	.ci/setup compat
	.ci/compat trixie sid
