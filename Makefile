# fivecheck - build, test, install. `make help` names the targets.

comma := ,
CC ?= cc
SANITIZE ?=
PREFIX ?= /usr/local
DESTDIR ?=
# A compiler or a sanitizer of its own gets a folder of its own: switching never mixes objects.
BUILD ?= build$(patsubst %,-%,$(filter-out cc gcc,$(notdir $(firstword $(CC)))))$(patsubst %,-%,$(subst $(comma),-,$(SANITIZE)))

VERSION := 0.1.0
WARNINGS := -Wall -Wextra -Wconversion -Wshadow -Wvla -Wstrict-prototypes -Wmissing-prototypes -Werror=implicit
OPTIMISE ?= -O3 -g
CFLAGS ?= $(OPTIMISE)
SANITIZE_FLAGS := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer)
XML_FLAGS := $(shell xml2-config --cflags 2>/dev/null || echo -I/usr/include/libxml2)
# HARDEN= leaves the hardening out. FORTIFY needs optimisation and goes ill with sanitizers.
HARDEN ?= $(if $(SANITIZE),,1)
HARDEN_CFLAGS := $(if $(HARDEN),-fstack-protector-strong -fPIE $(if $(filter -O0,$(OPTIMISE)),,-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2))
HARDEN_LDFLAGS := $(if $(HARDEN),-pie -Wl$(comma)-z$(comma)relro$(comma)-z$(comma)now)
# Contraction would make a verdict depend on the compiler. No path of this computer gets into the program.
override CFLAGS += -std=c17 -ffp-contract=off -ffile-prefix-map="$(CURDIR)"=. $(WARNINGS) $(HARDEN_CFLAGS) $(SANITIZE_FLAGS)
override CPPFLAGS += -D_POSIX_C_SOURCE=200809L -DFIVECHECK_VERSION='"$(VERSION)"' -Isrc -I$(BUILD)/gen $(XML_FLAGS)
override LDFLAGS += $(HARDEN_LDFLAGS) $(SANITIZE_FLAGS) -pthread
LDLIBS := -lxml2 -ljansson -lnettle -lm

# make V=1 shows the commands.
Q := $(if $(V),,@)

# Folders may be nested; main.c alone lies in src itself and is not part of the library.
SOURCES := $(sort $(shell find src -mindepth 2 -name '*.c'))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o)
SCHEMAS := $(sort $(shell find src/machine -name '*.rng'))
JSON_SCHEMAS := $(sort $(shell find src/report -name '*.schema.json'))
SCHEMA_HEADERS := $(patsubst %,$(BUILD)/gen/%.h,$(notdir $(SCHEMAS)))
vpath %.rng $(sort $(dir $(SCHEMAS)))
# Compilers at a time in the targets that build before they test.
JOBS ?= $(shell nproc)
UNITS := $(sort $(wildcard tests/unit/test_*.c))
UNIT_PROGRAMS := $(UNITS:tests/unit/%.c=$(BUILD)/tests/%)
MANUALS := $(sort $(wildcard man/*.[1-9]))
PLOTS := $(sort $(wildcard examples/plots/*.gnuplot))
MACHINES := $(sort $(wildcard machines/*/machine.xml))
COMPLETIONS := $(patsubst %,$(BUILD)/completion/fivecheck.%,bash zsh fish)
# Where zsh looks for functions differs: Debian's packages have share/zsh/vendor-completions.
ZSH_FUNCTIONS ?= share/zsh/site-functions
# What install puts below PREFIX, all of it, and uninstall removes.
INSTALLED := bin/fivecheck $(addprefix share/fivecheck/,$(notdir $(SCHEMAS) $(JSON_SCHEMAS) $(PLOTS))) \
	$(foreach m,$(MANUALS),share/man/man$(subst .,,$(suffix $(m)))/$(notdir $(m))) \
	share/bash-completion/completions/fivecheck $(ZSH_FUNCTIONS)/_fivecheck share/fish/vendor_completions.d/fivecheck.fish

all: $(BUILD)/fivecheck $(COMPLETIONS)

$(BUILD)/fivecheck: $(BUILD)/src/main.o $(BUILD)/libfivecheck.a
	@echo '  LD $@'
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/libfivecheck.a: $(OBJECTS)
	@rm -f $@
	@echo '  AR $@'
	$(Q)$(AR) rcs $@ $^

$(BUILD)/%.o: %.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $@'
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c -o $@ $<

