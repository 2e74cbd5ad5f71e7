/* test_tool_check.c - doubts about tools, with values on both sides of each threshold. */
#include "scene/tool_check.h"

#include "model_case.h"
#include "suite.h"

static const struct doubt *check(const struct model *model, struct doubts *doubts, enum doubt_kind kind)
{
	const struct doubt *doubt;

	doubts_release(doubts);
	*doubts = (struct doubts){0};
	tool_check(model->scene, doubts);
	doubt = model_doubt(doubts, kind);
	require(doubts->count == (doubt != NULL), "%zu doubts, not of kind %d alone", doubts->count, (int)kind);
	return doubt;
}

/* A holder that is thick only away from the gauge line is upside down. */
START_TEST(holder)
{
	struct tool_section sections[2] = {{30, 60, 60}, {40, 40, 30}};
	const struct tool_solid solid = {.sections = sections, .count = 2};
	const struct doubt *doubt;
	struct doubts doubts = {0};
	struct model model;

	model_init(&model);
	model_tool(&model, 7, 70);
	model_piece(&model, ROLE_HOLDER, 7, &solid);
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_HOLDER_TURNED));
	sections[0].diameter = 36.1;
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_HOLDER_TURNED));
	sections[0].diameter = 35.9;
	doubt = check(&model, &doubts, DOUBT_HOLDER_TURNED);
	ck_assert_ptr_nonnull(doubt);
	ck_assert_double_eq_tol(doubt->value, 35.9, 1e-12);
	ck_assert_double_eq_tol(doubt->limit, 60, 1e-12);
	ck_assert_uint_eq(doubt->item, 0);
	/* A cutter may be thicker below; a probe need not look like the holder of a cutter. */
	model.bodies[0].role = ROLE_CUTTER;
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_HOLDER_TURNED));
	model.bodies[0].role = ROLE_HOLDER;
	model.tools[0].kind = TOOL_PROBES;
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_HOLDER_TURNED));
	model.tools[0].kind = TOOL_TURNS;
	model.tools[0].checked = "r";
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_HOLDER_TURNED));
	doubts_release(&doubts);
	model_release(&model);
}
END_TEST

/* A prism of radius 10 about a line `aside` mm beside Z, from the gauge line to `end` mm below it. */
static int drawn_piece(struct model *model, enum body_role role, int tool, double aside, double end)
{
	struct mesh mesh = {0};
	xform place = xform_identity();

	solid_prism(&mesh, 16, 10, 0.5 * end, 1);
	place.translation = (vec3){aside, 0, -0.5 * end};
	solid_place(&mesh, &place);
	return model_mesh(model, model_piece(model, role, tool, NULL), &mesh);
}

/* A drawn tool ends at its tip, to within 1 mm or a hundredth of its length. */
START_TEST(ends)
{
	static const struct {
		double length, end;
		enum body_role role;
		bool doubted;
	} cases[] = {
		{80, 80, ROLE_CUTTER, false}, {80, 80.9, ROLE_CUTTER, false}, {80, 81.1, ROLE_CUTTER, true},
		{80, 79.1, ROLE_CUTTER, false}, {80, 78.9, ROLE_CUTTER, true}, {300, 302.9, ROLE_CUTTER, false},
		{300, 303.1, ROLE_CUTTER, true}, {300, 296.9, ROLE_CUTTER, true}, {300, 297.1, ROLE_CUTTER, false},
		/* Without a cutter it may end before the tip, but a tenth of its length must be drawn. */
		{300, 150, ROLE_HOLDER, false}, {300, 30.5, ROLE_HOLDER, false}, {300, 29.5, ROLE_HOLDER, true},
		{300, 303.1, ROLE_HOLDER, true},
	};

	for (int i = 0; i < COUNT(cases); i++) {
		const struct doubt *doubt;
		struct doubts doubts = {0};
		struct model model;

		model_init(&model);
		model_tool(&model, 3, cases[i].length);
		drawn_piece(&model, cases[i].role, 3, 0, cases[i].end);
		doubt = check(&model, &doubts, DOUBT_TOOL_ENDS);
		require((doubt != NULL) == cases[i].doubted, "case %d", i);
		if (doubt) {
			ck_assert_double_eq_tol(doubt->value, cases[i].end, 1e-4);
			ck_assert_double_eq_tol(doubt->limit, cases[i].length, 1e-12);
		}
		doubts_release(&doubts);
		model_release(&model);
	}
}
END_TEST

/* Of drawn pieces and pieces made of sections, the lowest end counts. */
START_TEST(pieces_of_both_kinds)
{
	const struct tool_section section = {50, 8, 8};
	struct tool_solid cutter = {.sections = &section, .count = 1, .top = -50};
	struct doubts doubts = {0};
	struct model model;

	model_init(&model);
	model_tool(&model, 3, 100);
	drawn_piece(&model, ROLE_HOLDER, 3, 0, 50);
	model_piece(&model, ROLE_CUTTER, 3, &cutter);
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_TOOL_ENDS));
	cutter.top = -47;
	ck_assert_ptr_nonnull(check(&model, &doubts, DOUBT_TOOL_ENDS));
	/* The bodies of another tool do not count. */
	model.bodies[1].tool = 4;
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_TOOL_ENDS));
	doubts_release(&doubts);
	model_release(&model);
}
END_TEST

