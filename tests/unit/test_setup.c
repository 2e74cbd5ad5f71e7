/* test_setup.c - valid setup files. */
#include <math.h>

#include "base/units.h"
#include "machine/tool_solid.h"
#include "setup_case.h"

static struct setup *load_good(const char *content)
{
	struct messages messages;
	struct setup *setup;

	messages_init(&messages);
	write_text("s.xml", content);
	setup = setup_load("s.xml", machine, &messages.diag);
	ck_assert_str_eq(strbuf_text(&messages.text), "");
	ck_assert_ptr_nonnull(setup);
	strbuf_release(&messages.text);
	return setup;
}

static void assert_vec3(vec3 v, double x, double y, double z)
{
	ck_assert_double_eq_tol(v.x, x, 1e-12);
	ck_assert_double_eq_tol(v.y, y, 1e-12);
	ck_assert_double_eq_tol(v.z, z, 1e-12);
}

START_TEST(reads_offsets_and_lengths)
{
	struct setup *s = load_good(job);

	ck_assert_str_eq(s->path, "s.xml");
	ck_assert_int_eq(s->initial_tool, 12);
	ck_assert_uint_eq(s->offset_count, 2);
	ck_assert_str_eq(s->offsets[0].name, "G54");
	ck_assert_double_eq(s->offsets[0].value.v[SLOT_X], 1);
	ck_assert_double_eq_tol(s->offsets[0].value.v[SLOT_C], -PI / 2, 1e-15);
	ck_assert_str_eq(s->offsets[1].name, "G59.3");
	ck_assert_double_eq(s->offsets[1].value.v[SLOT_X], 0);
	/* An <offset> has precedence over the tool with its number; tool 3 has its own length. */
	ck_assert_uint_eq(s->length_count, 3);
	ck_assert_int_eq(s->lengths[0].number, 12);
	ck_assert_double_eq(s->lengths[0].length, 131);
	ck_assert_int_eq(s->lengths[1].number, 7);
	ck_assert_double_eq(s->lengths[1].length, -5);
	ck_assert_int_eq(s->lengths[2].number, 3);
	ck_assert_double_eq(s->lengths[2].length, 80);
	setup_free(s);
}
END_TEST

START_TEST(reads_tools)
{
	struct setup *s = load_good(job);
	const struct tool *tool = setup_tool(s, 12);

	ck_assert_uint_eq(s->tool_count, 2);
	ck_assert_str_eq(tool->name, "ball 10");
	ck_assert_double_eq(tool->length, 130);
	ck_assert_double_eq(tool->length_offset, 129.5);
	ck_assert_double_eq(tool->diameter, 10);
	ck_assert_int_eq(tool->line, 3);
	tool = setup_tool(s, 3);
	ck_assert_str_eq(tool->name, "");
	ck_assert_double_eq(tool->length_offset, 80);
	ck_assert_double_eq(tool->diameter, 6);
	ck_assert_ptr_null(setup_tool(s, 4));
	setup_free(s);
}
END_TEST

