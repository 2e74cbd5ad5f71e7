#include "gcode/dialect/fanuc/fanuc_macro.h"

#include "gcode/dialect/fanuc/macro_b_expr.h"
#include "gcode/dialect/fanuc/macro_b_state.h"

/* B-63944EN, priority of operations: functions; * / AND MOD; + - OR XOR; and comparisons last. */
static const struct expr_operator operators[] = {
	{"eq", EXPR_EQ, 1, false},
	{"ne", EXPR_NE, 1, false},
	{"gt", EXPR_GT, 1, false},
	{"ge", EXPR_GE, 1, false},
	{"lt", EXPR_LT, 1, false},
	{"le", EXPR_LE, 1, false},
	{"+", EXPR_PLUS, 2, false},
	{"-", EXPR_MINUS, 2, false},
	{"or", EXPR_OR, 2, false},
	{"xor", EXPR_XOR, 2, false},
	{"*", EXPR_TIMES, 3, false},
	{"/", EXPR_DIVIDE, 3, false},
	{"and", EXPR_AND, 3, false},
	{"mod", EXPR_MODULO, 3, false},
};

static const struct function_name functions[] = {
	{"abs", "ABS", FUNCTION_ABS, false},
	{"acos", "ACOS", FUNCTION_ACOS, false},
	{"asin", "ASIN", FUNCTION_ASIN, false},
	{"atan", "ATAN", FUNCTION_ATAN, false},
	{"cos", "COS", FUNCTION_COS, false},
	{"exp", "EXP", FUNCTION_EXP, false},
	{"fix", "FIX", FUNCTION_FIX, false},
	{"fup", "FUP", FUNCTION_FUP, false},
	{"ln", "LN", FUNCTION_LN, false},
	{"round", "ROUND", FUNCTION_ROUND, false},
	{"sin", "SIN", FUNCTION_SIN, false},
	{"sqrt", "SQRT", FUNCTION_SQRT, false},
	{"tan", "TAN", FUNCTION_TAN, false},
};

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
