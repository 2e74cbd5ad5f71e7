#include "gcode/dialect/fanuc/fanuc_macro.h"

#include "gcode/dialect/fanuc/macro_b_expr.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/fanuc/macro_b_tables.h"

static const struct expr_operator operators[] = {MACRO_B_OPERATORS(false)};

static const struct function_name functions[] = {MACRO_B_FUNCTIONS(false)};

static const struct expr_rules expr_rules = {
	.open = '[', .close = ']', .variable_starts = "#",
	.operators = operators, .operator_count = sizeof(operators) / sizeof(*operators),
	.functions = functions, .function_count = sizeof(functions) / sizeof(*functions),
	.abbreviations = true,
	.has_vacant = true, .depth_max = MACRO_B_DEPTH_MAX, .nested = "brackets",
	.apply = macro_b_expr_apply, .function = macro_b_expr_function, .variable = macro_b_expr_variable,
};

const struct macro_b_rules fanuc_macro_rules = {
	.control = "Fanuc",
	.expr = &expr_rules,
	.truth_is_number = false,
	.vacant_counts = true,
	.logic_truncates = false,
	.modulo_signed = true,
	.angle_by_nat = true,
	.atan_pairs = true,
	.keywords_short = true,
	.conditional_m99 = false,
	.modal_calls = true,
	.goto_forward_first = true,
	.m99_own_block = false,
	.repeats_keep_arguments = false,
	.names_variables = true,
	.calls_are_statements = true,
	.m98_repeats_in_p = true,
	.m98_program_max = 99999999,
	.macro_calls_max = 5,	/* B-63944EN, call nesting */
	.common_aliases = false,
	.common_all_kept = false,
	.vacant_variable = 3100,
	.work_group_variable = 4014,
	.work_at_7001 = 48,
	.work_at_14001 = 0,
	.axes_in_slot_order = false,
};
