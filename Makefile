# fivecheck - build, install, package. `make help` names the targets; those of the tests are in tests/Makefile.

.DEFAULT_GOAL := all
include config.mk

PREFIX ?= /usr/local
DESTDIR ?=
# Debian's packages have lib/x86_64-linux-gnu and the like.
LIBDIR ?= lib
OBJCOPY ?= objcopy

# Folders may be nested; main.c is not part of the library, nor is what WebAssembly lacks.
SOURCES := $(sort $(shell find src -name '*.c' ! -path src/main.c ! -path 'src/mesh/*' ! -path 'src/wasi/*'))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o)
SCHEMAS := $(sort $(shell find src/machine -name '*.rng'))
JSON_SCHEMAS := $(sort $(shell find src/report -name '*.schema.json'))
MANUALS := $(sort $(wildcard man/*.[1-9]) $(BUILD)/man/fivecheck-gcode.5)
PLOTS := $(sort $(wildcard examples/plots/*.gnuplot))
COMPLETIONS := $(patsubst %,$(BUILD)/completion/fivecheck.%,bash zsh fish)
# Where zsh looks for functions differs: Debian's packages have share/zsh/vendor-completions.
ZSH_FUNCTIONS ?= share/zsh/site-functions
# The program that reads meshes of other formats for the import; without libassimp there is none.
MESH_PROGRAM := $(if $(shell pkg-config --exists assimp 2>/dev/null && echo yes),fivecheck-mesh)
# What install puts below PREFIX, all of it, and uninstall removes.
INSTALLED := bin/fivecheck $(addprefix libexec/fivecheck/,$(MESH_PROGRAM)) include/fivecheck.h $(LIBDIR)/libfivecheck.a $(LIBDIR)/pkgconfig/fivecheck.pc \
	$(addprefix share/fivecheck/,$(notdir $(SCHEMAS) $(JSON_SCHEMAS) $(PLOTS))) \
	$(foreach m,$(MANUALS),share/man/man$(subst .,,$(suffix $(m)))/$(notdir $(m))) \
	share/bash-completion/completions/fivecheck $(ZSH_FUNCTIONS)/_fivecheck share/fish/vendor_completions.d/fivecheck.fish

all: $(BUILD)/fivecheck $(addprefix $(BUILD)/,$(MESH_PROGRAM)) $(COMPLETIONS) $(BUILD)/man/fivecheck-gcode.5 $(BUILD)/installed/libfivecheck.a

$(BUILD)/fivecheck: $(BUILD)/src/main.o $(BUILD)/libfivecheck.a
	@echo '  LD $@'
	$(Q)$(CC) $(C_FLAGS) $(LD_FLAGS) -o $@ $^ $(LDLIBS)

# The list of objects is a prerequisite, too: a source that was moved or deleted leaves the archive.
$(BUILD)/fivecheck-mesh: $(BUILD)/src/mesh/main.o
	@echo '  LD $@'
	$(Q)$(CC) $(C_FLAGS) $(LD_FLAGS) -o $@ $< $(shell pkg-config --libs assimp) -lm

$(BUILD)/libfivecheck.a: $(OBJECTS) $(BUILD)/objects
	@rm -f $@
	@echo '  AR $@'
	$(Q)$(AR) rcs $@ $(OBJECTS)

$(BUILD)/objects: FORCE
	@mkdir -p $(@D)
	@echo '$(OBJECTS)' | cmp -s - $@ || echo '$(OBJECTS)' > $@

$(BUILD)/%.o: %.c $(FLAGS)
	@mkdir -p $(@D)
	@echo '  CC $@'
	$(Q)$(CC) $(PP_FLAGS) $(C_FLAGS) -MMD -MP -c -o $@ $<

# The viewer of reports, which report/html/viewer.c embeds.
$(BUILD)/gen/report/html/viewer_files.h: $(wildcard src/web/*.js src/web/*.css src/web/boot/*.js) scripts/bundle-web scripts/squeeze-js.awk scripts/embed
	@mkdir -p $(@D)
	@echo '  GEN $@'
	$(Q)sh scripts/bundle-web $(BUILD)/gen/web
	$(Q)sh scripts/embed viewer_js=$(BUILD)/gen/web/viewer.js viewer_css=$(BUILD)/gen/web/viewer.css \
		viewer_boot=src/web/boot/boot.js > $@.new && mv $@.new $@

$(BUILD)/src/report/html/viewer.o: $(BUILD)/gen/report/html/viewer_files.h

# The library that is installed: one object, whose only global symbols are those of src/fivecheck.h. Neither the command
# line nor the reports are in it.
FACE_OBJECTS := $(filter-out $(BUILD)/src/cli/% $(BUILD)/src/import/% $(BUILD)/src/report/%,$(OBJECTS))
$(BUILD)/installed/libfivecheck.a: $(FACE_OBJECTS) $(BUILD)/objects Makefile
	@mkdir -p $(@D)
	@rm -f $@
	@echo '  AR $@'
	$(Q)$(LD) -r -o $(@D)/fivecheck.o $(FACE_OBJECTS)
	$(Q)$(OBJCOPY) --wildcard --keep-global-symbol='fivecheck_*' $(@D)/fivecheck.o
	$(Q)$(AR) rcs $@ $(@D)/fivecheck.o

# Made from the table of options by the program itself.
$(BUILD)/completion/fivecheck.%: $(BUILD)/fivecheck
	@mkdir -p $(@D)
	$(Q)$(BUILD)/fivecheck completion $* > $@.new && mv $@.new $@

# The codes of all dialects, as the program itself knows them.
$(BUILD)/man/fivecheck-gcode.5: man/fivecheck-gcode.5.in scripts/gcode-page $(BUILD)/fivecheck
	@mkdir -p $(@D)
	$(Q)sh scripts/gcode-page $(BUILD)/fivecheck > $@.new && mv $@.new $@

# The checker as WebAssembly and the page that runs it, in build-web/app (src/wasi/Makefile).
web:
	@sh scripts/install-deps web
	@+$(MAKE) --no-print-directory -f src/wasi/Makefile $(PARALLEL)

# On http://127.0.0.1:8080/, until it is interrupted; PORT=n another port.
demo-web: web
	@sh scripts/demo-web build-web/app

# Tests, fuzzers, the campaign, benchmarks and the demo: `make help`.
TEST_TARGETS := accept bench bench-quick bench-readme build-units campaign campaign-dialects campaign-stock campaign-verdict check check-apache check-asan check-browser check-calls check-deb check-faults check-firefox check-gltf \
	check-install check-layers check-long check-machines check-man check-math check-page check-program check-quick check-reproducible check-rs274 check-short check-tsan \
	check-unit check-valgrind check-wasm check-wasm-long coverage demo fuzz lint stress stress-table
# Each of them starts a make of its own: several goals of one call must not build the same file at once.
ifneq ($(filter $(TEST_TARGETS),$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
$(TEST_TARGETS):
	@+$(MAKE) --no-print-directory -f tests/Makefile $@

install: all
	@sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@VERSION@|$(VERSION)|' src/fivecheck.pc.in \
		> $(BUILD)/installed/fivecheck.pc
	sh scripts/install "$(BUILD)" "$(DESTDIR)$(PREFIX)" $(INSTALLED)

uninstall:
	sh scripts/install --remove "$(DESTDIR)$(PREFIX)" $(INSTALLED)

# The last commit as an archive that is the same wherever it is made.
DIST := fivecheck-$(VERSION)
dist:
	@mkdir -p $(BUILD)
	@git diff --quiet HEAD || echo 'dist: changes that are not committed are left out' >&2
	@git -c tar.umask=0022 archive --format=tar --prefix=$(DIST)/ -o $(BUILD)/$(DIST).tar HEAD
	@gzip -9nf $(BUILD)/$(DIST).tar
	@echo '$(BUILD)/$(DIST).tar.gz'

clean:
	rm -rf $(BUILD) build-web

help:
	@echo 'make                 build $(BUILD)/fivecheck'
	@echo 'make install         to PREFIX ($(PREFIX)), below DESTDIR; make uninstall takes it away'
	@echo 'make dist            the last commit as $(BUILD)/$(DIST).tar.gz'
	@echo 'make web             the checker as WebAssembly and its page, in build-web/app; make demo-web shows it'
	@echo 'make clean           removes $(BUILD)'
	@$(MAKE) --no-print-directory -f tests/Makefile help
	@echo 'Variables: CC=clang, HARDEN=, SANITIZE=address,undefined, BUILD=folder, OPTIMISE="-O3 -g", V=1, JOBS=n, NO_INSTALL=1.'

.PHONY: all clean demo-web dist help install uninstall web $(TEST_TARGETS)

-include $(OBJECTS:.o=.d) $(BUILD)/src/main.d $(BUILD)/src/mesh/main.d
