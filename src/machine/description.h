/*
 * description.h - the contents of a machine, setup or waivers file as plain data. Readers of file formats fill it in;
 * machine_build, setup_build and waivers_build check it.
 */
#ifndef FIVECHECK_MACHINE_DESCRIPTION_H
#define FIVECHECK_MACHINE_DESCRIPTION_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/axes.h"
#include "base/diag.h"
#include "control/controller.h"
#include "control/offset_tables.h"
#include "geom/xform.h"
#include "machine/body.h"
#include "machine/tool_solid.h"

/*
 * Lengths are in mm and angles in radians, whatever the file's units are. Strings and arrays must live as long as the
 * machine or setup that is built from them, so a reader allocates them in the arena. Every struct has an `at`, by which
 * the reader finds its place in the file; it is valid until the reader closes the file.
 */

/* A text from a file for a message: shortened, with control characters replaced. */
struct quotation {
	char text[84];
};

/* The file behind a description. */
struct description_file {
	const char *path;
	size_t faults;	/* reported by description_fault */
	void *reader;	/* first argument of the functions */
	/*
	 * Reports an error at `at`, or at one of its attributes (NULL: at the whole element). Attributes have their XML
	 * names.
	 */
	void (*report)(void *reader, const void *at, const char *attribute, const char *format, va_list args)
		__attribute__((format(printf, 4, 0)));
	/* The text of an attribute as written in the file; empty if it is absent. */
	struct quotation (*quote)(void *reader, const void *at, const char *attribute);
	long (*line)(void *reader, const void *at);
};

void description_fault(struct description_file *file, const void *at, const char *attribute, const char *format, ...)
	__attribute__((format(printf, 4, 5)));
struct quotation description_quote(const struct description_file *file, const void *at, const char *attribute);
struct srcloc description_place(const struct description_file *file, const void *at);

/* A number that the file may omit. */
struct optional_number {
	bool given;
	double value;	/* 0 if not given */
};

struct mcode_description {
	const void *at;
	long number;
	enum mcode_action action;
};

struct macro_description {
	const void *at;
	bool has_program;	/* false: only the code identifies it */
	long program;
	const char *name;	/* given instead of a number; or NULL */
	struct optional_number code;
	enum macro_action action;
	struct optional_number around[SLOT_COUNT];
};

struct variable_description {
	const void *at;
	const char *name, *value, *size;	/* NULL: it is not given */
	int type;	/* an enum control_type; -1: not given */
};

/* <reference>, <tool_change> and <swivel_retract>. */
struct place_description {
	const void *at;
	bool tool_change, swivel_retract;	/* else a reference position */
	long number;	/* of a reference position */
	struct optional_number value[SLOT_COUNT];
	const char *order;	/* axis letters, with or without blanks between them; or NULL */
};

struct controller_description {
	const void *at;	/* NULL: the file has no such element */
	struct controller told;	/* the simple attributes; does not include the members below */
	struct optional_number path_tolerance;
	struct optional_number least_input;
	struct optional_number overrun;	/* of G60 */
	struct optional_number arc_radius_tolerance;
	const char *preset;	/* or NULL */
	struct mcode_description *mcodes;
	size_t mcode_count;
	struct macro_description *macros;
	size_t macro_count;
	struct variable_description *variables;
	size_t variable_count;
	struct place_description *places;
	size_t place_count;
};

/* The way in which the mesh of the stock is given. */
enum stock_shape { STOCK_MESH, STOCK_BOX, STOCK_CYLINDER };

struct body_description {
	const void *at;
	const char *name;
	const char *mesh_path;	/* as it can be opened */
	double scale;	/* mm per unit of the mesh */
	xform frame;	/* the mesh's origin on its link or on the workholding */
	enum body_role role;
	/* of a part: the permitted depths of a cutter; the first one also of the stock */
	struct optional_number rapid_allowance, gouge;
	enum stock_shape shape;	/* of the stock; the origin of a box or cylinder is the middle of its lower face */
	vec3 size;	/* mm: of the box; of the cylinder: diameter, 0, height */
	struct optional_number uncertainty, excess;	/* of the stock */
	const char *checked;	/* or NULL */
	int link;	/* of a machine's own body: 0 the base, else 1 + the number of its axis in the description */
};

struct axis_description {
	const void *at;
	int slot;
	const char *title;	/* or NULL */
	const char *checked;	/* or NULL */
	bool rotary;	/* as in the file; may contradict the letter */
	int parent;	/* the link that carries it */
	vec3 direction;	/* of any length */
	bool has_location;
	vec3 location;
	double limit_min, limit_max;	/* -INFINITY, INFINITY: none */
	double rate_max;	/* mm or degrees a minute */
	struct optional_number home;
	enum wrap wrap;
	int half_turn;	/* 1, -1; 0: not given */
};

struct spindle_description {
	const void *at;
	int link;
	vec3 location, direction;
	const char *checked;	/* or NULL */
};

