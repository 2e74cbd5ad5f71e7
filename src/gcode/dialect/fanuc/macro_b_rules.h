/* macro_b_rules.h - the differences between controls with custom macro B, as data. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_RULES_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_RULES_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/eval/expr.h"

/* System variables that are known only to the running machine. */
struct macro_b_range {
	int first, last;
	const char *what;
};

/* Constant data of a dialect. If an answer is false, the program is refused, unless the comment says otherwise. */
struct macro_b_rules {
	const char *control;	/* the name of the maker in messages */
	const struct expr_rules *expr;

	/* Values */
	bool truth_is_number;	/* a comparison is the number 1 or 0; false: it is a truth value, and IF needs one */
	bool vacant_counts;	/* vacant operands count as 0, but EQ and NE distinguish them from 0 */
	bool logic_truncates;	/* AND, OR and XOR use the integer portion */
	bool modulo_signed;	/* MOD allows a negative first operand */
	bool angle_by_nat;	/* a negative result of ASIN and ATAN depends on parameter NAT: a caution */
	bool atan_pairs;	/* ATAN[a]/[b] and ATAN[a,b] */

	/* Statements */
	bool keywords_short;	/* two letters of a statement's name are enough */
	bool conditional_m99;	/* [#1 LT 10] M99 P10 */
	bool modal_calls;	/* G66 and G67 are macro calls */
	bool goto_forward_first;	/* GOTO searches forward, then from the start; false: only a unique block */
	bool m99_own_block;	/* M99 P jumps to a block of the subprogram; false: of the caller */
	bool repeats_keep_arguments;	/* a repetition of a macro starts with the variables of the last one */
	bool names_variables;	/* SETVN gives names to common variables */
	bool calls_are_statements;	/* for cutter compensation, M98 and M99 alone are like macro statements */
	bool m98_repeats_in_p;	/* the digits of P before the last four are the repetitions */
	int m98_program_max;
	int macro_calls_max;	/* the greatest depth of nested macro calls */

	/* Variables */
	bool common_aliases;	/* #10000 to #10999 are other names of #0 to #999; false: there are none */
	bool common_all_kept;	/* #100 to #199 keep their values, as #500 to #999 do; false: vacant at the start */
	int vacant_variable;	/* always vacant, like #0; 0: there is no other */
	int work_group_variable;	/* the code of the active work offset */
	int work_at_7001, work_at_14001;	/* extended work offsets that start there */
	bool axes_in_slot_order;	/* axes are numbered X Y Z A B C; false: from the fourth on not known */
	const struct macro_b_range *machine_only;	/* in addition to those of all controls */
	size_t machine_only_count;
};

#endif
