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
OPTIMISE ?= -O2 -g
CFLAGS ?= $(OPTIMISE)
SANITIZE_FLAGS := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer)
XML_FLAGS := $(shell xml2-config --cflags 2>/dev/null || echo -I/usr/include/libxml2)
# Contraction would make a verdict depend on the compiler.
override CFLAGS += -std=c17 -ffp-contract=off $(WARNINGS) $(SANITIZE_FLAGS)
override CPPFLAGS += -D_POSIX_C_SOURCE=200809L -DFIVECHECK_VERSION='"$(VERSION)"' -Isrc -I$(BUILD)/gen $(XML_FLAGS)
override LDFLAGS += $(SANITIZE_FLAGS) -pthread
LDLIBS := -lxml2 -ljansson -lnettle -lm

# make V=1 shows the commands.
Q := $(if $(V),,@)

SOURCES := $(sort $(wildcard src/*/*.c))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o)
SCHEMAS := $(sort $(wildcard src/machine/*.rng))
SCHEMA_HEADERS := $(SCHEMAS:src/machine/%.rng=$(BUILD)/gen/%.rng.h)
UNITS := $(sort $(wildcard tests/unit/test_*.c))
UNIT_PROGRAMS := $(UNITS:tests/unit/%.c=$(BUILD)/tests/%)
MANUALS := $(sort $(wildcard man/*.[1-9]))
MACHINES := $(sort $(wildcard machines/*/machine.xml))

all: $(BUILD)/fivecheck

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

# A schema as a C string: quotes and backslashes escaped, a line a literal.
$(BUILD)/gen/%.rng.h: src/machine/%.rng
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
	@$(MAKE) --no-print-directory all
	@$(MAKE) --no-print-directory check-unit check-program check-machines check-rs274

check-layers:
	@sh scripts/check-layers

check-man:
	@sh scripts/check-man $(MANUALS)

check-unit: $(UNIT_PROGRAMS)
	@status=0; for t in $(UNIT_PROGRAMS); do $$t || status=1; done; exit $$status

check-program: $(BUILD)/fivecheck
	@FIVECHECK="$$(realpath $(BUILD)/fivecheck)" sh scripts/run-program-tests $(TESTS)

check-machines: $(BUILD)/fivecheck
	@sh scripts/check-machines
	@for m in $(MACHINES); do echo "$$m"; $(BUILD)/fivecheck --check-machine -o /dev/null $$m || exit 1; done

# Against LinuxCNC's interpreter; skipped where it is neither found nor to be downloaded.
check-rs274: $(BUILD)/fivecheck
	@sh scripts/check-rs274 $(abspath $(BUILD)/fivecheck) $(abspath $(BUILD)/rs274) $(RS274_OPTIONS)

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
	install -d "$(DESTDIR)$(PREFIX)/bin" "$(DESTDIR)$(PREFIX)/share/fivecheck"
	install -m 755 $(BUILD)/fivecheck "$(DESTDIR)$(PREFIX)/bin/fivecheck"
	install -m 644 $(SCHEMAS) "$(DESTDIR)$(PREFIX)/share/fivecheck"
	for m in $(MANUALS); do s=$${m##*.}; install -d "$(DESTDIR)$(PREFIX)/share/man/man$$s" && \
		install -m 644 $$m "$(DESTDIR)$(PREFIX)/share/man/man$$s" || exit 1; done

uninstall:
	rm -f "$(DESTDIR)$(PREFIX)/bin/fivecheck"
	rm -f $(SCHEMAS:src/machine/%="$(DESTDIR)$(PREFIX)/share/fivecheck/%")
	-rmdir "$(DESTDIR)$(PREFIX)/share/fivecheck"
	for m in $(MANUALS); do rm -f "$(DESTDIR)$(PREFIX)/share/man/man$${m##*.}/$${m##*/}"; done

clean:
	rm -rf $(BUILD)

help:
	@echo 'make                 build $(BUILD)/fivecheck'
	@echo 'make demo            build, then check a clear and a colliding program'
	@echo 'make check           layers, manual pages, unit tests, program tests, machines'
	@echo 'make check-layers    and check-man check-unit check-program check-machines check-rs274: one of them'
	@echo '                     (check-program TESTS="name ...": some of the program tests;'
	@echo '                     check-rs274 RS274_OPTIONS="--seed 1 --blocks 100000")'
	@echo 'make bench           run time against error and against peers, into $(BUILD)/bench; half an hour'
	@echo '                     (BENCH_OPTIONS="--only targets --runs 3", BENCH_REAL=folder)'
	@echo 'make bench-quick     its correctness alone, in less than two minutes'
	@echo 'make install         to PREFIX ($(PREFIX)), below DESTDIR; make uninstall takes it away'
	@echo 'make clean           removes $(BUILD)'
	@echo 'make help            this'
	@echo 'Variables: CC=clang, SANITIZE=address,undefined, BUILD=folder, OPTIMISE="-O2 -g", V=1, NO_INSTALL=1.'
	@echo 'bench, demo and check install missing Debian packages, as root or with passwordless sudo only.'

.PHONY: all bench bench-quick check check-layers check-man check-unit check-program check-machines check-rs274 demo install uninstall clean help

-include $(OBJECTS:.o=.d) $(BUILD)/src/main.d $(UNIT_PROGRAMS:=.d)
