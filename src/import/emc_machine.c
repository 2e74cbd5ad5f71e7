#include "import/emc_machine.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/axes.h"
#include "base/decimal.h"
#include "base/math/math_functions.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "import/axis_chains.h"
#include "import/hal_values.h"
#include "import/ini_file.h"

struct reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct diag *diag;
	const char *path;
	struct ini_file ini;
	struct hal_values hal;
	double unit;	/* mm per unit of length */
	char joints[SLOT_COUNT * 2 + 1];	/* the letter of each joint */
	char order[SLOT_COUNT + 1];	/* the letters of the axes, each once */
};

static const double linear_limit = 1e6;

/* Units per mm: LINEAR_UNITS within this of those of an inch count as inches (INIT_CANON of the 2.9 emccanon.cc). */
static const double rounded_units = 1e-3;

static struct srcloc place(const struct reading *r)
{
	return (struct srcloc){.file = r->path};
}

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, place(r), "%s", what);
	return false;
}

/* ----------------------------------------------------------- kinematics */

/* The places of rotary axes, and the direction of rotation of the bodies that they carry for a positive value. */
enum { ROTARY_MAX = 3 };

struct rotary {
	char letter;
	vec3 direction;
	const char *pins[3];	/* their sum, with that of the next row, is the location; or NULL */
	const char *more[3];
	bool turned;	/* the direction is reversed if the pin conventional-directions is set */
	bool nutating;	/* the pin nut-angle tilts it from Z toward `direction` */
};

/*
 * The work follows the rotary axes of the trt modules: p = Rz(-c) (Rx(-a) (q - a0) + a0 ...), so the table rotates in
 * the positive direction, unless conventional-directions is set. xyzab_tdr_kins has p = Rx(a) (Ry(b) q - dz) + dz, so B
 * carries A, and both rotate in the negative direction. The head of 5axiskins points to (sin b cos c, sin b sin c, -cos
 * b), that of maxkins to (sin b, 0, -cos b), or to (-sin b, 0, -cos b) with conventional-directions; its table has p =
 * Rz(c) q. xyzacb_trsrn has p = Rx(a) t, and t = q + c0 - Rz(c) (c0 - b0 + R(b) b0): its table rotates in the negative
 * direction, its head in the positive one, about Z through c0 and about (0, sin nut-angle, cos nut-angle) through b0;
 * xyzbca_trsrn has the same with X and Y exchanged. Source: the sources of these modules of LinuxCNC.
 */
static const struct module {
	const char *name;
	const char *pins;	/* the beginning of the names of its pins, if it is not its own name; or NULL */
	const char *table, *head;	/* letters of the rotary axes, from the base on */
	struct rotary rotary[ROTARY_MAX];
	double pivot;	/* mm or inch: the default of pivot-length; 0: it has none */
} modules[] = {
	{"xyzac-trt-kins", NULL, "AC", "",
	 {{'A', {1, 0, 0}, {NULL, "y-rot-point", "z-rot-point"}, {NULL, "y-offset", "z-offset"}, true, false},
	  {'C', {0, 0, 1}, {"x-rot-point", "y-rot-point", NULL}, {NULL, NULL, NULL}, true, false}},
	 0},
	{"xyzbc-trt-kins", NULL, "BC", "",
	 {{'B', {0, 1, 0}, {"x-rot-point", NULL, "z-rot-point"}, {"x-offset", NULL, "z-offset"}, true, false},
	  {'C', {0, 0, 1}, {"x-rot-point", "y-rot-point", NULL}, {NULL, NULL, NULL}, true, false}},
	 0},
	{"5axiskins", NULL, "", "CB",
	 {{'C', {0, 0, 1}, {NULL, NULL, NULL}, {NULL, NULL, NULL}, false, false},
	  {'B', {0, -1, 0}, {NULL, NULL, "pivot-length"}, {NULL, NULL, NULL}, false, false}},
	 250},
	{"xyzab_tdr_kins", NULL, "BA", "",
	 {{'B', {0, -1, 0}, {"x-rot-point", NULL, "z-rot-point"}, {NULL, NULL, NULL}, false, false},
	  {'A', {-1, 0, 0}, {NULL, "y-rot-point", "z-rot-point"}, {NULL, NULL, "z-offset"}, false, false}},
	 0},
	{"maxkins", NULL, "C", "B",
	 {{'C', {0, 0, -1}, {NULL, NULL, NULL}, {NULL, NULL, NULL}, false, false},
	  {'B', {0, -1, 0}, {NULL, NULL, "pivot-length"}, {NULL, NULL, NULL}, true, false}},
	 0.666},
	{"xyzacb_trsrn", "xyzacb_trsrn_kins", "A", "CB",
	 {{'A', {-1, 0, 0}, {NULL, "y-rot-axis", "z-rot-axis"}, {NULL, NULL, NULL}, false, false},
	  {'C', {0, 0, 1}, {"x-offset", "y-offset", NULL}, {NULL, "y-pivot", NULL}, false, false},
	  {'B', {0, 1, 0}, {NULL, "y-pivot", "z-pivot"}, {NULL, NULL, NULL}, false, true}},
	 0},
	{"xyzbca_trsrn", "xyzbca_trsrn_kins", "B", "CA",
	 {{'B', {0, -1, 0}, {"x-rot-axis", NULL, "z-rot-axis"}, {NULL, NULL, NULL}, false, false},
	  {'C', {0, 0, 1}, {"x-offset", "y-offset", NULL}, {"x-pivot", NULL, NULL}, false, false},
	  {'A', {1, 0, 0}, {"x-pivot", NULL, "z-pivot"}, {NULL, NULL, NULL}, false, true}},
	 0},
};