struct workholding_description {
	const void *at;
	int link;
	xform frame;
	const char *checked;	/* or NULL */
};

struct pair_description {
	const void *at;
	const char *a, *b;
	enum rule_check check;
	struct optional_number clearance;
	const char *reason;	/* or NULL */
};

struct machine_description {
	struct arena arena;	/* machine_build takes it over */
	struct description_file file;
	const char *name;	/* or NULL */
	double unit;	/* mm per unit of length of the control */
	struct controller_description controller;
	const void *base;
	const char *base_checked;	/* or NULL */
	struct axis_description *axes;	/* an axis comes before the axes that it carries */
	size_t axis_count;
	struct body_description *bodies;
	size_t body_count;
	struct spindle_description *spindles;
	size_t spindle_count;
	struct workholding_description *workholdings;
	size_t workholding_count;
	const void *pairs_at;	/* NULL: the file has no <pairs> */
	struct optional_number adjacent_within;
	struct pair_description *pairs;
	size_t pair_count;
	struct setup_description *setup;	/* from inside the machine's file, or NULL */
};

/* The pieces of a tool, from the gauge line downward. */
enum tool_piece { PIECE_HOLDER, PIECE_SHANK, PIECE_CUTTER, TOOL_PIECES };

struct section_description {
	const void *at;
	double length, diameter;
	struct optional_number diameter_end;
};

struct piece_description {
	const void *at;	/* NULL: the tool has no such piece */
	const char *mesh_path;	/* or NULL */
	double scale;	/* mm per unit of the mesh */
	bool has_units;
	struct section_description *sections;
	size_t section_count;
	bool has_tip;	/* the file names it */
	enum tool_tip tip;
	struct optional_number angle, corner, flute_length;
};

struct tool_description {
	const void *at;
	long number;
	const char *name;	/* or NULL */
	const char *checked;	/* or NULL */
	double length;
	struct optional_number length_offset, radius_offset, diameter;
	bool deltas;	/* both offsets include DL and DR of a tool table, which are not 0 */
	enum tool_kind kind;
	enum tool_hand hand;
	struct piece_description pieces[TOOL_PIECES];
};

struct edge_description {
	const void *at;
	long tool, number;
	double length;
	struct optional_number diameter;
	bool no_radius;	/* the control's radius is 0 or less, so programs cannot compensate */
};

struct work_offset_description {
	const void *at;
	const char *name;
	const char *checked;	/* or NULL */
	struct optional_number value[SLOT_COUNT];
};

/* <offset>: the H and the D of one number. */
struct length_offset_description {
	const void *at;
	long number;
	struct optional_number length, radius;	/* at least one of them */
	bool d_of_control;	/* the radius may be a diameter, depending on the control's cutter_comp_d */
	bool of_tool;	/* both are the control's only values for the tool with this number */
};

/*
 * A row of a control's tool table, from <tools>: the values of one of the setup's tools, which <tools> puts into that
 * tool. A row without a tool of the setup has no effect.
 */
struct tool_values_description {
	const void *at;
	long number;
	const char *key;	/* the name of the setup's tool; NULL: its number decides */
	const char *name;	/* by which programs call the tool; NULL: that of the setup */
	bool part;	/* the values are not those of the tip */
	long edge;	/* above 1: the values are those of an edge of the tool */
	double length, radius;	/* with which the control compensates */
	bool deltas;	/* they include DL and DR, which are not 0 */
};

/* <tools>: a file of another program. */
struct library_description {
	const void *at;
	const char *path;	/* as it can be opened */
	double unit;	/* mm per unit of length, if the file does not give its own */
	const char *numbers;	/* as in "1 3 10-20", or NULL: all */
};

struct setup_description {
	struct arena arena;	/* setup_build takes it over */
	struct description_file file;
	const void *at;
	long initial_tool;	/* 0: none */
	struct work_offset_description *offsets;
	size_t offset_count;
	struct length_offset_description *lengths;
	size_t length_count;
	struct body_description *bodies;	/* fixtures, parts, the stock */
	size_t body_count;
	struct tool_description *tools;
	size_t tool_count;
	struct tool_values_description *values;
	size_t value_count;
	struct edge_description *edges;	/* of all tools */
	size_t edge_count;
	struct library_description *libraries;
	size_t library_count;
	struct variable_description *variables;
	size_t variable_count;
};

struct waiver_description {
	const void *at;
	const char *program, *kind, *reason, *block;
	const char *a, *b, *axis;	/* or NULL */
	const char *axes;	/* "X 10.0000 mm, C 90.0000 deg" */
	const char *expires;	/* a date, "2026-12-31" */
	struct optional_number within;	/* mm and degrees */
	long times;
};

struct waivers_description {
	struct arena arena;	/* waivers_build takes it over */
	struct description_file file;
	struct waiver_description *items;
	size_t count;
};

#endif
