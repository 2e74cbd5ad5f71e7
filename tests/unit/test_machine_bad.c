/* test_machine_bad.c - faulty machine files, each with all of its messages. */
#include "machine/setup.h"
#include "machine_case.h"

static const struct xml_case bad[] = {
    /* faults of the XML */
    {"", "m.xml: error: the file is empty: it has no element\n"},
    {"\n \n", "m.xml: error: the file is empty: it has no element\n"},
    {"solid cube\n", "m.xml:1: error: this is not XML: it does not start with '<'\n"},
    {"<!-- -->", "m.xml:1: error: this is not well-formed XML: Start tag expected, '<' not found\n"},
    {"<machine version='1'>\n<base>\n</machine>",
     "m.xml:3: error: this is not well-formed XML: Opening and ending tag mismatch: base line 2 and machine\n"},
    {"<machine version='1'\n version='1'/>",
     "m.xml:2: error: this is not well-formed XML: Attribute version redefined\n"},
    {"<?xml version='1.0' encoding='UTF-8'?>\n<machine version='1' name='\xe9'/>",
     "m.xml:2: error: this is not well-formed XML: Input is not proper UTF-8, indicate encoding !\n"},
    {"<?xml version='1.0' encoding='klingon'?>\n<machine version='1'/>",
     "m.xml:1: error: the encoding \"klingon\" is not supported: save the file as UTF-8\n"},
    {"<?xml version='1.0' encoding='IBM037'?>\n<machine version='1'/>",
     "m.xml:1: error: the encoding \"IBM037\" is not supported: save the file as UTF-8\n"},
    {"<!DOCTYPE machine SYSTEM 'http://example.org/machine.dtd'>\n<machine version='1'/>",
     "m.xml:1: error: document type declarations (<!DOCTYPE ...>) are not allowed; remove them\n"},
    {"<?xml version='1.0'?>\n<!DOCTYPE m [<!ENTITY a 'x'><!ENTITY b '&a;&a;&a;'>]>\n<machine version='&b;'/>",
     "m.xml:2: error: document type declarations (<!DOCTYPE ...>) are not allowed; remove them\n"},
    {"<machine version='1' name='&nbsp;'><base/></machine>",
     "m.xml:1: error: this is not well-formed XML: Entity 'nbsp' not defined\n"},
    {"<lathe version='1'/>",
     "m.xml:1: error: the root element is <lathe>, but a machine file starts with <machine version=\"1\">\n"},
    {"<setup version='1'/>",
     "m.xml:1: error: this is a setup file, but a machine file is needed here: give it with --setup\n"},
    {"<machine version='2'><novelty/></machine>",
     "m.xml:1: error: version \"2\" of the machine file is not supported; fivecheck reads version 1\n"},
    /* faults of the form */
    {"<machine><base/></machine>", "m.xml:1: error: <machine> needs the attribute 'version'\n"},
    {MACHINE(""), "m.xml:1: error: <machine> needs <base>\n"},
    {MACHINE("<base/>\n<base/>"), "m.xml:3: error: <machine> has a second <base>\n"},
    {MACHINE("<base/><pairs/><pairs/>"), "m.xml:2: error: <machine> has a second <pairs>\n"},
    {MACHINE("<base/><controler/>"),
     "m.xml:2: error: unknown element <controler> in <machine>; did you mean <controller>?\n"},
    {BASE("<conveyor/>"), "m.xml:2: error: unknown element <conveyor> in <base>\n"},
    {BASE("<pair a='b' b='c'/>"), "m.xml:2: error: element <pair> is not allowed in <base>\n"},
    {BASE(AXIS_X " direcion='0 0 1'/>"),
     "m.xml:2: error: unknown attribute 'direcion' of <axis>; did you mean 'direction'?\n"},
    {BASE(AXIS_X " colour='red'/>"), "m.xml:2: error: unknown attribute 'colour' of <axis>\n"},
    {BASE("<axis name='X' type='linear' direction='1 0 0'/>"),
     "m.xml:2: error: <axis> needs the attribute 'rate_max'\n"},
    {BASE(AXIS_X " home='ten'/>"), "m.xml:2: error: home=\"ten\" of <axis> is not a number\n"},
    {BASE(AXIS_X " home='1,5'/>"), "m.xml:2: error: home=\"1,5\" of <axis> is not a number: write a decimal point\n"},
    {BASE(AXIS_X " home='nan'/>"), "m.xml:2: error: home=\"nan\" of <axis> is not a number\n"},
    {BASE(AXIS_X " home='0x10'/>"), "m.xml:2: error: home=\"0x10\" of <axis> is not a number\n"},
    {BASE(AXIS_X " home='1 mm'/>"), "m.xml:2: error: home=\"1 mm\" of <axis> is not a number\n"},
    {BASE(AXIS_X " home='1e400'/>"), "m.xml:2: error: home=\"1e400\" of <axis> is too large\n"},
    {BASE("<spindle location='0 0' direction='0 0 -1'/>"),
     "m.xml:2: error: location=\"0 0\" of <spindle> must be 3 numbers\n"},
    {BASE("<spindle location='0 0 1 2' direction='0 0 down'/>"),
     "m.xml:2: error: location=\"0 0 1 2\" of <spindle> must be 3 numbers\n"
     "m.xml:2: error: direction=\"0 0 down\" of <spindle> must be 3 numbers\n"},
    {MACHINE("<controller dialect='heidenhain'/><base/>"),
     "m.xml:2: error: dialect=\"heidenhain\" of <controller> must be linuxcnc, fanuc, haas, sinumerik or klartext\n"},
    {MACHINE("<controller><mcode number='-5' action='on'/></controller><base/>"),
     "m.xml:2: error: number=\"-5\" of <mcode> must be a whole number, 0 or more\n"
     "m.xml:2: error: action=\"on\" of <mcode> must be tcp-on, tcp-off, ignore, spindle-on or spindle-off\n"},
    {MACHINE("<controller dialect='fanuc'><variable value='1'/></controller><base/>"),
     "m.xml:2: error: <variable> needs the attribute 'name'\n"},
    {MACHINE("<controller dialect='fanuc'><variable name='#1' value='1'/>\n<variable name='# 1'/></controller><base/>"),
     "m.xml:3: error: #1 is given twice\n"},
    {MACHINE("<controller dialect='fanuc'><variable name='#1' value=''/></controller><base/>"),
     "m.xml:2: error: value of <variable> is empty: give the value of #1\n"},
    {MACHINE("<controller dialect='fanuc'><variable name='500' value='1'/>\n<variable name='#0500' value='1'/>\n"
	     "<variable name='#5OO' value='1'/></controller><base/>"),
     "m.xml:2: error: name=\"500\" of <variable> is not a name, such as #500\n"
     "m.xml:3: error: name=\"#0500\" of <variable> is not a name, such as #500\n"
     "m.xml:4: error: name=\"#5OO\" of <variable> is not a name, such as #500\n"},
    {MACHINE("<controller dialect='klartext'><variable name='Q1' type='REAL' value='1'/></controller><base/>"),
     "m.xml:2: error: <variable> of this control has only a name and a value, no type and no size\n"},
    {MACHINE("<controller><variable name='#1' value='1'/></controller><base/>"),
     "m.xml:2: error: <variable>: only the program determines the value of LinuxCNC\n"},
    {MACHINE("<controller dialect='sinumerik'><variable name='_A' type='REAL' value='x'/>\n"
	     "<variable name='_B' type='AXIS' value='Q'/>\n<variable name='_C' size='3'/>\n"
	     "<variable name='_D' type='INT' size='3,'/>\n<variable name='_E' type='INT' size='1,2,3,4'/>\n"
	     "<variable name='_F' type='INT' size='32767,32768'/>\n"
	     "<variable name='_G' type='REAL' value='1e999'/></controller><base/>"),
     "m.xml:2: error: value=\"x\" of <variable> is not a number\n"
     "m.xml:3: error: value=\"Q\" of <variable> is not an axis letter\n"
     "m.xml:4: error: size of <variable> must be one to three whole numbers, and needs a type: size=\"10\", "
     "size=\"3,4\"\n"
     "m.xml:5: error: size of <variable> must be one to three whole numbers, and needs a type: size=\"10\", "
     "size=\"3,4\"\n"
     "m.xml:6: error: size of <variable> must be one to three whole numbers, and needs a type: size=\"10\", "
     "size=\"3,4\"\n"
     "m.xml:7: error: size of <variable> must be one to three whole numbers, and needs a type: size=\"10\", "
     "size=\"3,4\"\n"
     "m.xml:8: error: value=\"1e999\" of <variable> is not a number\n"},
    {MACHINE("<controller dialect='sinumerik'><variable name='_F' type='FRAME'/></controller><base/>"),
     "m.xml:2: error: type=\"FRAME\" of <variable> must be REAL, INT, BOOL, CHAR, STRING or AXIS\n"},
    {BASE("<body name='b' mesh='b.stl' units='feet'/>"),
     "m.xml:2: error: units=\"feet\" of <body> must be mm, inch, cm or m\n"},
    {BASE("steel"), "m.xml:2: error: <base> contains text; only elements are allowed here\n"},
    {"<machine version='1' xmlns='http://example.org/'><base/></machine>",
     "m.xml:1: error: <machine> declares a namespace; fivecheck files use none\n"
     "m.xml:1: error: element <base> is in a namespace; fivecheck files use none\n"
     "m.xml:1: error: <machine> needs <base>\n"},
    /* faults of the meaning */
    {BASE("<body name='b' mesh=''/>"), "m.xml:2: error: mesh=\"\" of <body> is empty\n"},
    {BASE("<body name='' mesh='b.stl'/>"), "m.xml:2: error: name=\"\" of <body> is empty\n"},
    {BASE("<body name='a&#9;b' mesh='b.stl'/>"),
     "m.xml:2: error: name=\"a?b\" of <body> contains a control character\n"},
    {BASE("<body name='a&#155;b' mesh='b.stl'/>"),
     "m.xml:2: error: name=\"a??b\" of <body> contains a control character\n"},
    {BASE("<body name='b' mesh='b.stl'/>\n<body name='b' mesh='c.stl'/>"),
     "m.xml:3: error: another body already has the name 'b' (m.xml:2)\n"},
    {BASE("<body name='holder' mesh='b.stl'/>\n<body name='Z' mesh='c.stl'/>"),
     "m.xml:2: error: a body cannot be named 'holder': in a <pair> this word is an axis, the base or a role\n"
     "m.xml:3: error: a body cannot be named 'Z': in a <pair> this word is an axis, the base or a role\n"},
    {BASE("<body name='b' mesh='b.stl' location='0 2e7 0'/>"),
     "m.xml:2: error: location=\"0 2e7 0\" of <body> is beyond 10 km: check the units\n"},
    {BASE("<body name='b' mesh='b.stl' rotation='0 0 1e300'/>"),
     "m.xml:2: error: rotation=\"0 0 1e300\" of <body> is beyond 10 million degrees\n"},
    {BASE("<axis name='D' type='rotary' direction='1 0 0' location='0 0 0' rate_max='1'/>"),
     "m.xml:2: error: name=\"D\" of <axis> must be X, Y, Z, A, B, C, U, V or W\n"},
    {BASE(AXIS_X ">\n" AXIS_X "/></axis>"), "m.xml:3: error: the machine has a second axis X\n"},
    {BASE("<axis name='A' type='linear' direction='1 0 0' location='0 0 0' rate_max='1'/>"),
     "m.xml:2: error: axis A cannot be linear: A B C are rotary, X Y Z U V W are linear\n"},
    {BASE("<axis name='U' type='rotary' direction='1 0 0' location='0 0 0' rate_max='1'/>"),
     "m.xml:2: error: axis U cannot be rotary: A B C are rotary, X Y Z U V W are linear\n"},
    {BASE("<axis name='B' type='rotary' direction='0 1 0' rate_max='1'/>"),
     "m.xml:2: error: rotary axis B needs the attribute 'location', a point on its axis\n"},
    {BASE(AXIS_X " wrap='shortest'/>"), "m.xml:2: error: axis X is linear: only a rotary axis can have wrap\n"},
    {BASE(AXIS_X " half_turn='positive'/>"),
     "m.xml:2: error: axis X is linear: only a rotary axis can have half_turn\n"},
    {BASE("<axis name='X' type='linear' direction='0 0 0' rate_max='1'/>"),
     "m.xml:2: error: direction=\"0 0 0\" of <axis> is not a direction: its length must be between 1e-6 and 1e6\n"},
    {BASE("<axis name='X' type='linear' direction='1 0 0' rate_max='0'/>"),
     "m.xml:2: error: rate_max=\"0\" of axis X is not between 1e-6 and 1e9 mm a minute\n"},
    {BASE("<axis name='C' type='rotary' direction='1 0 0' location='0 0 0' rate_max='-3'/>"),
     "m.xml:2: error: rate_max=\"-3\" of axis C is not between 1e-6 and 1e9 degrees a minute\n"},
    {BASE(AXIS_X " limit_min='5' limit_max='5'/>"),
     "m.xml:2: error: limit_min=\"5\" of axis X is not less than limit_max=\"5\"\n"},
    {BASE(AXIS_X " limit_min='5' limit_max='9'/>"),
     "m.xml:2: error: 0, the default home, is outside the limits of axis X: give this axis a home\n"},
    {BASE(AXIS_C " limit_max='90' home='90.000002'/>"),
     "m.xml:2: error: home=\"90.000002\" of axis C is outside its limits\n"},
    {BASE(AXIS_X " home='1e8'/>"), "m.xml:2: error: home=\"1e8\" of <axis> is beyond 10 km: check the units\n"},
    {BASE("<spindle location='0 0 0' direction='0 0 1'/>" AXIS_X
	  ">\n<spindle location='0 0 0' direction='0 0 1'/></axis>"),
     "m.xml:3: error: the machine has a second <spindle>\n"},
    {BASE("<workholding/>" AXIS_X ">\n<workholding/></axis>"),
     "m.xml:3: error: the machine has a second <workholding>\n"},
    {MACHINE("<controller least_input='0.001'/><base/>"),
     "m.xml:2: error: least_input of <controller>: LinuxCNC has no least input increment\n"},
    {MACHINE("<controller power_on_units='inch' power_on_distance='incremental' power_on_plane='zx'/><base/>"),
     "m.xml:2: error: power_on_units of <controller>: LinuxCNC always starts with G21, G90 and G17\n"
     "m.xml:2: error: power_on_distance of <controller>: LinuxCNC always starts with G21, G90 and G17\n"
     "m.xml:2: error: power_on_plane of <controller>: LinuxCNC always starts with G21, G90 and G17\n"},
    {MACHINE("<controller dialect='fanuc' power_on_units='inches'/><base/>"),
     "m.xml:2: error: power_on_units=\"inches\" of <controller> must be mm or inch\n"},
    {MACHINE("<controller dialect='haas' tool_def='ignored'/><base/>"),
     "m.xml:2: error: tool_def of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='haas' plane_retract='always'/><base/>"),
     "m.xml:2: error: plane_retract of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='haas' shift_behind_plane='keeps'/><base/>"),
     "m.xml:2: error: shift_behind_plane of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='haas' cycle_19_angles='axes'/><base/>"),
     "m.xml:2: error: cycle_19_angles of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='haas' cycle_11_axes='all'/><base/>"),
     "m.xml:2: error: cycle_11_axes of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='klartext' frames_outlive_cycle800='no'/><base/>"),
     "m.xml:2: error: frames_outlive_cycle800 of <controller>: Heidenhain Klartext has no such parameter\n"},
    {MACHINE("<controller dialect='klartext' increments_after_shift='traverse'/><base/>"),
     "m.xml:2: error: increments_after_shift of <controller>: Heidenhain Klartext supports only \"stay\"\n"},
    {MACHINE("<controller dialect='haas' increments_after_shift='stay'/><base/>"),
     "m.xml:2: error: increments_after_shift of <controller>: Haas has no such parameter\n"},
    {MACHINE("<controller dialect='fanuc' least_input='2'/><base/>"),
     "m.xml:2: error: least_input=\"2\" of <controller> is not between 1e-6 and 1\n"},
    {MACHINE("<controller><tool_change X='1'/></controller><base/>"),
     "m.xml:2: error: <tool_change> has a position for X, but the machine has no axis X\n"},
    {MACHINE("<controller><tool_change order='X'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: <tool_change> has no position\n"},
    {MACHINE("<controller><tool_change/>\n<tool_change/></controller><base/>"),
     "m.xml:3: error: <tool_change> is given twice\n"},
    {MACHINE("<controller cutter_comp_start='A'/><base/>"),
     "m.xml:2: error: cutter_comp_start of <controller>: LinuxCNC has only one way to start cutter compensation\n"},
    {MACHINE("<controller preset='ngc'/><base/>"), "m.xml:2: error: preset of <controller>: LinuxCNC has no presets\n"},
    {MACHINE("<controller dialect='fanuc' preset='ngc'/><base/>"),
     "m.xml:2: error: preset=\"ngc\" of <controller>: the presets of Fanuc are 16i, 0i-MB, 0i-D, 0i-F or 30i-B\n"},
    {MACHINE("<controller cutter_comp_d='radius'/><base/>"),
     "m.xml:2: error: cutter_comp_d of <controller>: in LinuxCNC, D is the number of a tool\n"},
    {MACHINE("<controller unidirectional_overrun='1'/><base/>"),
     "m.xml:2: error: unidirectional_overrun of <controller>: LinuxCNC has no G60\n"},
    {MACHINE("<controller dialect='fanuc' unidirectional_overrun='0'/><base/>"),
     "m.xml:2: error: unidirectional_overrun of <controller> must be greater than 0\n"},
    {MACHINE("<controller cutter_comp_corner='linear'/><base/>"),
     "m.xml:2: error: cutter_comp_corner of <controller>: LinuxCNC always rounds outside corners\n"},
    {MACHINE("<controller cutter_comp_idle_blocks='3'/><base/>"),
     "m.xml:2: error: cutter_comp_idle_blocks of <controller>: LinuxCNC has no such parameter\n"},
    {MACHINE("<controller m6_with_move='after'/><base/>"),
     "m.xml:2: error: m6_with_move of <controller>: LinuxCNC changes the tool before a block moves\n"},
    {MACHINE("<controller m6_with_t='own'/><base/>"),
     "m.xml:2: error: m6_with_t of <controller>: LinuxCNC loads the tool of the T beside M6\n"},
    {MACHINE("<controller colon='program'/><base/>"),
     "m.xml:2: error: colon of <controller>: LinuxCNC has no program numbers after ':'\n"},
    {MACHINE("<controller dialect='fanuc' arc_radius_tolerance='0'/><base/>"),
     "m.xml:2: error: arc_radius_tolerance of <controller> must be greater than 0\n"},
    {MACHINE("<controller g53_with_g91='absolute'/><base/>"),
     "m.xml:2: error: g53_with_g91 of <controller>: LinuxCNC refuses G53 while G91 is active\n"},
    {MACHINE("<controller length_after_reference='keeps'/><base/>"),
     "m.xml:2: error: length_after_reference of <controller>: LinuxCNC keeps the length offset\n"},
    {MACHINE("<controller length_offset_moves='no'/><base/>"),
     "m.xml:2: error: length_offset_moves of <controller>: LinuxCNC moves no axis when the length offset changes\n"},
    {MACHINE("<controller><reference number='5'/></controller><base/>"),
     "m.xml:2: error: number=\"5\" of <reference> is not between 1 and 4\n"
     "m.xml:2: error: <reference> has no position\n"},
    {MACHINE("<controller><tool_change X='1' order='Z'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change> names 'Z', but <tool_change> has no position for it\n"},
    {MACHINE("<controller><tool_change X='1' order='XX'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change> names X twice\n"},
    {MACHINE("<controller><tool_change X='1' order=''/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change> leaves out X\n"},
    {MACHINE("<controller><tool_change X='1'/>\n<tool_change X='2'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:3: error: <tool_change> is given twice\n"},
    {MACHINE("<controller path_tolerance='0'/><base/>"),
     "m.xml:2: error: path_tolerance of <controller> must be greater than 0\n"},
    {MACHINE(
	 "<controller><mcode number='6' action='ignore'/><mcode number='10000' action='ignore'/></controller><base/>"),
     "m.xml:2: error: M6 has a fixed meaning and cannot be redefined\n"
     "m.xml:2: error: number=\"10000\" of <mcode> is not between 0 and 9999\n"},
    {MACHINE(
	 "<controller><mcode number='50' action='ignore'/>\n<mcode number='50' action='tcp-on'/></controller><base/>"),
     "m.xml:3: error: M50 is given twice\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never'/></pairs>"),
     "m.xml:2: error: <pair> with check=\"never\" needs a reason=\"...\"\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never' reason=''/></pairs>"),
     "m.xml:2: error: <pair> with check=\"never\" needs a reason=\"...\"\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never' reason='r' clearance='1'/></pairs>"),
     "m.xml:2: error: <pair> with check=\"never\" cannot have a clearance\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' clearance='-1'/></pairs>"),
     "m.xml:2: error: clearance=\"-1\" of <pair> is negative\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c'/></pairs>"),
     "m.xml:2: error: <pair> needs a check or a clearance\n"},
    {MACHINE("<base/><pairs><pair a='b' b='b' check='always'/></pairs>"), "m.xml:2: error: <pair> names 'b' twice\n"},
    {MACHINE("<base/><pairs><pair a='b' b='W' check='always'/></pairs>"),
     "m.xml:2: error: b=\"W\" of <pair>: the machine has no axis W\n"},
    {MACHINE("<base/><pairs adjacent_within='-1'/>"),
     "m.xml:2: error: adjacent_within=\"-1\" of <pairs> is negative\n"},
    {MACHINE("<base/><setup version='7'/>"), "m.xml:2: error: version=\"7\" of <setup> must be 1\n"},
    {MACHINE("<base/><setup><fixture name='f' mesh='f.stl'/></setup>"),
     "m.xml:2: error: the machine has no <workholding>, which a <fixture> needs\n"},
};

