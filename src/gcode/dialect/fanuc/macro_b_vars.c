#include "gcode/dialect/fanuc/macro_b_vars.h"

#include <string.h>

#include "gcode/dialect/fanuc/macro_b_kept.h"
#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/dialect/fanuc/macro_b_system.h"

/* The index of a common variable, or -1. Haas: #10100 is another name of #100. */
static int common_index(const struct interp *interp, int number)
{
	if ((number >= 100 && number <= 199) || (number >= 500 && number <= 999))
		return number;
	if (macro_b_of(interp)->rules->common_aliases && number >= 10000 && number <= 10999)
		return number - 10000;
	return -1;
}

static bool fault_unknown(struct interp *interp, int number, int column)
{
	return fault(&interp->at, column,
		     "#%d is not a variable of the %s dialect; programs have #1 to #33, #100 to #199 and #500 to #999",
		     number, interp->config->dialect->name);
}

/* Manuals do not say whether the assignments of a block take effect together or one after the other. */
static bool was_assigned(const struct interp *interp, int number)
{
	for (int i = 0; i < macro_b_of(interp)->assigned_count; i++) {
		if (macro_b_of(interp)->assigned[i] == number)
			return true;
	}
	return false;
}

/* B-63944EN, common variables: #100 to #199 are vacant from the start, #500 to #999 are kept; Haas keeps them all. */
static bool read_common(struct interp *interp, int index, int column, double *value)
{
	const struct macro_b_vars *vars = &macro_b_of(interp)->vars;
	bool kept = macro_b_of(interp)->rules->common_all_kept || index >= 500;

	if (!vars->given[index] && (kept || vars->builder_ran || macro_b_kept_tells(interp, index)))
		return macro_b_kept_read(interp, index, column,
					 vars->builder_ran
					     ? "may be a result of a macro of the machine builder, which is not known"
					     : "keeps its value from earlier programs, and this program has not set it",
					 value);
	if (vars->before_builder[index] && !macro_b_of(interp)->cautioned_builder) {
		caution(&interp->at, column,
			"#%d was assigned before a macro of the machine builder, which may have changed it; from here "
			"on, common variables keep what the program assigned", index);
		macro_b_of(interp)->cautioned_builder = true;
	}
	*value = vars->common[index];
	return true;
}

void macro_b_vars_doubt(struct interp *interp)
{
	struct macro_b_vars *vars = &macro_b_of(interp)->vars;

	vars->builder_ran = true;
	memcpy(vars->before_builder, vars->given, sizeof(vars->given));
}

bool macro_b_vars_read(struct interp *interp, int number, int column, double *value)
{
	const struct macro_b_vars *vars = &macro_b_of(interp)->vars;
	int index = common_index(interp, number);

	*value = macro_b_vacant();
	if (number == 0 || number == macro_b_of(interp)->rules->vacant_variable)
		return true;
	if (was_assigned(interp, number))
		return fault(&interp->at, column, "#%d is assigned in this block; read it in the next block",
			     number);
	if (number >= 1 && number <= MACRO_B_LOCALS)
		*value = vars->local[vars->level][number];
	else if (index >= 0)
		return read_common(interp, index, column, value);
	else if (number >= 1000)
		return macro_b_system_read(interp, number, column, value);
	else
		return fault_unknown(interp, number, column);
	return true;
}

bool macro_b_vars_write(struct interp *interp, int number, int column, double value)
{
	struct macro_b *macro = macro_b_of(interp);
	int index = common_index(interp, number);

	if (macro->assigned_count == MACRO_B_ASSIGNED_MAX)
		return fault(&interp->at, column, "more than %d assignments in one block", MACRO_B_ASSIGNED_MAX);
	macro->assigned[macro->assigned_count++] = number;
	if (number == 0)
		return fault(&interp->at, column, "#0 is always vacant; it cannot be assigned");
	if (number >= 1 && number <= MACRO_B_LOCALS) {
		macro->vars.local[macro->vars.level][number] = value;
		return true;
	}
	if (index < 0)
		return number >= 1000 ? macro_b_system_write(interp, number, column, value)
				      : fault_unknown(interp, number, column);
	macro->vars.common[index] = value;
	macro->vars.given[index] = true;
	macro->vars.before_builder[index] = false;
	return true;
}
