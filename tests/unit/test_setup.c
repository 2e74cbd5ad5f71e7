/* test_setup.c - setup files, good and bad. */
#include <math.h>

#include "base/units.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "machine/tool_solid.h"
#include "xml_case.h"

static const char machine_text[] =
	"<machine version='1'><base><body name='bed' mesh='bed.stl'/><body name='T8 cutter' mesh='t.stl'/>\n"
	"<axis name='X' type='linear' direction='1 0 0' rate_max='1'><spindle location='1 2 300' direction='0 3 "
	"4'/></axis>\n"
	"<axis name='C' type='rotary' direction='0 0 1' location='0 0 0' rate_max='1'>\n"
	"<workholding location='5 0 40' rotation='0 0 90'/></axis></base></machine>";

static const char bare_text[] =
	"<machine version='1'><base><axis name='X' type='linear' direction='1 0 0' rate_max='1'/></base></machine>";

#define SETUP(content) "<setup version='1'>\n" content "</setup>"
#define TOOL(number, length, content) SETUP("<tool number='" number "' length='" length "'>" content "</tool>")
#define SECTION(length, diameter) "<section length='" length "' diameter='" diameter "'/>"

static const char job[] =
	"<setup version='1' units='mm' initial_tool='12'>\n"
	"<work_offset name='G54' X='1' C='-90'/><work_offset name='G59.3'/>\n"
	"<tool number='12' name='ball 10' length='130' length_offset='129.5'>\n"
	"<cutter tip='ball'><section length='40' diameter='10'/></cutter>\n"
	"<holder><section length='30' diameter='63'/><section length='35' diameter='40' diameter_end='32'/></holder>\n"
	"<shank><section length='25' diameter='10'/></shank></tool>\n"
	"<part name='blade' mesh='blade.stl' location='0 0 60' units='m'/>\n"
	"<fixture name='vise' mesh='/v/vise.stl' rotation='0 0 90'/>\n"
	"<tool number='3' length='80' diameter='6'><cutter mesh='c.stl' units='inch'/>\n"
	"<holder><section length='20' diameter='40'/></holder><shank mesh='s.stl'/></tool>\n"
	"<offset number='12' length='131'/><offset number='7' length='-5'/>\n"
	"</setup>";

static struct machine *machine;

static void start(void)
{
	struct diag diag = {0};

	enter_folder();
	write_text("m.xml", machine_text);
	machine = machine_load("m.xml", &diag);
	ck_assert_ptr_nonnull(machine);
}

static void finish(void)
{
	machine_free(machine);
	leave_folder();
}

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
	/* An <offset> wins over the tool of its number; tool 3 brings its length. */
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
		ck_assert((b[i].mesh_path == NULL) == (b[i].solid != NULL));
	}
	ck_assert_str_eq(b[0].mesh_path, "blade.stl");
	ck_assert_double_eq(b[0].scale, 1000);
	/* The workholding turns x into y. */
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

/* Where the tessellated pieces begin and end along -Z, and that -Z becomes the spindle's direction. */
START_TEST(stacks_and_places_tools)
{
	struct setup *s = load_good(job);
	const double ends[3][2] = {{0, -65}, {-65, -90}, {-90, -130}};
	vec3 least, greatest;

	for (int i = 0; i < 3; i++) {
		mesh_bounds(s->bodies[2 + i].solid, &least, &greatest);
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

/* Below a mesh, sections stand on the tip; above it they hang from the gauge line. */
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

	mesh_bounds(s->bodies[1].solid, &least, &greatest);
	ck_assert_double_eq_tol(greatest.z, -40, 1e-3);
	ck_assert_double_eq_tol(least.z, -60, 1e-3);
	mesh_bounds(s->bodies[2].solid, &least, &greatest);
	ck_assert_double_eq_tol(greatest.z, -60, 1e-3);
	ck_assert_double_eq_tol(least.z, -100, 1e-3);
	ck_assert_double_eq(setup_tool(s, 1)->diameter, 8);
	mesh_bounds(s->bodies[4].solid, &least, &greatest);
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
				    "<tool number='1' length='2'><cutter tip='bull' corner='0.1'><section length='2' "
				    "diameter='0.5'/></cutter></tool></setup>");
	vec3 least, greatest;

	ck_assert_double_eq_tol(s->offsets[0].value.v[SLOT_X], 25.4, 1e-12);
	ck_assert_double_eq_tol(s->offsets[0].value.v[SLOT_C], PI, 1e-12);
	ck_assert_double_eq(s->bodies[0].scale, 25.4);
	assert_vec3(s->bodies[0].placement.translation, 5, 25.4, 40);
	ck_assert_double_eq_tol(s->lengths[0].length, 50.8, 1e-12);
	ck_assert_double_eq_tol(setup_tool(s, 1)->length, 50.8, 1e-12);
	ck_assert_double_eq_tol(setup_tool(s, 1)->diameter, 12.7, 1e-12);
	mesh_bounds(s->bodies[1].solid, &least, &greatest);
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
			 "s.xml:2: warning: tool 4 has neither holder nor shank nor cutter: "
			 "nothing of it is checked\n");
	ck_assert_uint_eq(s->body_count, 0);
	ck_assert_double_eq(s->lengths[0].length, 100);
	setup_free(s);
	strbuf_release(&messages.text);
}
END_TEST