static bool is_word(const char *text, size_t length, const char *word)
{
	return strlen(word) == length && !strncmp(text, word, length);
}

/* The name of the module: the first word of KINEMATICS. NULL, reported: there is none. */
static bool find_module(const struct reading *r, const struct module **module)
{
	const char *text = ini_file_text(&r->ini, "KINS", "KINEMATICS");
	size_t length = text ? strcspn(text, " \t") : 0;

	*module = NULL;
	if (!length)
		return fault(r,
			     "[KINS] has no KINEMATICS: if this is the ini file of a machine, add [KINS] with "
			     "KINEMATICS = the module that its HAL files load (for example trivkins), and rename "
			     "[AXIS_0] of older releases to [JOINT_0] and so on");
	for (size_t i = 0; i < sizeof(modules) / sizeof(*modules); i++)
		if (is_word(text, length, modules[i].name))
			*module = &modules[i];
	if (*module || is_word(text, length, "trivkins") || is_word(text, length, "gantrykins"))
		return true;
	diag_error(r->diag, place(r),
		   "the kinematics '%.*s' are not supported; supported are the modules trivkins, gantrykins, "
		   "xyzac-trt-kins, xyzbc-trt-kins, xyzab_tdr_kins, xyzacb_trsrn, xyzbca_trsrn, 5axiskins and maxkins",
		   (int)length, text);
	return false;
}

/* The value of a pin of the module; *value has its default. False: reported. */
static bool read_pin(struct reading *r, const struct module *module, const char *pin, bool bit, double *value)
{
	struct strbuf name = {0};
	enum hal_found found;

	strbuf_addf(&name, "%s.%s", module->pins ? module->pins : module->name, pin);
	found = hal_values_find(&r->hal, strbuf_text(&name), bit, value);
	if (found == HAL_SIGNAL)
		diag_warning(r->diag, place(r),
			     "%s is set while the machine runs: it is assumed to be %g; correct the %s of the axis",
			     strbuf_text(&name), *value, bit || !strcmp(pin, "nut-angle") ? "direction" : "location");
	if (found == HAL_DEFAULT && r->hal.scripts)
		diag_warning(r->diag, place(r),
			     "%s is not set in the HAL files, and scripts (.tcl) are not read: it is assumed to be %g",
			     strbuf_text(&name), *value);
	strbuf_release(&name);
	return found != HAL_FAULT;
}

/* Adds the value of a pin of the module. False: reported. */
static bool add_pin(struct reading *r, const struct module *module, const char *pin, double *sum)
{
	double value = pin && !strcmp(pin, "pivot-length") ? module->pivot : 0;

	if (pin && !read_pin(r, module, pin, false, &value))
		return false;
	*sum += r->unit * value;
	return true;
}