START_TEST(reads_bodies)
{
	static const char *const names[] = {"blade", "vise", "T12 holder", "T12 shank",
					    "T12 cutter", "T3 holder", "T3 shank", "T3 cutter"};
	static const enum body_role roles[] = {ROLE_PART, ROLE_FIXTURE, ROLE_HOLDER, ROLE_SHANK,
					       ROLE_CUTTER, ROLE_HOLDER, ROLE_SHANK, ROLE_CUTTER};
	struct setup *s = load_good(job);
	const struct body *b = s->bodies;

	ck_assert_uint_eq(s->body_count, 8);
	for (size_t i = 0; i < 8; i++) {
		ck_assert_str_eq(b[i].name, names[i]);
		ck_assert_int_eq(b[i].role, roles[i]);
		ck_assert_int_eq(b[i].link, i < 2 ? 2 : 1);
		ck_assert_int_eq(b[i].tool, i < 2 ? 0 : i < 5 ? 12 : 3);
		ck_assert_ptr_nonnull(b[i].loc.file);
		ck_assert((b[i].mesh_path == NULL) == (b[i].profile != NULL));
	}
	ck_assert_str_eq(b[0].mesh_path, "blade.stl");
	ck_assert_double_eq(b[0].scale, 1000);
	/* The workholding is rotated: x becomes y. */
	assert_vec3(xform_apply(&b[0].placement, (vec3){1, 0, 0}), 5, 1, 100);
	assert_vec3(xform_apply(&b[1].placement, (vec3){1, 0, 0}), 4, 0, 40);
	ck_assert_str_eq(b[1].mesh_path, "/v/vise.stl");
	ck_assert_str_eq(b[7].mesh_path, "c.stl");
	ck_assert_double_eq(b[7].scale, 25.4);
	ck_assert_double_eq(b[2].scale, 1);
	ck_assert_int_eq(b[2].loc.line, 5);
	setup_free(s);
}
END_TEST

/* The bounds of the triangles that the scene makes of the piece. */
static void piece_bounds(const struct tool_solid *profile, vec3 *least, vec3 *greatest)
{
	struct arena arena = {0};
	struct mesh mesh;

	tool_solid_mesh(profile, &arena, &mesh);
	mesh_bounds(&mesh, least, greatest);
	arena_release(&arena);
}

/* The ends of the tessellated pieces along -Z, and that -Z becomes the direction of the spindle. */
START_TEST(stacks_and_places_tools)
{
	struct setup *s = load_good(job);
	const double ends[3][2] = {{0, -65}, {-65, -90}, {-90, -130}};
	vec3 least, greatest;

	for (int i = 0; i < 3; i++) {
		piece_bounds(s->bodies[2 + i].profile, &least, &greatest);
		ck_assert_double_eq_tol(greatest.z, ends[i][0], 1e-3);
		ck_assert_double_eq_tol(least.z, ends[i][1], 1e-3);
		ck_assert_double_ge(greatest.z, ends[i][0]);
		ck_assert_double_le(least.z, ends[i][1]);
	}
	for (int i = 2; i < 8; i++) {
		assert_vec3(xform_apply(&s->bodies[i].placement, (vec3){0, 0, -10}), 1, 2 + 6, 300 + 8);
		assert_vec3(mat3_mul(&s->bodies[i].placement.rotation, &s->bodies[i].placement.rotation).x, 1, 0, 0);
	}
	setup_free(s);
}
END_TEST

/* Sections below a mesh end at the tip; those above it begin at the gauge line. */
START_TEST(stacks_around_meshes)
{
	struct setup *s = load_good(SETUP(
	    "<tool number='1' length='100'><holder mesh='h.stl'/><shank>" SECTION("20", "6") "</shank><cutter>" SECTION(
		"30", "5")
		SECTION("10",
			"8") "</cutter></tool>"
			     "<tool number='2' length='100'><holder>" SECTION("20", "50") "</holder><shank>" SECTION(
				 "20", "6") "</shank><cutter mesh='c.stl'/></tool>"));
	vec3 least, greatest;

	piece_bounds(s->bodies[1].profile, &least, &greatest);
	ck_assert_double_eq_tol(greatest.z, -40, 1e-3);
	ck_assert_double_eq_tol(least.z, -60, 1e-3);
	piece_bounds(s->bodies[2].profile, &least, &greatest);
	ck_assert_double_eq_tol(greatest.z, -60, 1e-3);
	ck_assert_double_eq_tol(least.z, -100, 1e-3);
	ck_assert_double_eq(setup_tool(s, 1)->diameter, 8);
	piece_bounds(s->bodies[4].profile, &least, &greatest);
	ck_assert_double_eq_tol(greatest.z, -20, 1e-3);
	ck_assert_double_eq_tol(least.z, -40, 1e-3);
	ck_assert_double_eq(setup_tool(s, 2)->diameter, 0);
	setup_free(s);
}
END_TEST

