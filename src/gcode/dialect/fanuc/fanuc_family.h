/* fanuc_family.h - rows of codes that are the same on Fanuc's and Haas's controls. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_FANUC_FAMILY_H
#define FIVECHECK_GCODE_DIALECT_FANUC_FANUC_FAMILY_H

#include "gcode/dialect.h"

extern const struct word_set fanuc_family_words;
extern const struct code_set fanuc_family_g_codes, fanuc_family_m_codes;

/*
 * The behaviour of canned cycles in both manuals. Neither says that the initial level is no coordinate, and neither
 * forbids R below Z; words of a cycle that is repeated 0 times are kept, and nothing is drilled.
 */
#define FANUC_FAMILY_CYCLES \
	.words_outlive_cycle = ANSWER_YES, \
	/* Haas, "Looping Canned Cycles": G91 after a G81 in G90 changes only the moves between holes. */ \
	.words_keep_place = ANSWER_YES, \
	.without_axes = ANSWER_YES, \
	.starts_at_r = ANSWER_NO, \
	.never_below_r = ANSWER_NO, \
	.level_is_coordinate = ANSWER_NO, \
	.p_is_needed = ANSWER_NO, \
	.q_has_sign = ANSWER_NO, \
	.zero_repeats_refused = ANSWER_NO, \
	.only_xyz = ANSWER_NO, \
	.spindle_must_turn = ANSWER_NO, \
	.taps_confuse_planes = ANSWER_NO, \
	.feeds_to_clear = ANSWER_NO, \
	.rises_first = ANSWER_NO, \
	.any_order = ANSWER_YES, \
	.exact_path = ANSWER_NO

#endif