# Made from the table of options by the program itself.
$(BUILD)/completion/fivecheck.%: $(BUILD)/fivecheck
	@mkdir -p $(@D)
	$(Q)$(BUILD)/fivecheck completion $* > $@.new && mv $@.new $@

# A schema as a C string: quotes and backslashes escaped, a line a literal.
$(BUILD)/gen/%.rng.h: %.rng
	@mkdir -p $(@D)
	$(Q)sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/^/"/' -e 's/$$/\\n"/' $< > $@

$(OBJECTS): | $(SCHEMA_HEADERS)

$(BUILD)/tests/%: tests/unit/%.c $(BUILD)/libfivecheck.a Makefile
	@mkdir -p $(@D)
	@echo '  CC $@'
	$(Q)$(CC) $(CPPFLAGS) -Itests/unit $(CFLAGS) $(LDFLAGS) -MMD -MP -MF $@.d -o $@ $< $(BUILD)/libfivecheck.a $$(pkg-config --libs check) $(LDLIBS)

# Everything, in an order that lets each step rely on the one before.
check:
	@sh scripts/install-deps
	@$(MAKE) --no-print-directory check-layers check-man
	@$(MAKE) --no-print-directory -j$(JOBS) all build-units
	@$(MAKE) --no-print-directory check-unit check-program check-install check-faults check-machines check-rs274

# What a package's build can afford: nothing is installed or downloaded, and there are no peers.
check-short:
	@$(MAKE) --no-print-directory check-layers check-man all
	@$(MAKE) --no-print-directory check-unit check-program check-machines

check-layers:
	@sh scripts/check-layers

check-man:
	@sh scripts/check-man $(MANUALS)

build-units: $(UNIT_PROGRAMS)

check-unit: $(UNIT_PROGRAMS)
	@status=0; for t in $(UNIT_PROGRAMS); do $$t || status=1; done; exit $$status

# The long form of what check-unit runs in short: 4,000,000 pairs of triangles, 100,000 moving pairs.
STRESS_CASES ?= 20
stress: $(filter $(BUILD)/tests/test_stress_%,$(UNIT_PROGRAMS)) $(BUILD)/tests/test_sweep $(BUILD)/tests/test_boxes
	@status=0; for t in $^; do FIVECHECK_CASES=$(STRESS_CASES) $$t || status=1; done; exit $$status

check-program: $(BUILD)/fivecheck
	@FIVECHECK="$$(realpath $(BUILD)/fivecheck)" sh scripts/run-program-tests $(TESTS)

# Memory, reads and threads that fail; FAULT_RUNS=0 lets every single allocation fail.
check-faults: $(BUILD)/fivecheck $(BUILD)/fault.so
	@if [ -n "$(SANITIZE)" ]; then echo 'check-faults: skipped, a sanitizer has an allocator of its own'; else \
		sh scripts/check-faults $(abspath $(BUILD)/fivecheck) $(abspath $(BUILD)/fault.so); fi

$(BUILD)/fault.so: tests/fault/fault.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $@'
	$(Q)$(CC) -std=c17 -O2 $(WARNINGS) -shared -fPIC -o $@ $< -ldl

check-machines: $(BUILD)/fivecheck
	@sh scripts/check-machines
	@for m in $(MACHINES); do echo "$$m"; $(BUILD)/fivecheck --check-machine -o /dev/null $$m || exit 1; done

# Against LinuxCNC's interpreter; skipped where it is neither found nor to be downloaded.
check-rs274: $(BUILD)/fivecheck
	@sh scripts/check-rs274 $(abspath $(BUILD)/fivecheck) $(abspath $(BUILD)/rs274) $(RS274_OPTIONS)

# The unit and program tests in builds of their own that watch memory and threads; FIVECHECK_CASES=1 tries as many
# random cases as check does. Threads are started by the program alone.
check-asan:
	@$(MAKE) --no-print-directory -j$(JOBS) SANITIZE=address,undefined all build-units
	@FIVECHECK_CASES=$${FIVECHECK_CASES:-0.1} CK_TIMEOUT_MULTIPLIER=$${CK_TIMEOUT_MULTIPLIER:-10} \
		$(MAKE) --no-print-directory SANITIZE=address,undefined -k check-unit check-program

check-tsan:
	@$(MAKE) --no-print-directory -j$(JOBS) SANITIZE=thread all
	@$(MAKE) --no-print-directory SANITIZE=thread check-program

check-valgrind: $(BUILD)/fivecheck $(UNIT_PROGRAMS)
	@sh scripts/check-valgrind $(BUILD)

