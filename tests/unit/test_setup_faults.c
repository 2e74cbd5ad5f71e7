/* test_setup_faults.c - faulty setup files and their messages. */
#include <string.h>

#include "setup_case.h"

static const char bare_text[] =
	"<machine version='1'><base><axis name='X' type='linear' direction='1 0 0' rate_max='1'/></base></machine>";
static const struct xml_case bad[] = {
    {SETUP("<part name='p' mesh='p.stl' gouge='-1'/>"),
     "s.xml:2: error: gouge=\"-1\" of <part> is not between 0 and 5000 mm\n"},
    {TOOL("5", "60", "<cutter tip='ball' flute_length='4'><section length='60' diameter='10'/></cutter>"),
     "s.xml:2: error: flute_length=\"4\" of <cutter> is not between the height of its tip and its length, 5 and "
     "60 mm\n"},
    {TOOL("5", "60", "<cutter mesh='c.stl' flute_length='4'/>"),
     "s.xml:2: error: <cutter> takes its tip from its mesh: remove tip, angle, corner and flute_length\n"},
    {"<machine version='1'/>", "s.xml:1: error: this is a machine file, but a setup file is needed here\n"},
    {"<setup/>", "s.xml:1: error: <setup> needs the attribute 'version'\n"},
    {"<setup version='1.0'/>",
     "s.xml:1: error: version \"1.0\" of the setup file is not supported; fivecheck reads version 1\n"},
    {SETUP("<fixtur name='f' mesh='f.stl'/>"),
     "s.xml:2: error: unknown element <fixtur> in <setup>; did you mean <fixture>?\n"},
    {SETUP("<section length='1' diameter='1'/>"), "s.xml:2: error: element <section> is not allowed in <setup>\n"},
    {SETUP("<work_offset name='G60'/>"),
     "s.xml:2: error: name=\"G60\" of <work_offset> must be G54 to G59, G59.1, G59.2, G59.3, G54.1 P1 to P300 (or "
     "G154 P1 to P99, G110 to G129), G54.4 P1 to P7, G505 to G599 or #0 to #9999\n"},
    {SETUP("<work_offset name='G154 P7'/>\n<work_offset name='G116'/>"),
     "s.xml:3: error: work offset G54.1 P7 is given twice (also in line 2)\n"},
    {SETUP("<work_offset name='G54.1P9'/>\n<work_offset name='G54 P9'/>"),
     "s.xml:3: error: work offset G54.1 P9 is given twice (also in line 2)\n"},
    {SETUP("<work_offset name='G54' D='1'/>"), "s.xml:2: error: unknown attribute 'D' of <work_offset>\n"},
    {SETUP("<work_offset name='G54' X='1' B='0'/>"),
     "s.xml:2: error: work offset G54 has a value for B, but the machine has no axis B\n"},
    {SETUP("<work_offset name='G54'/>\n<work_offset name='G54'/>"),
     "s.xml:3: error: work offset G54 is given twice (also in line 2)\n"},
    {SETUP("<work_offset name='G54' C='1e8'/>"),
     "s.xml:2: error: C=\"1e8\" of <work_offset> is beyond 10 million degrees\n"},
    {SETUP("<fixture name='bed' mesh='f.stl'/>"),
     "s.xml:2: error: another body already has the name 'bed' (m.xml:1)\n"},
    {SETUP("<fixture name='f' mesh='f.stl'/>\n<part name='f' mesh='g.stl'/>"),
     "s.xml:3: error: another body already has the name 'f' (s.xml:2)\n"},
    {SETUP("<part name='part' mesh='g.stl'/>"),
     "s.xml:2: error: a body cannot be named 'part': in a <pair> this word is an axis, the base or a role\n"},
    {SETUP("<part name='T5 cutter' mesh='g.stl'/>\n<tool number='5' length='9'><cutter mesh='c.stl'/></tool>"),
     "s.xml:3: error: another body already has the name 'T5 cutter' (s.xml:2)\n"},
    {TOOL("8", "9", "<cutter mesh='c.stl'/>"),
     "s.xml:2: error: another body already has the name 'T8 cutter' (m.xml:1)\n"},
    {SETUP("<offset number='1' length='2'/>\n<offset number='1' length='2'/>"),
     "s.xml:3: error: <offset> 1 is given twice\n"},
    {SETUP("<offset number='1' length='2'/>\n<offset number='1' radius='2'/>"),
     "s.xml:3: error: <offset> 1 is given twice\n"},
    {SETUP("<offset number='1'/>"), "s.xml:2: error: <offset> needs a length or a radius\n"},
    {SETUP("<offset number='0' length='2'/>"),
     "s.xml:2: error: number=\"0\" of <offset> must be a whole number, 1 or more\n"},
    {SETUP("<offset number='100000000' length='2'/>"),
     "s.xml:2: error: number=\"100000000\" of <offset> is not between 1 and 99999999\n"},
    {"<setup version='1' initial_tool='3'/>", "s.xml:1: error: initial_tool=\"3\" of <setup>: there is no such tool\n"},
    {"<setup version='1' initial_tool='-1'/>",
     "s.xml:1: error: initial_tool=\"-1\" of <setup> must be a whole number, 0 or more\n"},
    {SETUP("<tool number='1'/>"), "s.xml:2: error: <tool> needs the attribute 'length'\n"},
    {TOOL("1", "0", ""), "s.xml:2: error: length=\"0\" of <tool> is not between 0 and 5000 mm\n"},
    {TOOL("1", "6000", ""), "s.xml:2: error: length=\"6000\" of <tool> is not between 0 and 5000 mm\n"},
    {TOOL("1.5", "10", ""), "s.xml:2: error: number=\"1.5\" of <tool> must be a whole number, 1 or more\n"},
    {SETUP("<tool number='1' length='9'><cutter mesh='c'/></tool>\n<tool number='1' length='9'><cutter "
	   "mesh='c'/></tool>"),
     "s.xml:3: error: tool 1 is given twice (also in line 2)\n"},
    {TOOL("1", "10", "<cutter>" SECTION("9.99999", "2") "</cutter>"),
     "s.xml:2: error: the sections of tool 1 add up to 9.99999 mm, but its length is 10 mm\n"},
    {TOOL("1", "10", "<holder mesh='h'/><cutter>" SECTION("11", "2") "</cutter>"),
     "s.xml:2: error: the sections of tool 1 are longer than the tool\n"},
    {TOOL("1", "10", "<holder mesh='h'/><shank>" SECTION("1", "2") "</shank><cutter mesh='c'/>"),
     "s.xml:2: error: <shank> is between two meshes: give it a mesh too\n"},
    {TOOL("1", "10", "<cutter mesh='c'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: <cutter> has both a mesh and sections\n"},
    {TOOL("1", "10", "<cutter/>"), "s.xml:2: error: <cutter> needs sections, or a mesh\n"},
    {TOOL("1", "10", "<cutter mesh='c' tip='ball'/>"),
     "s.xml:2: error: <cutter> takes its tip from its mesh: remove tip, angle, corner and flute_length\n"},
    {TOOL("1", "10", "<cutter units='inch'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: <cutter> has units, but no mesh to which they apply\n"},
    {TOOL("1", "10", "<holder tip='flat'>" SECTION("10", "2") "</holder>"),
     "s.xml:2: error: unknown attribute 'tip' of <holder>\n"},
    {TOOL("1", "10", "<cutter tip='round'>" SECTION("10", "2") "</cutter>"),
     "s.xml:2: error: tip=\"round\" of <cutter> must be flat, ball, cone or bull\n"},
    {TOOL("1", "10", "<cutter>" SECTION("10", "2") "</cutter>\n<cutter mesh='c'/>"),
     "s.xml:3: error: <tool> has a second <cutter>\n"},
    {TOOL("1", "10", "<cutter><section length='10' diameter='0'/></cutter>"),
     "s.xml:2: error: diameter=\"0\" of <section> is not between 0.001 and 5000 mm\n"},
    {TOOL("1", "10", "<cutter><section length='10' diameter='1' diameter_end='-1'/></cutter>"),
     "s.xml:2: error: diameter_end=\"-1\" of <section> is not between 0.001 and 5000 mm and not 0\n"},
    {TOOL("1", "10", "<cutter><section length='0.001' diameter='1'/></cutter>"),
     "s.xml:2: error: length=\"0.001\" of <section> is not between 0.01 and 5000 mm\n"},
    {TOOL("1", "4", "<cutter tip='ball'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: the ball tip is 5 mm high, but the last section is 4 mm long\n"},
    {TOOL("1", "4", "<cutter tip='cone' angle='90'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter>: the cone tip is 5 mm high, but the last section is 4 mm long\n"},
    {TOOL("1", "4", "<cutter tip='cone'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter> with tip=\"cone\" needs an angle (full angle of the point)\n"},
    {TOOL("1", "4", "<cutter tip='cone' angle='180'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: angle=\"180\" of <cutter> is not between 1 and 179 degrees\n"},
    {TOOL("1", "4", "<cutter tip='bull'>" SECTION("4", "10") "</cutter>"),
     "s.xml:2: error: <cutter> with tip=\"bull\" needs a corner (corner radius)\n"},
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
			 "s.xml:2: error: the machine has no <workholding>, which a <fixture> needs\n"
			 "s.xml:4: error: the machine has no <spindle>, which a <tool> needs\n");
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
			 "s.xml:1: error: the sections of the tools make more than 10000000 triangles: leave out the "
			 "tools that the job does not need\n");
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
	TCase *faulty = tcase_create("faulty");

	tcase_add_checked_fixture(faulty, start, finish);
	tcase_add_loop_test(faulty, faults, 0, COUNT(bad));
	tcase_add_test(faulty, nowhere_to_stand);
	tcase_add_test(faulty, bounds_the_triangles);
	tcase_add_test(faulty, survives_damage);
	return run_suite("setup_faults", faulty);
}
