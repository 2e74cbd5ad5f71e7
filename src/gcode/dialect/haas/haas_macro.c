#include "gcode/dialect/haas/haas_macro.h"

#include "gcode/dialect/fanuc/macro_b_expr.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/fanuc/macro_b_tables.h"

/* Haas mill operator's manual, "Macros". It does not define the precedence of AND, OR and XOR. */
static const struct expr_operator operators[] = {MACRO_B_OPERATORS(true)};

static const struct function_name functions[] = {MACRO_B_FUNCTIONS(true)};

static const struct expr_rules expr_rules = {
	.open = '[', .close = ']', .variable_starts = "#",
	.operators = operators, .operator_count = sizeof(operators) / sizeof(*operators),
	.unordered = "AND, OR and XOR beside other operators: Haas defines no order; use brackets",
	.functions = functions, .function_count = sizeof(functions) / sizeof(*functions),
	.has_vacant = true, .depth_max = MACRO_B_DEPTH_MAX, .nested = "brackets",
	.apply = macro_b_expr_apply, .function = macro_b_expr_function, .variable = macro_b_expr_variable,
};

/* Haas mill operator's manual, system variables. */
static const struct macro_b_range machine_only[] = {
	{1601, 2000, "tool data that the control collects"},
	{3020, 3033, "clocks, counters and settings of the control"},
};

const struct macro_b_rules haas_macro_rules = {
	.control = "Haas",
	.expr = &expr_rules,
	.truth_is_number = true,
	.vacant_counts = false,
	.logic_truncates = true,
	.modulo_signed = false,
	.angle_by_nat = false,
	.atan_pairs = false,
	.keywords_short = false,
	.conditional_m99 = true,
	.modal_calls = false,
	.goto_forward_first = false,
	.m99_own_block = true,
	.repeats_keep_arguments = true,
	.names_variables = false,
	.calls_are_statements = false,
	.m98_repeats_in_p = false,
	.m98_program_max = 99999,
	.macro_calls_max = MACRO_B_CALLS_MAX + 1,	/* differs by version: only the limit of all calls counts */
	.common_aliases = true,
	.common_all_kept = true,
	.vacant_variable = 0,
	.work_group_variable = 4012,
	.work_at_7001 = 20,
	.work_at_14001 = 99,
	.axes_in_slot_order = true,
	.machine_only = machine_only,
	.machine_only_count = sizeof(machine_only) / sizeof(*machine_only),
};