START_TEST(aside)
{
	static const double asides[] = {0, 4.9, 5.1, -4.9, -5.1};

	for (int i = 0; i < COUNT(asides); i++) {
		for (int cutter = 0; cutter < 2; cutter++) {
			const struct doubt *doubt;
			struct doubts doubts = {0};
			struct model model;

			model_init(&model);
			model_tool(&model, 3, 90);
			drawn_piece(&model, cutter ? ROLE_CUTTER : ROLE_HOLDER, 3, asides[i], 90);
			doubt = check(&model, &doubts, DOUBT_TOOL_ASIDE);
			/* A cutter may turn about another line than its middle, like a boring bar. */
			require((doubt != NULL) == (!cutter && fabs(asides[i]) > 5), "%g mm aside", asides[i]);
			if (doubt) {
				ck_assert_int_eq(doubt->body, 0);
				ck_assert_double_eq_tol(doubt->value, fabs(asides[i]), 1e-4);
			}
			doubts_release(&doubts);
			model_release(&model);
		}
	}
}
END_TEST

START_TEST(radius)
{
	const struct doubt *doubt;
	struct doubts doubts = {0};
	struct model model;

	model_init(&model);
	model_tool(&model, 5, 90);
	model_tool(&model, 6, 90);
	model.tools[0].diameter = 10;
	model.radii[0] = (struct radius_offset){5, 5};
	model.radii[1] = (struct radius_offset){6, 50};
	model.setup.radius_count = 2;
	/* If the diameter of a tool is not known, there is no doubt. */
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_RADIUS_OFFSET));
	model.radii[0].radius = 7.4;
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_RADIUS_OFFSET));
	model.radii[0].radius = 7.6;
	doubt = check(&model, &doubts, DOUBT_RADIUS_OFFSET);
	ck_assert_ptr_nonnull(doubt);
	ck_assert_double_eq_tol(doubt->value, 7.6, 1e-12);
	ck_assert_double_eq_tol(doubt->limit, 10, 1e-12);
	ck_assert_uint_eq(doubt->item, 0);
	model.tools[0].checked = "r";
	ck_assert_ptr_null(check(&model, &doubts, DOUBT_RADIUS_OFFSET));
	doubts_release(&doubts);
	model_release(&model);
}
END_TEST

/* The position of the machine does not matter for its tools. */
START_TEST(moved)
{
	struct random random = random_case(1, 0);

	for (int i = 0; i < 20; i++) {
		const xform by = random_place(&random, 1000);
		struct doubts doubts = {0};
		struct model model;

		model_init(&model);
		model_tool(&model, 3, 80);
		drawn_piece(&model, ROLE_HOLDER, 3, i % 2 ? 6 : 0, i % 2 ? 80 : 85);
		model_move(&model, &by);
		ck_assert_ptr_nonnull(check(&model, &doubts, i % 2 ? DOUBT_TOOL_ASIDE : DOUBT_TOOL_ENDS));
		doubts_release(&doubts);
		model_release(&model);
	}
}
END_TEST

/* A name that gives twice the diameter, and not the diameter itself. */
START_TEST(name)
{
	static const struct {
		const char *name;
		double diameter;
		bool doubted;
	} cases[] = {
		{"ball 10", 5, true}, {"ball 10", 10, false}, {"EM10", 5, true}, {"D=12,7 flat", 6.35, true}, {"5 x 10", 5, false},
		{"1/2 EM", 6.35, true}, {"1/2 EM", 12.7, false}, {"ball R10", 5, false}, {"T10", 5, false}, {"L=10", 5, false},
		{"cutter 7", 3.5, false}, {"taper 10 deg", 5, false}, {"taper 10\xc2\xb0", 5, false}, {".5 flat", 6.35, true},
		{"", 5, false}, {"ball 10", 0, false}, {"ball 10", 20, false},
	};

	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const struct doubt *doubt;
		struct doubts doubts = {0};
		struct model model;

		model_init(&model);
		model_tool(&model, 7, 90);
		model.tools[0].name = cases[i].name;
		model.tools[0].diameter = cases[i].diameter;
		doubt = check(&model, &doubts, DOUBT_TOOL_NAME);
		ck_assert_msg((doubt != NULL) == cases[i].doubted, "%s, %g", cases[i].name, cases[i].diameter);
		ck_assert(!doubt || fabs(doubt->limit - 2 * cases[i].diameter) < 1e-9);
		model.tools[0].checked = "r";
		ck_assert_ptr_null(check(&model, &doubts, DOUBT_TOOL_NAME));
		doubts_release(&doubts);
		model_release(&model);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {holder, ends, pieces_of_both_kinds, aside, radius, moved, name};

	return RUN_TESTS("tool_check", tests);
}
