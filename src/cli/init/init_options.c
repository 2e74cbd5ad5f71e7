#include "cli/init/init_options.h"

#include <stddef.h>

#include "control/dialects.h"

/* Every option may be given several times; the key determines how machine_plan_set uses its arguments. */
#define LIST(key) .kind = VALUE_LIST, .field = offsetof(struct init_request, given[(key) - PLAN_FAMILY])

const struct option_row init_options[INIT_OPTION_COUNT] = {
	{PLAN_ROTARY, "rotary", "AXIS,AXIS", LIST(PLAN_ROTARY),
	 .help = "the rotary axes: first the axis that carries the other (head-table: the head's axis): A,C"},
	{PLAN_TABLE, "table", "AXIS,...", LIST(PLAN_TABLE),
	 .help = "the linear axes that move the table, in order from the base (none)"},
	{PLAN_HEAD, "head", "AXIS,...", LIST(PLAN_HEAD),
	 .help = "the linear axes that move the head (the rest of Y,X,Z)"},
	{PLAN_LIMITS, "limits", "AXIS=MIN:MAX,...", LIST(PLAN_LIMITS),
	 .help = "the travel, in mm or degrees; X=none: unlimited"},
	{PLAN_LOCATION, "location", "AXIS=X,Y,Z", LIST(PLAN_LOCATION),
	 .help = "a point on a rotary axis; give one for each"},
	{PLAN_SPINDLE, "spindle", "X,Y,Z", LIST(PLAN_SPINDLE),
	 .help = "the gauge point, where tools are mounted"},
	{PLAN_SPINDLE_DIRECTION, "spindle-direction", "X,Y,Z", LIST(PLAN_SPINDLE_DIRECTION),
	 .help = "from the gauge point to the tip of a tool (0,0,-1)"},
	{PLAN_WORKHOLDING, "workholding", "X,Y,Z", LIST(PLAN_WORKHOLDING),
	 .help = "the origin of fixtures and parts (0,0,0)"},
	{PLAN_DIRECTION, "direction", "AXIS=X,Y,Z", LIST(PLAN_DIRECTION),
	 .help = "the direction in which the axis moves its link for a positive value (usual for its letter)"},
	{PLAN_INCLINATION, "inclination", "AXIS=ANGLE,...", LIST(PLAN_INCLINATION),
	 .help = "the angle between A or B and Z, in degrees (90; the oblique axis of a nutating head or table: 45)"},
	{PLAN_RATES, "rates", "AXIS=RATE,...", LIST(PLAN_RATES),
	 .help = "the rates of rapids per minute (30000 mm, 7200 degrees)"},
	{PLAN_HOME, "home", "AXIS=VALUE,...", LIST(PLAN_HOME),
	 .help = "where programs start (0)"},
	{PLAN_TITLE, "title", "AXIS=TEXT", LIST(PLAN_TITLE),
	 .help = "the name of the axis in reports; give one for each"},
	{PLAN_BODY, "body", "LINK=FILE.stl", LIST(PLAN_BODY),
	 .help = "a mesh on an axis or on the base: Z=stl/head.stl, base=bed.stl; may be given several times"},
	{PLAN_NAME, "name", "TEXT", LIST(PLAN_NAME),
	 .help = "the name of the machine"},
	{PLAN_UNITS, "units", "UNIT", LIST(PLAN_UNITS), .choices = machine_plan_units,
	 .help = "mm (the default) or inch, for the file and the options"},
	{PLAN_DIALECT, "dialect", "NAME", LIST(PLAN_DIALECT), .choices = dialect_names,
	 .help = "the dialect of the programs: %s; the default is the first"},
	{PLAN_RAPID, "rapid", "KIND", LIST(PLAN_RAPID), .choices = machine_plan_rapids,
	 .help = "how G0 moves: %s; any is the default for controls whose parameters decide it"},
	{PLAN_TOOL_CHANGE, "tool-change", "AXIS=VALUE,...", LIST(PLAN_TOOL_CHANGE),
	 .help = "the position to which M6 moves these axes first; none: M6 moves no axis"},
	{PLAN_CONTROLLER, "controller", "NAME=VALUE", LIST(PLAN_CONTROLLER),
	 .help = "an attribute of <controller>: path_tolerance=0.02; give one for each"},
	{PLAN_OUTPUT, "output", "FILE", .kind = VALUE_OUTPUT, .field = offsetof(struct init_request, output),
	 .help = "write the machine file to FILE, which must not exist"},
	{PLAN_HELP, "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct option_row family_row = {PLAN_FAMILY, "family", "FAMILY", .choices = machine_plan_families};

const struct option_row *init_options_row(enum machine_plan_key key)
{
	for (int i = 0; i < INIT_OPTION_COUNT; i++) {
		if (init_options[i].key == (int)key)
			return &init_options[i];
	}
	return &family_row;
}
