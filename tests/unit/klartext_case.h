/* klartext_case.h - Klartext programs for gcode_case.h: a control with tools, presets, and a tool change that stays. */
#ifndef KLARTEXT_CASE_H
#define KLARTEXT_CASE_H

#include "gcode_case.h"

static const struct tool klartext_tools[] = {
	{.number = 1, .name = "MILL 10", .length = 100, .length_offset = 100, .diameter = 10},
	{.number = 2, .name = "DRILL 5", .length = 40, .length_offset = 40, .diameter = 5, .point_angle = 1.5707963267948966},
	{.number = 3, .name = "TWIN", .length = 10, .length_offset = 10},
	{.number = 4, .name = "TWIN", .length = 20, .length_offset = 20},
	{.number = 6, .name = "1.2", .length = 30, .length_offset = 30},
};
static const struct work_offset klartext_presets[] = {
	{.name = "G54.1 P1", .value = {{0}}},
	{.name = "G54.1 P2", .value = {{10, 20, 30}}},
};
static const struct mcode klartext_mcodes[] = {{57, MCODE_IGNORE}, {60, MCODE_SPINDLE_ON}};

static inline void klartext_case(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_klartext;
	c->config.controller.tool_change.given = true;
	c->config.controller.mcodes = klartext_mcodes;
	c->config.controller.mcode_count = 2;
	c->config.controller.cycle_19_angles = CYCLE_19_ANGLES_SPATIAL;
	c->config.has_setup = true;
	c->config.tools = klartext_tools;
	c->config.tool_count = 5;
	c->config.work_offsets = klartext_presets;
	c->config.work_offset_count = 1;
}

/* The blocks between BEGIN PGM T MM and END PGM T MM; line 2 is the first of them. */
static inline bool klartext_run(struct gcode_case *c, const char *blocks)
{
	struct strbuf text = {0};
	bool good;

	strbuf_addf(&text, "0 BEGIN PGM T MM\n%sEND PGM T MM\n", blocks);
	good = case_run(c, strbuf_text(&text));
	strbuf_release(&text);
	return good;
}

struct klartext_program {
	const char *blocks;
	const char *moves;
};

/* The blocks are accepted without a message, and make just these moves. */
static inline void klartext_expect(const struct klartext_program *program, bool show_spread)
{
	struct gcode_case c;
	bool good;

	klartext_case(&c);
	c.show_spread = show_spread;
	good = klartext_run(&c, program->blocks);
	ck_assert_msg(good, "%s%s", program->blocks, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	ck_assert_msg(!strcmp(strbuf_text(&c.moves), program->moves), "%s makes\n%s and not\n%s", program->blocks,
		      strbuf_text(&c.moves), program->moves);
	case_release(&c);
}

struct klartext_fault {
	const char *blocks;
	const char *message; /* the first line of what is said */
};

/* The blocks are refused with one fault, just this one. */
static inline void klartext_expect_fault(const struct klartext_fault *expected)
{
	const size_t length = strlen(expected->message);
	struct gcode_case c;
	const char *said;

	klartext_case(&c);
	ck_assert_msg(!klartext_run(&c, expected->blocks), "%s passes", expected->blocks);
	said = strbuf_text(&c.messages);
	ck_assert_msg(!strncmp(said, expected->message, length) && said[length] == '\n', "%s: %s", expected->blocks, said);
	ck_assert_uint_eq(c.diag.errors, 1);
	case_release(&c);
}

#endif
