#include "gcode/dialect/sinumerik/values/sinumerik_setting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/values/sinumerik_system.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "geom/tolerance.h"

/*
 * 840D sl, "Detailed description of the machine data", setting data, and system variables of outputs: none of these
 * changes the path of an axis. A name that ends in '_' stands for all names that begin with it. The tolerances of
 * compressor and smoothing (42465, 42475 and the like) are not in this list.
 */
static const char *const idle[] = {
	"$A_OUT", "$A_OUTA", "$A_DBB", "$A_DBW", "$A_DBD", "$A_DBR", "$A_DBSB", "$A_DBSW", "$A_DBSD",
	"$SN_JOG_",
	"$SA_JOG_",
	"$SC_JOG_",
	"$SC_THREAD_START_ANGLE",	/* 42000 */
	"$SC_DRY_RUN_FEED", "$SC_DRY_RUN_FEED_MODE",	/* 42100, 42101 */
	"$SC_DEFAULT_FEED",	/* 42110 */
	"$SC_OVR_RAPID_FACTOR",	/* 42122 */
	"$SC_SINGLEBLOCK2_STOPRE",	/* 42200 */
	"$SC_MINFEED",	/* 42460 */
	"$SC_SD_MAX_PATH_ACCEL", "$SC_IS_SD_MAX_PATH_ACCEL",	/* 42500, 42502 */
	"$SC_SD_MAX_PATH_JERK", "$SC_IS_SD_MAX_PATH_JERK",	/* 42510, 42512 */
	"$SC_CORNER_SLOWDOWN_",	/* 42520 to 42526 */
	"$SC_CUTCOM_DECEL_LIMIT",	/* 42528 */
	"$SC_MAX_BLOCKS_IN_IPOBUFFER",	/* 42990 */
	"$SA_SPIND_S", "$SA_SPIND_CONSTCUT_S",	/* 43200, 43202 */
	"$SA_SPIND_MIN_VELO_G25", "$SA_SPIND_MAX_VELO_G26", "$SA_SPIND_MAX_VELO_LIMS",	/* 43210 to 43230 */
	"$SA_WORKAREA_",	/* 43400 to 43430: they only stop the axis */
	"$TC_MOP", "$TC_TP8", "$TC_TP9",	/* monitoring and state of tools */
};

static bool is_idle(const char *name)
{
	for (size_t i = 0; i < sizeof(idle) / sizeof(idle[0]); i++) {
		const size_t length = strlen(idle[i]);
		const bool begins = !strncmp(name, idle[i], length);

		if (begins && (idle[i][length - 1] == '_' || !name[length + strspn(name + length, "0123456789")]))
			return true;
	}
	return false;
}

/* "[0,R[1]]" */
static bool step_over_index(struct lexer *lexer)
{
	const char *text = lexer->at->text;
	const int column = lexer_next_column(lexer);
	int depth = 0;

	if (lexer_peek(lexer) != '[')
		return true;
	for (size_t at = lexer->position; text[at] && text[at] != ';'; at++) {
		depth += text[at] == '[' ? 1 : text[at] == ']' ? -1 : 0;
		if (depth == 0 && text[at] == ']') {
			lexer->position = at + 1;
			return true;
		}
	}
	return fault(lexer->at, column, "the '[' here has no ']'");
}

static bool step_over_value(struct interp *interp, struct lexer *lexer, const char *name)
{
	struct sinumerik_text text;
	double value;

	if (!step_over_index(lexer) || !sinumerik_name_need(lexer, '=', name))
		return false;
	return sinumerik_expr_is_text(interp, lexer) ? sinumerik_expr_text(interp, lexer, &text)
						     : sinumerik_expr_number(interp, lexer, &value);
}

/* The value that the machine file gives would no longer be valid. */
static bool check_untold(struct interp *interp, const char *name, int column)
{
	const struct controller *controller = &interp->config->controller;
	const size_t length = strlen(name);

	for (size_t i = 0; i < controller->variable_count; i++) {
		const char *told = controller->variables[i].name;

		if (!strncmp(told, name, length) && (told[length] == '\0' || told[length] == '['))
			return fault(&interp->at, column,
				     "%s is written here, but <variable name=\"%s\"> tells what it holds: what a "
				     "program reads of it behind this block is not followed",
				     name, told);
	}
	return true;
}