START_TEST(faults)
{
	const struct xml_case *c = &bad[_i];
	struct messages messages;

	messages_init(&messages);
	write_text("m.xml", c->content);
	ck_assert_ptr_null(machine_load("m.xml", &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text), c->messages);
	strbuf_release(&messages.text);
}
END_TEST

START_TEST(unknown_names_in_pairs)
{
	static const char content[] = BASE("<body name='saddle' mesh='s.stl'/>" AXIS_X "><workholding/></axis>")
		"<!-- -->";
	struct messages messages;
	struct machine *machine;
	struct setup *setup;
	struct strbuf text = {0};

	strbuf_add(&text, content, strlen(content) - strlen("\n</machine>\n<!-- -->"));
	strbuf_addf(&text,
		    "<pairs>\n<pair a='sadle' b='X' check='always'/>\n<pair a='vise' b='saddle' clearance='1'/>\n"
		    "<pair a='X' b='qqqqqq' clearance='1'/></pairs></machine>");
	write_text("m.xml", strbuf_text(&text));
	machine = load_good("m.xml");
	messages_init(&messages);
	ck_assert(machine_check_rules(machine, NULL, &messages.diag));
	ck_assert_str_eq(
	    strbuf_text(&messages.text),
	    "m.xml:3: warning: <pair>: the machine has no body 'sadle', and there is no setup that could have one\n"
	    "m.xml:4: warning: <pair>: the machine has no body 'vise', and there is no setup that could have one\n"
	    "m.xml:5: warning: <pair>: the machine has no body 'qqqqqq', and there is no setup that could have one\n");
	strbuf_clear(&messages.text);
	write_text("s.xml", "<setup version='1'><fixture name='vise' mesh='v.stl'/></setup>");
	setup = setup_load("s.xml", machine, &messages.diag);
	ck_assert_ptr_nonnull(setup);
	ck_assert(!machine_check_rules(machine, setup, &messages.diag));
	ck_assert_str_eq(
	    strbuf_text(&messages.text),
	    "m.xml:3: error: <pair>: neither the machine nor the setup has a body 'sadle'; did you mean 'saddle'?\n"
	    "m.xml:5: error: <pair>: neither the machine nor the setup has a body 'qqqqqq'\n");
	setup_free(setup);
	machine_free(machine);
	strbuf_release(&messages.text);
	strbuf_release(&text);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("machine_bad");

	tcase_add_loop_test(tcase, faults, 0, COUNT(bad));
	tcase_add_test(tcase, unknown_names_in_pairs);
	return run_in_folders("machine_bad", tcase);
}
