# config.mk - compilers, flags and folders, for the Makefile and tests/Makefile.

comma := ,
CC ?= cc
SANITIZE ?=
# A compiler or a sanitizer of its own gets a folder of its own: switching never mixes objects.
BUILD ?= build$(patsubst %,-%,$(filter-out cc gcc,$(notdir $(firstword $(CC)))))$(patsubst %,-%,$(subst $(comma),-,$(SANITIZE)))

VERSION := 0.1.0
# clang counts changes of sign among -Wconversion, gcc does not: both warn of the same.
WARNINGS := -Wall -Wextra -Wconversion -Wno-sign-conversion -Wshadow -Wvla -Wstrict-prototypes -Wmissing-prototypes \
	-Werror=implicit
OPTIMISE ?= -O3 -g
CFLAGS ?= $(OPTIMISE)
SANITIZE_FLAGS := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer)
XML_FLAGS := $(shell xml2-config --cflags 2>/dev/null || echo -I/usr/include/libxml2)
# HARDEN= leaves the hardening out. FORTIFY needs optimisation and does not work with sanitizers.
HARDEN ?= $(if $(SANITIZE),,1)
HARDEN_CFLAGS := $(if $(HARDEN),-fstack-protector-strong -fPIE $(if $(filter -O0,$(CFLAGS)),,-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2))
HARDEN_LDFLAGS := $(if $(HARDEN),-pie -Wl$(comma)-z$(comma)relro$(comma)-z$(comma)now)
# CFLAGS, CPPFLAGS and LDFLAGS stay as the caller gave them, because make hands them on to the makes that it starts.
# Contraction would make a verdict depend on the compiler. No path of this computer gets into the program.
C_FLAGS := $(CFLAGS) -std=c17 -ffp-contract=off -ffile-prefix-map="$(CURDIR)"=. $(WARNINGS) $(HARDEN_CFLAGS) $(SANITIZE_FLAGS)
PP_FLAGS := $(CPPFLAGS) -D_POSIX_C_SOURCE=200809L -DFIVECHECK_VERSION='"$(VERSION)"' -Isrc -I$(BUILD)/gen $(XML_FLAGS)
LD_FLAGS := $(LDFLAGS) $(HARDEN_LDFLAGS) $(SANITIZE_FLAGS) -pthread
LDLIBS := -lxml2 -ljansson -lnettle -lz -lm

# make V=1 shows the commands.
Q := $(if $(V),,@)
# Compilers and tests at a time. A make that was started with -j keeps its own number.
JOBS ?= $(shell nproc)
PARALLEL = $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),,-j$(JOBS))

# What is compiled depends on this file, which changes only when the compiler or its flags do.
FLAGS := $(BUILD)/flags
FLAGS_TEXT = $(subst ','\'',$(CC) $(PP_FLAGS) $(C_FLAGS) $(LD_FLAGS) $(LDLIBS))
$(FLAGS): FORCE
	@mkdir -p $(@D)
	@echo '$(FLAGS_TEXT)' | cmp -s - $@ || echo '$(FLAGS_TEXT)' > $@
FORCE:
.PHONY: FORCE
