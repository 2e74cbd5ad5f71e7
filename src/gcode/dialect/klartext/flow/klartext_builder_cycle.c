#include "gcode/dialect/klartext/flow/klartext_builder_cycle.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/minmax.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/moves_around.h"

/* iTNC 530 and TNC 640 user's manuals: cycles of the control whose moves are not modelled and that a program calls. */
static const struct {
	int number;
	const char *what;
} called[] = {
    {18, "thread cutting"},
    {25, "contour train"},
    {27, "cylinder surface"},
    {28, "cylinder surface"},
    {29, "cylinder surface"},
    {39, "cylinder surface"},
    {225, "engraving"},
    {231, "ruled surface"},
    {272, "roughing of OCM"},
    {273, "floor finishing of OCM"},
    {274, "side finishing of OCM"},
    {275, "trochoidal slot"},
    {276, "contour train in space"},
    {277, "chamfering of OCM"},
};

static const char *find_called(int number)
{
	for (size_t i = 0; i < sizeof(called) / sizeof(called[0]); i++) {
		if (called[i].number == number)
			return called[i].what;
	}
	return NULL;
}

bool klartext_builder_cycle_is_called(int number)
{
	return find_called(number) != NULL;
}

/* What the machine file says of a cycle; NULL: nothing. */
static const struct builder_macro *find_macro(const struct interp *interp, int number)
{
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->macro_count; i++) {
		if (controller->macros[i].program == number)
			return controller->macros[i].action == MACRO_MOVE ? NULL : &controller->macros[i];
	}
	return NULL;
}

bool klartext_builder_cycle_is_known(const struct interp *interp, int number)
{
	return find_macro(interp, number) != NULL;
}

static bool is_probing(int number)
{
	return (number >= 400 && number <= 499) || (number >= 1400 && number <= 1499);
}

bool klartext_builder_cycle_refuse(const struct lexer *lexer, int number, int column)
{
	if (is_probing(number))
		return fault(lexer->at, column,
			     "touch probe cycle %d: where the probe stops is not known before the program runs; if "
			     "it stays near its place, set <macro program=\"%d\" action=\"around\" X=\"\" Y=\"\" "
			     "Z=\"\"/> in the machine file's <controller> to say how far it moves",
			     number, number);
	if (find_called(number))
		return fault(lexer->at, column,
			     "CYCL DEF %d: %s is not followed; if it stays near the place where it is called, set "
			     "<macro program=\"%d\" action=\"around\" X=\"\" Y=\"\" Z=\"\"/> in the machine file's "
			     "<controller> to say how far it moves",
			     number, find_called(number), number);
	return fault(lexer->at, column,
		     "cycle %d is not known: it may be a cycle of the machine's builder; if it moves no axis, "
		     "set <macro program=\"%d\" action=\"none\"/> in the machine file's <controller>",
		     number, number);
}

/*
 * "Touch probe cycles": they take effect where they are defined. What they measure changes parameters, datums and
 * offsets; the check uses the values of the setup instead.
 */
static void measure(struct interp *interp, const struct klartext_cycle *cycle)
{
	struct klartext *klartext = klartext_of(interp);

	caution(&interp->at, cycle->column,
		"touch probe cycle %d: datum and tools count as the setup has them, whatever it measures",
		cycle->number);
	for (int number = 115; number < 200; number += number == 119 ? 31 : 1)
		klartext_q_forget(klartext, number);
	for (int number = 950; number < 1000; number++)
		klartext_q_forget(klartext, number);
}