/* The direction of a rotary axis of the module. False: reported. */
static bool find_direction(struct reading *r, const struct module *module, const struct rotary *rotary, vec3 *direction)
{
	double conventional = 0, tilt = 0;

	if (rotary->nutating) {
		if (!read_pin(r, module, "nut-angle", false, &tilt))
			return false;
		*direction = vec3_mad((vec3){0, 0, math_cos(radians(tilt))}, math_sin(radians(tilt)),
				      rotary->direction);
		return true;
	}
	if (rotary->turned && !read_pin(r, module, "conventional-directions", true, &conventional))
		return false;
	*direction = vec3_scale(fabs(conventional) > 0 ? -1 : 1, rotary->direction);
	return true;
}

static bool locate(struct reading *r, const struct module *module, const struct rotary *rotary, vec3 *location)
{
	double sum[3] = {0};

	for (int i = 0; i < 3; i++)
		if (!add_pin(r, module, rotary->pins[i], &sum[i]) || !add_pin(r, module, rotary->more[i], &sum[i]))
			return false;
	*location = (vec3){sum[0], sum[1], sum[2]};
	return true;
}

/* ----------------------------------------------------------------- axes */

/* Adds the letters of a text to the joints; blanks are ignored. False: one is not an axis. */
static bool take_letters(struct reading *r, const char *text, size_t length)
{
	size_t joints = 0, axes = 0;

	for (size_t i = 0; i < length; i++) {
		char letter = ascii_upper(text[i]);

		if (ascii_is_space(letter))
			continue;
		if (slot_of_letter(letter) < 0 || joints == sizeof(r->joints) - 1)
			return false;
		r->joints[joints++] = letter;
		if (!memchr(r->order, letter, axes))
			r->order[axes++] = letter;
	}
	return joints > 0;
}

/* The axis of each joint, from coordinates= of the kinematics module, else from [TRAJ]COORDINATES. */
static bool find_joints(struct reading *r)
{
	static const char word[] = "coordinates=";
	const char *kinematics = ini_file_text(&r->ini, "KINS", "KINEMATICS"), *text = strstr(kinematics, word);
	size_t length;

	if (text) {
		text += sizeof(word) - 1;
		length = strcspn(text, " \t");
	} else {
		text = ini_file_text(&r->ini, "TRAJ", "COORDINATES");
		length = text ? strcspn(text, "#;") : 0;
	}
	return (text && take_letters(r, text, length)) ||
	       fault(r, "neither coordinates= of [KINS]KINEMATICS nor COORDINATES of [TRAJ] names the axes");
}

/* Reads [JOINT_n] of each joint of the axis, or [AXIS_L]; of several travels the narrowest is used. */
static bool read_travel(struct reading *r, const char *section, double scale, struct axis_description *axis)
{
	double least = -INFINITY, most = INFINITY, rate = 0, home = NAN;

	if (!ini_file_number(&r->ini, section, "MIN_LIMIT", &least, r->diag) ||
	    !ini_file_number(&r->ini, section, "MAX_LIMIT", &most, r->diag) ||
	    !ini_file_number(&r->ini, section, "MAX_VELOCITY", &rate, r->diag) ||
	    !ini_file_number(&r->ini, section, "HOME", &home, r->diag))
		return false;
	axis->limit_min = fmax(axis->limit_min, scale * least);
	axis->limit_max = fmin(axis->limit_max, scale * most);
	rate *= 60 * (axis->rotary ? 1 : scale);
	/* Some files use a very high rate for none. */
	if (rate > 0 && rate < 1e9 && (!(axis->rate_max > 0) || rate < axis->rate_max))
		axis->rate_max = rate;
	if (!isnan(home) && !axis->home.given && fabs(home) > 0)
		axis->home = (struct optional_number){true, scale * home};
	return true;
}

/* A linear axis without limits never leaves its travel, so no position is rejected. */
static void warn_endless(struct reading *r, char letter)
{
	import_machine_todo(r->machine, "Add limit_min and limit_max of the axis %c.", letter);
	diag_warning(r->diag, place(r),
		     "neither the [JOINT_n] of the axis %c nor [AXIS_%c] has MIN_LIMIT and MAX_LIMIT, so its travel is "
		     "unlimited; add its limits", letter, letter);
}

