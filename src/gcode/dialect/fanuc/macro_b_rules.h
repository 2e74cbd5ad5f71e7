/* macro_b_rules.h - in which points the controls that have custom macro B differ, as data. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_RULES_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_RULES_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/eval/expr.h"

/* System variables that only the machine knows when it runs. */
struct macro_b_range {
	int first, last;
	const char *what;
};

/* Constant data of a dialect. Where the answer is false, the program is refused unless the comment says otherwise. */
struct macro_b_rules {
	const char *control;	/* as messages call the maker */
	const struct expr_rules *expr;

	/* Values */
	bool truth_is_number;	/* a comparison is the number 1 or 0; false: it is a truth value, and IF needs one */
	bool vacant_counts;	/* vacant operands count as 0, and EQ and NE tell them from 0 */
	bool logic_truncates;	/* AND, OR and XOR take the integer portion */
	bool modulo_signed;	/* MOD takes a negative first operand */
	bool angle_by_nat;	/* a negative result of ASIN and ATAN depends on parameter NAT: a caution */
	bool atan_pairs;	/* ATAN[a]/[b] and ATAN[a,b] */

	/* Statements */
	bool keywords_short;	/* two letters of a statement's name will do */
	bool conditional_m99;	/* [#1 LT 10] M99 P10 */
	bool modal_calls;	/* G66 and G67 are macro calls */
	bool goto_forward_first;	/* GOTO searches forward and then from the start; false: one such block only */
	bool m99_own_block;	/* M99 P goes to a block of the subprogram; false: of the caller */
	bool repeats_keep_arguments;	/* a macro's repetitions find its variables as the last one left them */
	bool names_variables;	/* SETVN gives names to common variables */
	bool m98_repeats_in_p;	/* the digits of P before the last four are the repetitions */
	int m98_program_max;
	int macro_calls_max;	/* calls of macros inside each other */

	/* Variables */
	bool common_aliases;	/* #10000 to #10999 are other names of #0 to #999; false: there are none */
	bool common_all_kept;	/* #100 to #199 keep their values, as #500 to #999 do; false: vacant at the start */
	int vacant_variable;	/* always vacant, as #0 is; 0: no other */
	int work_group_variable;	/* the code of the work offset in force */
	int work_at_7001, work_at_14001;	/* extended work offsets that start there */
	bool axes_in_slot_order;	/* axis numbers are X Y Z A B C; false: from the fourth on not known */
	const struct macro_b_range *machine_only;	/* beside those that all controls have */
	size_t machine_only_count;
};

#endif