/* ------------------------------------------------------------ data of tools */

/* 840D sl, "Tool parameters": the other lengths, wear, and adapter; the setup does not have them. */
static bool adds_to_tool(long parameter)
{
	static const long adding[] = {4, 5, 12, 13, 14, 15, 21, 22, 23};

	for (size_t i = 0; i < sizeof(adding) / sizeof(adding[0]); i++) {
		if (adding[i] == parameter)
			return true;
	}
	return false;
}

static bool compare(struct interp *interp, const char *name, int tool, int edge, double value, int column)
{
	double held;

	if (interp->config->any_tool)
		return true;
	if (!sinumerik_system_edge(interp, name, tool, edge, column, &held))
		return false;
	return fabs(value - held) <= TOOL_SUM_TOLERANCE ||
	       fault(&interp->at, column,
		     "%s[%d,%d]=%.9g, but the setup has %.9g, and the setup counts: give edge D%d of tool T%d the "
		     "%s there that the program writes",
		     name, tool, edge, value, held, edge, tool, !strcmp(name, "$TC_DP3") ? "length" : "radius");
}

/* $TC_DP3[1,2]=100: parameter 3 of tool 1, edge 2. */
static bool write_edge(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	const long parameter = strtol(name + strlen("$TC_DP"), NULL, 10);
	int tool, edge;
	double value;

	if (!sinumerik_name_need(lexer, '[', name) ||
	    !sinumerik_expr_whole(interp, lexer, "the number of a tool", 1, 32000, &tool) ||
	    !sinumerik_name_need(lexer, ',', "the tool") ||
	    !sinumerik_expr_whole(interp, lexer, "the number of an edge", 1, 32000, &edge) ||
	    !sinumerik_name_need(lexer, ']', "the edge") || !sinumerik_name_need(lexer, '=', name) ||
	    !sinumerik_expr_number(interp, lexer, &value))
		return false;
	if (parameter == 3 || parameter == 6)
		return compare(interp, name, tool, edge, value, column);
	if (parameter == 1 && !(value >= 100 && value < 300))
		return fault(&interp->at, column, "%s=%.9g: only types of milling and drilling tools are supported, "
						  "100 to 299",
			     name, value);
	if (adds_to_tool(parameter) && fabs(value) > 0)
		return fault(&interp->at, column,
			     "%s=%.9g adds to the size of the tool, which the setup has as a whole: 0 is supported "
			     "alone",
			     name, value);
	return true;
}

static bool is_edge(const char *name)
{
	const size_t start = strlen("$TC_DP");

	return !strncmp(name, "$TC_DP", start) && name[start] && !name[start + strspn(name + start, "0123456789")];
}

/* ------------------------------------------------------------------- others */

/* SD42440 and SD42442: 0 is increments_after_shift="stay", 1 "traverse". */
static bool write_increments(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	const enum increments_after_shift told = interp->config->controller.increments_after_shift;
	int value;

	if (!sinumerik_name_need(lexer, '=', name) || !sinumerik_expr_whole(interp, lexer, name, 0, 1, &value))
		return false;
	return told == (value ? INCREMENTS_TRAVERSE_SHIFT : INCREMENTS_FROM_POSITION) ||
	       fault(&interp->at, column,
		     "%s=%d: what increments do has one answer for the whole program; set "
		     "increments_after_shift=\"%s\" in the machine file's <controller>, which has the same meaning",
		     name, value, value ? "traverse" : "stay");
}

bool sinumerik_setting_write(struct interp *interp, struct lexer *lexer, const char *name, int column)
{
	if (!check_untold(interp, name, column))
		return false;
	if (!strcmp(name, "$SC_FRAME_OFFSET_INCR_PROG") || !strcmp(name, "$SC_TOOL_OFFSET_INCR_PROG"))
		return write_increments(interp, lexer, name, column);
	if (is_edge(name))
		return write_edge(interp, lexer, name, column);
	if (is_idle(name) || sinumerik_builder_does_nothing(interp, name))
		return step_over_value(interp, lexer, name);
	return fault(&interp->at, column,
		     "%s: what this changes on the control is not known here; if no axis moves otherwise for it, "
		     "set <macro program=\"%s\" action=\"none\"/> in the machine file's <controller>",
		     name, name);
}