static bool read_axis(struct reading *r, char letter, bool identity, struct axis_description *axis)
{
	const double scale = axis->rotary ? radians(1) : r->unit;
	struct strbuf section = {0};
	bool good = true, joint = false;

	axis->limit_min = -INFINITY;
	axis->limit_max = INFINITY;
	for (size_t i = 0; good && r->joints[i]; i++) {
		if (r->joints[i] != letter)
			continue;
		strbuf_clear(&section);
		strbuf_addf(&section, "JOINT_%zu", i);
		joint = joint || ini_file_text(&r->ini, strbuf_text(&section), "MAX_LIMIT");
		good = read_travel(r, strbuf_text(&section), scale, axis);
	}
	/* If joints are not axes, the travel of an axis is that of the programmed point. */
	strbuf_clear(&section);
	strbuf_addf(&section, "AXIS_%c", letter);
	if (good && (identity || !joint))
		good = read_travel(r, strbuf_text(&section), scale, axis);
	strbuf_release(&section);
	if (good && axis->home.given)
		axis->home.value = fmin(fmax(axis->home.value, axis->limit_min), axis->limit_max);
	/* Axes without limits have very large ones. */
	if (axis->limit_min <= -linear_limit)
		axis->limit_min = -INFINITY;
	if (axis->limit_max >= linear_limit)
		axis->limit_max = INFINITY;
	if (good && !axis->rotary && isinf(axis->limit_min) && isinf(axis->limit_max))
		warn_endless(r, letter);
	return good && (axis->limit_min < axis->limit_max ||
			fault(r, "the MIN_LIMIT of an axis is not below its MAX_LIMIT"));
}

/* The linear axes carried by the rotary ones of a head. */
static void set_head_direction(struct reading *r, const struct module *module, char letter, vec3 *direction)
{
	const bool both = module->table[0] != '\0';

	/* A quill moves along the tool, outward for positive values. */
	if (letter == 'W')
		*direction = (vec3){0, 0, -1};
	if (!both || (letter != 'U' && letter != 'V'))
		return;
	/* maxkins subtracts both from the position of the tool. */
	*direction = letter == 'U' ? (vec3){-1, 0, 0} : (vec3){0, -1, 0};
	if (letter == 'U')
		diag_warning(r->diag, place(r),
			     "while B is not 0, %s does not treat U as an axis on the head: U is assumed to move "
			     "across the tool; compare it with the machine", module->name);
}

static bool make_axis(struct reading *r, const struct module *module, char letter, bool carries_work,
		      struct axis_description *axis)
{
	const struct rotary *known = NULL;

	*axis = (struct axis_description){.slot = slot_of_letter(letter)};
	axis->rotary = slot_is_rotary(axis->slot);
	axis->direction = axis_chains_direction(axis->slot, carries_work);
	for (int i = 0; module && i < ROTARY_MAX; i++)
		known = module->rotary[i].letter == letter ? &module->rotary[i] : known;
	if (known) {
		axis->has_location = true;
		if (!find_direction(r, module, known, &axis->direction) || !locate(r, module, known, &axis->location))
			return false;
	} else if (axis->rotary) {
		axis->has_location = true;
		import_machine_todo(
		    r->machine, "Where is the axis %c? The imported file does not say it; 0 0 0 is a guess.",
		    letter);
		diag_warning(r->diag, place(r), "this file does not say where the axis %c is: correct its location",
			     letter);
	}
	if (module && module->pivot > 0)
		set_head_direction(r, module, letter, &axis->direction);
	return read_axis(r, letter, !module, axis);
}

/* ---------------------------------------------------------------- chain */

/* The axes that carry the work: those of the user, else those that the module defines. */
static bool find_table(const struct reading *r, const struct module *module, struct axis_letters *table)
{
	if (!axis_letters_read(table, "table", r->options->table, r->order, r->diag))
		return false;
	if (!module && !r->options->table)
		return fault(r,
			     "this file does not say which axes carry the work and which the tool: name those that "
			     "carry the work, in order from the base, with --table=LETTERS, such as --table=YAC, or "
			     "--table= for none");
	for (const char *at = module ? module->table : ""; *at; at++)
		axis_letters_add(table, *at);
	return true;
}

/* Appends the axes between two slots that do not carry the work. */
static void add_missing(struct axis_letters *axes, const char *order, const char *table, int first, int last)
{
	for (const char *at = order; *at; at++)
		if (slot_of_letter(*at) >= first && slot_of_letter(*at) <= last && !axis_letters_have(table, *at))
			axis_letters_add(axes, *at);
}

