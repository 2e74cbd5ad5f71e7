/* test_xml_place.c - the line and the column of faults in XML files. */
#include "machine_case.h"

struct place_case {
	const char *content;
	const char *messages;
};

static void keep_whole_message(void *context, const struct diag_entry *entry)
{
	diag_format(context, entry);
}

static const struct place_case cases[] = {
    /* at the attribute, in its line */
    {BASE("<axis name='X' type='linear' direction='1 0 0'\n\trate_max='-1'/>"),
     "m.xml:3:2: error: rate_max=\"-1\" of axis X is not between 1e-6 and 1e9 mm a minute\n"
     "     rate_max='-1'/></base>\n"
     "     ^\n"},
    /* a name that is part of others, and values that look like attributes or like the end of the tag */
    {BASE("<body\n name=\"a > name='x' />\" mesh = 'm' rename='1'/>"),
     "m.xml:3:36: error: unknown attribute 'rename' of <body>; did you mean 'name'?\n"
     "     name=\"a > name='x' />\" mesh = 'm' rename='1'/></base>\n"
     "                                       ^\n"},
    /* at the element, after others in its line, after text that only looks like elements */
    {MACHINE("<base><!-- <axis> --><?x <axis> ?><![CDATA[ ]]></base><controler/>"),
     "m.xml:2:55: error: unknown element <controler> in <machine>; did you mean <controller>?\n"
     "    <base><!-- <axis> --><?x <axis> ?><![CDATA[ ]]></base><controler/>\n"
     "                                                          ^\n"},
    /* a fault of the meaning of two elements */
    {BASE("<body name='b' mesh='m'/>  <body name='b' mesh='m'/>"),
     "m.xml:2:40: error: another body already has the name 'b' (m.xml:2)\n"
     "    <base><body name='b' mesh='m'/>  <body name='b' mesh='m'/></base>\n"
     "                                           ^\n"},
    /* another encoding than that of the terminal, line ends of other systems, characters that control a terminal */
    {"<?xml version='1.0' encoding='ISO-8859-1'?>\r\n<machine version='1' name='\xe9' colour='red'><base/></machine>",
     "m.xml:2:31: error: unknown attribute 'colour' of <machine>\n"},
    {"<machine version='1'><base/>\r\n<pairs colour='red'/>\r\n</machine>",
     "m.xml:2:8: error: unknown attribute 'colour' of <pairs>\n"
     "    <pairs colour='red'/>\n"
     "           ^\n"},
    {"<machine version='1' colour='\xc2\x9b'><base/></machine>",
     "m.xml:1:22: error: unknown attribute 'colour' of <machine>\n"
     "    <machine version='1' colour='  '><base/></machine>\n"
     "                         ^\n"},
};

START_TEST(places)
{
	const struct place_case *c = &cases[_i];
	struct strbuf text = {0};
	struct diag diag = {.handle = keep_whole_message, .context = &text};

	write_text("m.xml", c->content);
	ck_assert_ptr_null(machine_load("m.xml", &diag));
	ck_assert_str_eq(strbuf_text(&text), c->messages);
	strbuf_release(&text);
}
END_TEST

START_TEST(no_endless_excerpt)
{
	struct strbuf text = {0}, content = {0};
	struct diag diag = {.handle = keep_whole_message, .context = &text};

	strbuf_addf(&content, "<machine version='1'><base>%300s</base><widget/></machine>", "");
	write_text("m.xml", strbuf_text(&content));
	ck_assert_ptr_null(machine_load("m.xml", &diag));
	ck_assert_str_eq(strbuf_text(&text), "m.xml:1:335: error: unknown element <widget> in <machine>\n");
	strbuf_release(&text);
	strbuf_release(&content);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("xml_place");

	tcase_add_loop_test(tcase, places, 0, COUNT(cases));
	tcase_add_test(tcase, no_endless_excerpt);
	return run_in_folders("xml_place", tcase);
}