/* What is above the flutes is a neck, with a shank's role; the cutter keeps its tip and its profile. */
START_TEST(cuts_off_what_is_above_the_flutes)
{
	struct setup *s = load_good("<setup version='1'>\n<tool number='5' length='60' kind='probe'>"
				    "<cutter tip='ball' flute_length='12'><section length='40' diameter='20' "
				    "diameter_end='10'/><section length='20' diameter='10'/></cutter></tool></setup>");
	const struct tool_solid *flutes;

	ck_assert_int_eq(setup_tool(s, 5)->kind, TOOL_STANDS);
	ck_assert_uint_eq(s->body_count, 2);
	ck_assert_str_eq(s->bodies[0].name, "T5 neck");
	ck_assert_int_eq(s->bodies[0].role, ROLE_SHANK);
	ck_assert_ptr_null(s->bodies[0].profile);
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

static const struct xml_case bad[] = {
    {SETUP("<part name='p' mesh='p.stl' gouge='-1'/>"),
     "s.xml:2: error: gouge=\"-1\" of <part> is not between 0 and 5000 mm\n"},
    {TOOL("5", "60", "<cutter tip='ball' flute_length='4'><section length='60' diameter='10'/></cutter>"),
     "s.xml:2: error: flute_length=\"4\" of <cutter> is not between the height of its tip and its length, 5 and "
     "60 mm\n"},
    {TOOL("5", "60", "<cutter mesh='c.stl' flute_length='4'/>"),
     "s.xml:2: error: <cutter> takes its tip from its mesh: remove tip, angle, corner and flute_length\n"},
    {"<machine version='1'/>", "s.xml:1: error: this is a machine file where a setup file is wanted\n"},
    {"<setup/>", "s.xml:1: error: <setup> lacks the attribute 'version'\n"},
    {"<setup version='1.0'/>",
     "s.xml:1: error: version \"1.0\" of the setup file is not supported; this program reads version 1\n"},
    {SETUP("<fixtur name='f' mesh='f.stl'/>"),
     "s.xml:2: error: unknown element <fixtur> in <setup>; did you mean <fixture>?\n"},
    {SETUP("<section length='1' diameter='1'/>"), "s.xml:2: error: element <section> does not belong in <setup>\n"},
    {SETUP("<work_offset name='G60'/>"),
     "s.xml:2: error: name=\"G60\" of <work_offset> must be G54, G55, G56, G57, G58, G59, G59.1, G59.2, G59.3 or "
     "G54.1 P1 to P99\n"},
    {SETUP("<work_offset name='G54' D='1'/>"), "s.xml:2: error: unknown attribute 'D' of <work_offset>\n"},
    {SETUP("<work_offset name='G54' X='1' B='0'/>"),
     "s.xml:2: error: work offset G54 has a value for B, but the machine has no axis B\n"},
    {SETUP("<work_offset name='G54'/>\n<work_offset name='G54'/>"),
     "s.xml:3: error: work offset G54 is given twice (the other in line 2)\n"},
    {SETUP("<work_offset name='G54' C='1e8'/>"),
     "s.xml:2: error: C=\"1e8\" of <work_offset> is beyond 10 million degrees\n"},
    {SETUP("<fixture name='bed' mesh='f.stl'/>"),
     "s.xml:2: error: the name 'bed' is taken: another body has it (m.xml:1)\n"},
    {SETUP("<fixture name='f' mesh='f.stl'/>\n<part name='f' mesh='g.stl'/>"),
     "s.xml:3: error: the name 'f' is taken: another body has it (s.xml:2)\n"},
    {SETUP("<part name='part' mesh='g.stl'/>"),
     "s.xml:2: error: a body cannot be named 'part': in a <pair> that word names an axis, the base or a role\n"},
    {SETUP("<part name='T5 cutter' mesh='g.stl'/>\n<tool number='5' length='9'><cutter mesh='c.stl'/></tool>"),
     "s.xml:3: error: the name 'T5 cutter' is taken: another body has it (s.xml:2)\n"},
    {TOOL("8", "9", "<cutter mesh='c.stl'/>"),
     "s.xml:2: error: the name 'T8 cutter' is taken: another body has it (m.xml:1)\n"},
    {SETUP("<offset number='1' length='2'/>\n<offset number='1' length='2'/>"),
     "s.xml:3: error: <offset> 1 is given twice\n"},
    {SETUP("<offset number='0' length='2'/>"),
     "s.xml:2: error: number=\"0\" of <offset> must be a whole number, 1 or more\n"},
    {SETUP("<offset number='100000000' length='2'/>"),
     "s.xml:2: error: number=\"100000000\" of <offset> is not between 1 and 99999999\n"},
    {"<setup version='1' initial_tool='3'/>", "s.xml:1: error: initial_tool=\"3\" of <setup>: there is no such tool\n"},
    {"<setup version='1' initial_tool='-1'/>",
     "s.xml:1: error: initial_tool=\"-1\" of <setup> must be a whole number, 0 or more\n"},
    {SETUP("<tool number='1'/>"), "s.xml:2: error: <tool> lacks the attribute 'length'\n"},
    {TOOL("1", "0", ""), "s.xml:2: error: length=\"0\" of <tool> is not between 0 and 5000 mm\n"},
    {TOOL("1", "6000", ""), "s.xml:2: error: length=\"6000\" of <tool> is not between 0 and 5000 mm\n"},
    {TOOL("1.5", "10", ""), "s.xml:2: error: number=\"1.5\" of <tool> must be a whole number, 1 or more\n"},
    {SETUP("<tool number='1' length='9'><cutter mesh='c'/></tool>\n<tool number='1' length='9'><cutter "
	   "mesh='c'/></tool>"),
     "s.xml:3: error: tool 1 is given twice (the other in line 2)\n"},
    {TOOL("1", "10", "<cutter>" SECTION("9.99999", "2") "</cutter>"),
     "s.xml:2: error: the sections of tool 1 add up to 9.99999 mm, but its length is 10 mm\n"},
    {TOOL("1", "10", "<holder mesh='h'/><cutter>" SECTION("11", "2") "</cutter>"),
     "s.xml:2: error: the sections of tool 1 are longer than the tool\n"},
    {TOOL("1", "10", "<holder mesh='h'/><shank>" SECTION("1", "2") "</shank><cutter mesh='c'/>"),
     "s.xml:2: error: <shank> stands between two meshes: give it a mesh too\n"},
    {TOOL("1", "10", "<cutter mesh='c'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: <cutter> has both a mesh and sections\n"},
    {TOOL("1", "10", "<cutter/>"), "s.xml:2: error: <cutter> needs sections, or a mesh\n"},
    {TOOL("1", "10", "<cutter mesh='c' tip='ball'/>"),
     "s.xml:2: error: <cutter> takes its tip from its mesh: remove tip, angle, corner and flute_length\n"},
    {TOOL("1", "10", "<cutter units='inch'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: <cutter> has units, but no mesh that they are for\n"},
    {TOOL("1", "10", "<holder tip='flat'>" SECTION("10", "2") "</holder>"),
     "s.xml:2: error: unknown attribute 'tip' of <holder>\n"},
    {TOOL("1", "10", "<cutter tip='round'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: tip=\"round\" of <cutter> must be flat, ball, cone or bull\n"},
    {TOOL("1", "10", "<cutter>" SECTION("10", "2") "</cutter>\n<cutter mesh='c'/>"),
     "s.xml:3: error: <tool> has a second <cutter>\n"},
    {TOOL("1", "10", "<cutter><section length='10' diameter='0'/></cutter>"),
     "s.xml:2: error: diameter=\"0\" of <section> is not between 0.001 and 5000 mm\n"},
    {TOOL("1", "10", "<cutter><section length='10' diameter='1' diameter_end='-1'/></cutter>"),
     "s.xml:2: error: diameter_end=\"-1\" of <section> is not between 0.001 and 5000 mm, nor 0\n"},
    {TOOL("1", "10", "<cutter><section length='0.001' diameter='1'/></cutter>"),
     "s.xml:2: error: length=\"0.001\" of <section> is not between 0.01 and 5000 mm\n"},
    {TOOL("1", "4", "<cutter tip='ball'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: the ball tip is 5 mm high, but the last section is 4 mm long\n"},
    {TOOL("1", "4", "<cutter tip='cone' angle='90'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: the cone tip is 5 mm high, but the last section is 4 mm long\n"},
    {TOOL("1", "4", "<cutter tip='cone'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter> with tip=\"cone\" needs an angle, the full angle of the point\n"},
    {TOOL("1", "4", "<cutter tip='cone' angle='180'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: angle=\"180\" of <cutter> is not between 1 and 179 degrees\n"},
    {TOOL("1", "4", "<cutter tip='bull'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter> with tip=\"bull\" needs a corner, the radius of its rounded edge\n"},
    {TOOL("1", "40", "<cutter tip='bull' corner='5.1'>" SECTION("40", "10") "</cutter>"),
     "s.xml:2: error: corner=\"5.1\" of <cutter> is not between 0 and the radius of its last section, 5 mm\n"},
    {TOOL("1", "4", "<cutter angle='118'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: only tip=\"cone\" has an angle\n"},
    {TOOL("1", "4", "<cutter corner='1'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: only tip=\"bull\" has a corner\n"},
    {TOOL("1", "9", "<cutter tip='ball'><section length='9' diameter='6' diameter_end='4'/></cutter>"),
     "s.xml:2: error: <cutter> with tip=\"ball\": its last section must be a cylinder\n"},
    {SETUP("<tool number='1' length='9' diameter='7'><cutter>" SECTION("9", "6") "</cutter></tool>"),
     "s.xml:2: error: diameter=\"7\" of <tool>: the greatest diameter of its cutter is 6 mm\n"},
    {SETUP("<tool number='1' length='9' diameter='-1'><cutter mesh='c'/></tool>"),
     "s.xml:2: error: diameter=\"-1\" of <tool> is not between 0 and 5000 mm\n"},
};

START_TEST(faults)
{
	struct messages messages;

	messages_init(&messages);
	write_text("s.xml", bad[_i].content);
	ck_assert_ptr_null(setup_load("s.xml", machine, &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text), bad[_i].messages);
	strbuf_release(&messages.text);
}
END_TEST

START_TEST(nowhere_to_stand)
{
	struct diag diag = {0};
	struct messages messages;
	struct machine *bare;

	write_text("m.xml", bare_text);
	bare = machine_load("m.xml", &diag);
	ck_assert_ptr_nonnull(bare);
	messages_init(&messages);
	write_text("s.xml",
		   SETUP("<fixture name='f' mesh='f'/>\n<part name='p' mesh='p'/>\n<tool number='1' length='1'>"
			 "<cutter mesh='c'/></tool>"));
	ck_assert_ptr_null(setup_load("s.xml", bare, &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text),
			 "s.xml:2: error: the machine has no <workholding> for a <fixture>\n"
			 "s.xml:4: error: the machine has no <spindle> for a <tool>\n");
	strbuf_release(&messages.text);
	machine_free(bare);
}
END_TEST

/* A file within the size limit must not fill the memory with triangles. */
START_TEST(bounds_the_triangles)
{
	struct strbuf text = {0};
	struct messages messages;

	strbuf_addf(&text, "<setup version='1'>");
	for (int tool = 11; tool <= 20; tool++) {
		strbuf_addf(&text, "<tool number='%d' length='1000'><cutter>", tool);
		for (int i = 0; i < 1000; i++)
			strbuf_addf(&text, "<section length='1' diameter='%d'/>", i % 2 ? 4000 : 3000);
		strbuf_addf(&text, "</cutter></tool>");
	}
	strbuf_addf(&text, "</setup>");
	write_text("s.xml", strbuf_text(&text));
	messages_init(&messages);
	ck_assert_ptr_null(setup_load("s.xml", machine, &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text),
			 "s.xml:1: error: the tools' sections make more than 10000000 triangles\n");
	strbuf_release(&messages.text);
	strbuf_release(&text);
}
END_TEST

START_TEST(survives_damage)
{
	static const char replacements[] = {'<', '>', '"', '\'', '&', '\0', ' ', '9', '-', (char)0xff};
	char damaged[sizeof(job)];
	size_t length = sizeof(job) - 1;
	struct diag diag = {0};

	for (size_t i = 0; i < length; i++) {
		write_bytes("s.xml", job, i);
		ck_assert_ptr_null(setup_load("s.xml", machine, &diag));
		memcpy(damaged, job, sizeof(job));
		damaged[i] = replacements[i % sizeof(replacements)];
		write_bytes("s.xml", damaged, length);
		setup_free(setup_load("s.xml", machine, &diag));
	}
	ck_assert_uint_gt(diag.errors, length);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("setup");
	TCase *good = tcase_create("good"), *faulty = tcase_create("faulty");
	SRunner *runner;
	int failed;

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
	suite_add_tcase(suite, good);
	tcase_add_checked_fixture(faulty, start, finish);
	tcase_add_loop_test(faulty, faults, 0, (int)(sizeof(bad) / sizeof(bad[0])));
	tcase_add_test(faulty, nowhere_to_stand);
	tcase_add_test(faulty, bounds_the_triangles);
	tcase_add_test(faulty, survives_damage);
	suite_add_tcase(suite, faulty);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