/* The axes that carry the tool. A module with a head knows the order of its rotary axes. */
static bool find_head(const struct reading *r, const struct module *module, const char *table,
		      struct axis_letters *head)
{
	struct axis_letters axes = {""};

	if (module && r->options->head)
		return fault(r, "the kinematics define which axes carry the tool: remove --head");
	if (!module)
		return axis_letters_head(head, r->options->head, r->order, table, place(r), r->diag);
	add_missing(&axes, r->order, table, SLOT_X, SLOT_Z);
	for (const char *at = module->head; *at; at++)
		if (axis_letters_have(r->order, *at) && !axis_letters_have(table, *at))
			axis_letters_add(&axes, *at);
	add_missing(&axes, r->order, table, SLOT_A, SLOT_C);
	add_missing(&axes, r->order, table, SLOT_U, SLOT_W);
	*head = axes;
	return true;
}

static bool add_chains(struct reading *r, const struct module *module)
{
	struct axis_description axes[SLOT_COUNT];
	struct axis_letters table, head;

	if (!find_table(r, module, &table) || !find_head(r, module, table.text, &head))
		return false;
	for (const char *at = table.text; *at; at++)
		if (!make_axis(r, module, *at, true, &axes[slot_of_letter(*at)]))
			return false;
	for (const char *at = head.text; *at; at++)
		if (!make_axis(r, module, *at, false, &axes[slot_of_letter(*at)]))
			return false;
	axis_chains_hang(r->machine, axes, table.text, head.text);
	return true;
}

static bool find_unit(struct reading *r)
{
	const char *text = ini_file_text(&r->ini, "TRAJ", "LINEAR_UNITS");
	double value;

	r->unit = 1;
	if (!text || ascii_same_start(text, "mm", 2) || ascii_same_start(text, "metric", 6))
		return text || fault(r, "[TRAJ] has no LINEAR_UNITS");
	if (ascii_same_start(text, "in", 2) || ascii_same_start(text, "imperial", 8)) {
		r->unit = MM_PER_INCH;
		return true;
	}
	/* A number is the number of units in a millimetre. */
	if (!decimal_read(text, strcspn(text, " \t"), &value) || !(value > 1e-3 && value < 1e3))
		return fault(r, "LINEAR_UNITS of [TRAJ] must be mm or inch");
	r->unit = 1 / value;
	return true;
}

static bool read_machine(struct reading *r)
{
	struct import_machine *machine = r->machine;
	const char *name = ini_file_text(&r->ini, "EMC", "MACHINE");
	const struct module *module;

	if (!find_module(r, &module) || !find_joints(r) || !find_unit(r) ||
	    (module && !hal_values_read(&r->hal, &r->ini, r->diag)) || !add_chains(r, module))
		return false;
	machine->description.name = name ? arena_strdup(&machine->description.arena, name) : NULL;
	machine->dialect_known = machine->rapid_known = true;
	/* Numbered parameters, and programs before any G20 or G21, are in the units of the control. */
	machine->inch = fabs(1 / r->unit - 1 / MM_PER_INCH) < rounded_units;
	import_machine_todo(machine, "The ini file has no bodies: add <body> elements, drawn with every axis at 0%s.",
			    machine->inch ? "; if their meshes are in mm, with units=\"mm\"" : "");
	import_machine_todo(machine,
			    "The gauge point of the spindle and the mount of the work are at 0 0 0: correct both.");
	if (module && !r->options->table)
		import_machine_todo(machine,
				    "All linear axes carry the tool here: name those that carry the work with the "
				    "option table of import.");
	if (module && module->pivot > 0)
		import_machine_todo(
		    machine, "The pivot length is assumed to reach from the axis B to the gauge point of the spindle.");
	return true;
}

bool emc_machine_read(struct import_machine *machine, const char *path, const struct import_options *options,
		      struct diag *diag)
{
	struct reading r = {.machine = machine, .options = options, .diag = diag, .path = path};
	bool good = ini_file_read(&r.ini, path, diag) && read_machine(&r);

	hal_values_release(&r.hal);
	ini_file_release(&r.ini);
	return good;
}