/* In turned coordinates the cycle may move along their axes or along the machine's axes. The move covers both boxes. */
static bool go_around(struct interp *interp, const double around[3], bool ends_there, int column)
{
	const vec3 turned = klartext_frame_box(interp, around);
	const double both[3] = {larger(around[0], turned.x), larger(around[1], turned.y), larger(around[2], turned.z)};
	double *loose = interp->comp.loose;

	if (!moves_around_go(interp, both, column))
		return false;
	if (ends_there)
		return true;
	/* The cycle always ends at the same height, which its parameters give. */
	loose[SLOT_X] += both[0];
	loose[SLOT_Y] += both[1];
	loose[SLOT_Z] = larger(both[2], klartext_of(interp)->open.aside ? loose[SLOT_Z] : 0);
	klartext_of(interp)->open.aside = false;
	klartext_of(interp)->open.height = both[2] > 0;
	return true;
}

/* Reports modes in which a cycle that moves around its place is not supported. False: reported. */
static bool check_place(struct interp *interp, const char *kind, const char *name, int column)
{
	if (interp->state.tcp == TCP_OFF && !klartext_comp_is_selected(interp) && !klartext_of(interp)->stay.waits &&
	    !klartext_frame_is_scaled(interp))
		return true;
	return fault(&interp->at, column,
		     "%s %s moves around its place while the tool centre point is controlled, the plane is tilted, "
		     "coordinates are scaled or the radius is compensated: that is not followed",
		     kind, name);
}

bool klartext_builder_cycle_run(struct interp *interp, const struct klartext_cycle *cycle)
{
	const struct builder_macro *macro = find_macro(interp, cycle->number);
	char name[16];

	if (is_probing(cycle->number))
		measure(interp, cycle);
	if (!macro || macro->action != MACRO_AROUND)
		return true;
	snprintf(name, sizeof(name), "%d", cycle->number);
	if (!check_place(interp, "cycle", name, cycle->column))
		return false;
	klartext_of(interp)->tool.moved = true;
	klartext_of(interp)->last.known = false;
	/*
	 * The control's own cycles end above the region that they have milled. Cycles of the touch probe end at the
	 * clearance height above the last probed point.
	 */
	return go_around(interp, macro->around, !find_called(cycle->number) && !is_probing(cycle->number),
			 cycle->column);
}

/* ---------------------------------------------------------------- programs */

/* "TNC:\\OEM\\reset.h" is RESET: letters, digits and _, a letter first. False: no <macro> can have the name. */
static bool bare_name(const char *path, char name[KLARTEXT_NAME])
{
	size_t length;

	for (const char *at = path; *at; at++)
		path = *at == '\\' || *at == '/' || *at == ':' ? at + 1 : path;
	length = strcspn(path, ".");
	if (length >= KLARTEXT_NAME || (path[length] && !ascii_same(path + length, ".h")) ||
	    !ascii_is_letter(path[0]))
		return false;
	for (size_t i = 0; i < length; i++) {
		if (!ascii_is_alphanumeric(path[i]) && path[i] != '_')
			return false;
		name[i] = ascii_upper(path[i]);
	}
	name[length] = '\0';
	return true;
}

static const struct builder_macro *find_program(const struct interp *interp, const char *name)
{
	const struct controller *controller = &interp->config->controller;

	for (size_t i = 0; i < controller->macro_count; i++) {
		const struct builder_macro *macro = &controller->macros[i];

		if (macro->name && !strcmp(macro->name, name))
			return macro->action == MACRO_MOVE ? NULL : macro;
	}
	return NULL;
}

bool klartext_builder_program_run(struct interp *interp, const char *path, int column)
{
	char name[KLARTEXT_NAME];
	const struct builder_macro *macro;

	if (!bare_name(path, name))
		return fault(&interp->at, column, "there is no file of the program %s", path);
	macro = find_program(interp, name);
	if (!macro)
		return fault(&interp->at, column,
			     "there is no file of the program %s; if the machine's builder made it and it moves no "
			     "axis, set <macro program=\"%s\" action=\"none\"/> in the machine file's <controller>",
			     path, name);
	if (macro->action != MACRO_AROUND)
		return true;
	if (!check_place(interp, "program", name, column))
		return false;
	klartext_of(interp)->tool.moved = true;
	klartext_of(interp)->last.known = false;
	return go_around(interp, macro->around, true, column);
}