# What looks closer than check does and takes longer: a quarter of an hour, together with the fuzzers' minute each.
LONG_CHECKS := lint check-asan check-tsan check-valgrind fuzz
check-long:
	@sh scripts/install-deps long
	@$(MAKE) --no-print-directory -k $(LONG_CHECKS)

# Line coverage of src by the unit and program tests, at least 95 percent; COVERAGE_ROWS of the worst files are shown, all are in the folder.
coverage:
	@FIVECHECK_CASES=0.1 $(MAKE) --no-print-directory BUILD=build-coverage HARDEN= OPTIMISE='-O1 -g --coverage' \
		check-unit check-program
	@sh scripts/coverage build-coverage

lint: $(SCHEMA_HEADERS)
	@sh scripts/lint $(BUILD) $(CPPFLAGS)

# Needs clang; objects of its own. FUZZ_SECONDS each (60), FUZZ="stl machine ..." only some of them.
FUZZERS := $(patsubst tests/fuzz/%.c,$(BUILD)/%,$(sort $(wildcard tests/fuzz/fuzz_*.c)))
fuzz:
	@$(MAKE) --no-print-directory -j$(JOBS) CC=clang BUILD=build-fuzz SANITIZE=fuzzer-no-link,address,undefined build-fuzzers
	@sh scripts/fuzz build-fuzz $(FUZZ)

build-fuzzers: $(FUZZERS)

$(BUILD)/fuzz_%: tests/fuzz/fuzz_%.c tests/fuzz/fuzz.h $(BUILD)/libfivecheck.a Makefile
	@echo '  CC $@'
	$(Q)$(CC) $(CPPFLAGS) -DFUZZ_MACHINE='"machines/ac-trunnion/machine.xml"' \
		-DFUZZ_SETUP='"examples/ac-trunnion/setup.xml"' $(CFLAGS) $(LDFLAGS) -fsanitize=fuzzer -o $@ $< \
		$(BUILD)/libfivecheck.a $(LDLIBS)

# Random machines and programs against FCL; a case in which they disagree is kept in $(BUILD)/campaign.
campaign:
	@sh scripts/install-deps campaign
	@$(MAKE) --no-print-directory all
	@CXX="$(CXX)" sh scripts/campaign run_campaign $(BUILD) $(BUILD)/fivecheck $(BUILD)/campaign $(CAMPAIGN_OPTIONS)