START_TEST(spindles_up_and_down)
{
	static const char *const directions[] = {"0 0 -1", "0 0 1", "0 0.000001 1", "1 0 0"};
	static const double tips[][3] = {{0, 0, -1}, {0, 0, 1}, {0, 1e-6, 1}, {1, 0, 0}};
	struct diag diag = {0};
	char text[300];

	for (int i = 0; i < 4; i++) {
		struct machine *m;
		mat3 r;

		snprintf(text, sizeof(text),
			 "<machine version='1'><base><spindle location='0 0 0' direction='%s'/></base>"
			 "<setup><tool number='1' length='9'><cutter mesh='c.stl'/></tool></setup></machine>",
			 directions[i]);
		write_text("m.xml", text);
		m = machine_load("m.xml", &diag);
		ck_assert_ptr_nonnull(m);
		r = m->setup->bodies[0].placement.rotation;
		assert_vec3(mat3_apply(&r, (vec3){0, 0, -1}), tips[i][0], tips[i][1], tips[i][2]);
		ck_assert_double_eq_tol(vec3_dot(vec3_cross(r.x, r.y), r.z), 1, 1e-12);
		ck_assert_double_eq_tol(vec3_dot(r.x, r.y), 0, 1e-12);
		machine_free(m);
	}
}
END_TEST

START_TEST(inches)
{
	struct setup *s = load_good("<setup version='1' units='inch'><work_offset name='G54' X='1' C='180'/>"
				    "<part name='p' mesh='p.stl' location='1 0 0'/><offset number='9' length='2'/>"
				    "<offset number='21' radius='0.5'/><offset number='22' length='1' radius='-1'/>"
				    "<tool number='1' length='2'><cutter tip='bull' corner='0.1'><section length='2' "
				    "diameter='0.5'/></cutter></tool></setup>");
	vec3 least, greatest;

	ck_assert_double_eq_tol(s->offsets[0].value.v[SLOT_X], 25.4, 1e-12);
	ck_assert_double_eq_tol(s->offsets[0].value.v[SLOT_C], PI, 1e-12);
	ck_assert_double_eq(s->bodies[0].scale, 25.4);
	assert_vec3(s->bodies[0].placement.translation, 5, 25.4, 40);
	ck_assert_double_eq_tol(s->lengths[0].length, 50.8, 1e-12);
	/* D21 is no length; D22 is one, too. */
	ck_assert_uint_eq(s->length_count, 3);
	ck_assert_uint_eq(s->radius_count, 2);
	ck_assert_int_eq(s->radii[0].number, 21);
	ck_assert_double_eq_tol(s->radii[0].radius, 12.7, 1e-12);
	ck_assert_int_eq(s->lengths[1].number, 22);
	ck_assert_double_eq_tol(s->radii[1].radius, -25.4, 1e-12);
	ck_assert_double_eq_tol(setup_tool(s, 1)->length, 50.8, 1e-12);
	ck_assert_double_eq_tol(setup_tool(s, 1)->diameter, 12.7, 1e-12);
	piece_bounds(s->bodies[1].profile, &least, &greatest);
	ck_assert_double_eq_tol(least.z, -50.8, 1e-3);
	setup_free(s);
}
END_TEST

START_TEST(empty_setup_and_bare_tool)
{
	struct messages messages;
	struct setup *s = load_good("<setup version='1'/>");

	ck_assert_uint_eq(s->offset_count + s->tool_count + s->length_count + s->body_count, 0);
	ck_assert_int_eq(s->initial_tool, 0);
	setup_free(s);
	messages_init(&messages);
	write_text("s.xml", TOOL("4", "100", ""));
	s = setup_load("s.xml", machine, &messages.diag);
	ck_assert_ptr_nonnull(s);
	ck_assert_str_eq(strbuf_text(&messages.text),
			 "s.xml:2: warning: tool 4 has no holder, shank or cutter, so nothing of it is checked\n");
	ck_assert_uint_eq(s->body_count, 0);
	ck_assert_double_eq(s->lengths[0].length, 100);
	setup_free(s);
	strbuf_release(&messages.text);
}
END_TEST

