/* machine_plan_value.h - reads numbers, vectors and lists of axes for `fivecheck init`. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_VALUE_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_VALUE_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/init/machine_plan.h"

/* Each returns false and leaves *out unchanged if the text (of `length` bytes) has another form. */

/* A coordinate or an angle: a decimal number of at most 100,000, more than any machine needs in any unit. */
bool machine_plan_read_number(double *out, const char *text, size_t length);

/* Three numbers, separated by commas or blanks. */
bool machine_plan_read_vector(vec3 *out, const char *text);

/* "MIN:MAX", where either may be missing, or "none". */
bool machine_plan_read_limits(struct machine_plan_axis *out, const char *text, size_t length);

/* Letters of axes, all rotary or all linear, each at most once, with or without commas; or "none". */
bool machine_plan_read_chain(struct machine_plan_chain *out, const char *text, bool rotary);

/* The slot of the X in "X=..."; *rest is the text after the =. -1: the text begins differently. */
int machine_plan_read_letter(const char *text, const char **rest);

/* Is the text permitted in an XML file? UTF-8 without control characters, not empty, at most 200 bytes. */
bool machine_plan_is_text(const char *text);

#endif