# FCL's own flags ask for an older C++.
CAMPAIGN := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard tests/campaign/*.cpp)))
PEER_FLAGS = $$(pkg-config --cflags fcl jansson) -std=c++17 -O2 -Wall -Wextra -Wshadow -MMD -MP
PEER_LIBS = $$(pkg-config --libs fcl jansson)

$(BUILD)/tests/%.o: tests/%.cpp Makefile
	@mkdir -p $(@D)
	@echo '  CXX $@'
	$(Q)$(CXX) $(PEER_FLAGS) -c -o $@ $<

$(BUILD)/tests/run_campaign: $(CAMPAIGN)
	@echo '  LD $@'
	$(Q)$(CXX) -o $@ $^ $(PEER_LIBS)

# Awkward triangles and encounters, the truth, FCL's answers, and fivecheck's: the tables of tests/stress/README.md.
stress-table:
	@sh scripts/install-deps campaign >&2
	@CXX="$(CXX)" sh scripts/campaign stress_table $(BUILD)

$(BUILD)/tests/stress_table: tests/stress/stress_table.c $(BUILD)/tests/stress/fcl_answer.o $(BUILD)/libfivecheck.a
	@echo '  CC $@'
	$(Q)$(CC) $(CPPFLAGS) -Itests/unit $(CFLAGS) -MMD -MP -MF $@.d -c -o $@.o $<
	$(Q)$(CXX) $(LDFLAGS) -o $@ $@.o $(BUILD)/tests/stress/fcl_answer.o $(BUILD)/libfivecheck.a \
		$$(pkg-config --libs fcl check) $(LDLIBS)

# Run time against error, and against the peers: half an hour, on a quiet computer. The figures go to $(BUILD)/bench.
bench:
	@sh scripts/install-deps bench
	@$(MAKE) --no-print-directory all
	@CC="$(CC)" CXX="$(CXX)" sh scripts/bench $(abspath $(BUILD)) $(BENCH_OPTIONS)

# The proof against the truth, on small scenes; judges no times.
bench-quick:
	@sh scripts/install-deps build
	@$(MAKE) --no-print-directory all
	@CC="$(CC)" sh scripts/bench $(abspath $(BUILD)) --quick $(BENCH_OPTIONS)

demo:
	@sh scripts/install-deps build
	@$(MAKE) --no-print-directory all
	@sh scripts/demo $(BUILD)/fivecheck

install: all
	sh scripts/install "$(BUILD)" "$(DESTDIR)$(PREFIX)" $(INSTALLED)

uninstall:
	sh scripts/install --remove "$(DESTDIR)$(PREFIX)" $(INSTALLED)

# What install puts is there, works, and is gone after uninstall.
check-install: all
	@sh scripts/check-install "$(BUILD)"

# Two builds in folders of their own have the same bytes.
check-reproducible:
	@sh scripts/check-reproducible

# The Debian package of the last commit, and lintian's opinion of it (debhelper, lintian).
check-deb:
	@sh scripts/check-deb

# The last commit as an archive that is the same wherever it is made.
DIST := fivecheck-$(VERSION)
dist:
	@mkdir -p $(BUILD)
	@git diff --quiet HEAD || echo 'dist: changes that are not committed are left out' >&2
	@git -c tar.umask=0022 archive --format=tar --prefix=$(DIST)/ -o $(BUILD)/$(DIST).tar HEAD
	@gzip -9nf $(BUILD)/$(DIST).tar
	@echo '$(BUILD)/$(DIST).tar.gz'

clean:
	rm -rf $(BUILD)

help:
	@echo 'make                 build $(BUILD)/fivecheck'
	@echo 'make demo            build, then check a clear and a colliding program'
	@echo 'make check           layers, manual pages, unit tests, program tests, machines'
	@echo 'make check-layers    and check-man check-unit check-program check-install check-faults check-machines check-rs274:'
	@echo '                     one of them'
	@echo '                     (check-program TESTS="name ...": some of the program tests;'
	@echo '                     check-rs274 RS274_OPTIONS="--seed 1 --blocks 100000")'
	@echo 'make stress          awkward geometry at length (STRESS_CASES=20 times what check does, FIVECHECK_SEED=n)'
	@echo 'make check-asan      and check-tsan check-valgrind: the tests in builds that watch memory and threads'
	@echo 'make check-long      all of $(LONG_CHECKS)'
	@echo 'make coverage        and lint: lines of src that the tests reach; clang-tidy and cppcheck'
	@echo 'make fuzz            fuzzers on programs, machines, setups, STL (clang; FUZZ_SECONDS=60 each, FUZZ="stl ...")'
	@echo 'make bench           run time against error and against peers, into $(BUILD)/bench; half an hour'
	@echo '                     (BENCH_OPTIONS="--only targets --runs 3", BENCH_REAL=folder)'
	@echo 'make bench-quick     its correctness alone, in less than two minutes'
	@echo 'make campaign        random machines and programs against FCL (CAMPAIGN_OPTIONS="--seed 7 --cases 2000")'
	@echo 'make stress-table    awkward geometry, what FCL answers, and what fivecheck does: tests/stress/README.md'
	@echo 'make install         to PREFIX ($(PREFIX)), below DESTDIR; make uninstall takes it away; make check-install tries'
	@echo 'make dist            the last commit as $(BUILD)/$(DIST).tar.gz'
	@echo 'make check-reproducible   two builds in different folders have the same bytes'
	@echo 'make check-deb       the Debian package builds, from the last commit, and passes lintian'
	@echo 'make check-short     the tests of a Debian package: no network, no peers'
	@echo 'make clean           removes $(BUILD)'
	@echo 'make help            this'
	@echo 'Variables: CC=clang, HARDEN=, SANITIZE=address,undefined, BUILD=folder, OPTIMISE="-O3 -g", V=1, NO_INSTALL=1.'
	@echo 'bench, campaign, demo and check install missing Debian packages, as root or with passwordless sudo only.'

.PHONY: all bench bench-quick build-fuzzers build-units campaign fuzz check check-asan check-deb check-faults check-long check-tsan check-valgrind coverage lint check-layers check-man check-unit check-program check-install check-machines check-reproducible check-rs274 check-short demo dist install stress stress-table uninstall clean help

-include $(OBJECTS:.o=.d) $(CAMPAIGN:.o=.d) $(BUILD)/tests/stress/fcl_answer.d $(BUILD)/tests/stress_table.d $(BUILD)/src/main.d $(UNIT_PROGRAMS:=.d)