/*
 * The part of the cutter above the flutes is a neck with the role of a shank; the cutter keeps its tip and its profile.
 */
START_TEST(cuts_off_what_is_above_the_flutes)
{
	struct setup *s = load_good("<setup version='1'>\n<tool number='5' length='60' kind='probe'>"
				    "<cutter tip='ball' flute_length='12'><section length='40' diameter='20' "
				    "diameter_end='10'/><section length='20' diameter='10'/></cutter></tool></setup>");
	const struct tool_solid *flutes;

	ck_assert_int_eq(setup_tool(s, 5)->kind, TOOL_PROBES);
	ck_assert_uint_eq(s->body_count, 2);
	ck_assert_str_eq(s->bodies[0].name, "T5 neck");
	ck_assert_int_eq(s->bodies[0].role, ROLE_SHANK);
	ck_assert_uint_eq(s->bodies[0].profile->count, 2);
	ck_assert_int_eq(s->bodies[0].profile->tip, TIP_FLAT);
	ck_assert_str_eq(s->bodies[1].name, "T5 cutter");
	flutes = s->bodies[1].profile;
	ck_assert_uint_eq(flutes->count, 1);
	ck_assert_int_eq(flutes->tip, TIP_BALL);
	ck_assert_double_eq_tol(flutes->top, -48, 1e-12);
	ck_assert_double_eq_tol(flutes->sections[0].length, 12, 1e-12);
	setup_free(s);
	s = load_good("<setup version='1'>\n<tool number='5' length='60'><cutter flute_length='50'>"
		      "<section length='40' diameter='20' diameter_end='10'/><section length='20' diameter='10'/>"
		      "</cutter></tool></setup>");
	ck_assert_int_eq(setup_tool(s, 5)->kind, TOOL_TURNS);
	flutes = s->bodies[1].profile;
	ck_assert_uint_eq(flutes->count, 2);
	ck_assert_double_eq_tol(flutes->sections[0].length, 30, 1e-12);
	ck_assert_double_eq_tol(flutes->sections[0].diameter, 17.5, 1e-12);
	setup_free(s);
}
END_TEST

START_TEST(reads_how_deep_a_cutter_may_go)
{
	struct setup *s = load_good("<setup version='1'><part name='a' mesh='a.stl'/>\n"
				    "<part name='b' mesh='b.stl' rapid_allowance='0.3' gouge='0'/></setup>");

	ck_assert_double_eq(s->bodies[0].rapid_allowance, 0.1);
	ck_assert_double_lt(s->bodies[0].gouge, 0);
	ck_assert_double_eq(s->bodies[1].rapid_allowance, 0.3);
	ck_assert_double_eq(s->bodies[1].gouge, 0);
	setup_free(s);
}
END_TEST

int main(void)
{
	TCase *good = tcase_create("good");

	tcase_add_checked_fixture(good, start, finish);
	tcase_add_test(good, reads_offsets_and_lengths);
	tcase_add_test(good, reads_tools);
	tcase_add_test(good, reads_bodies);
	tcase_add_test(good, stacks_and_places_tools);
	tcase_add_test(good, stacks_around_meshes);
	tcase_add_test(good, spindles_up_and_down);
	tcase_add_test(good, cuts_off_what_is_above_the_flutes);
	tcase_add_test(good, reads_how_deep_a_cutter_may_go);
	tcase_add_test(good, inches);
	tcase_add_test(good, empty_setup_and_bare_tool);
	return run_suite("setup", good);
}
