/* test_machine.c - machine files, good and bad. */
#include <math.h>
#include <sys/stat.h>

#include "base/mem.h"
#include "base/units.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "xml_case.h"

#define AXIS_X "<axis name='X' type='linear' direction='1 0 0' rate_max='6000'"
#define AXIS_C "<axis name='C' type='rotary' direction='0 0 1' location='1 2 3' rate_max='3600'"
#define MACHINE(content) "<machine version='1'>\n" content "\n</machine>\n"
#define BASE(content) MACHINE("<base>" content "</base>")

static const char trunnion[] =
	"<?xml version='1.0' encoding='UTF-8'?>\n"
	"<machine version='1' name='trunnion &amp; co' units='mm'>\n"
	"  <pairs adjacent_within='7.5'>\n"
	"    <pair a='cradle' b='X' check='always' clearance='2'/>\n"
	"    <pair a='base' b='cover' check='never' reason='bellows'/>\n"
	"    <pair a='holder' b='fixture' clearance='1'/>\n"
	"  </pairs>\n"
	"  <controller dialect='haas' rapid='dogleg' tcp_zero='offset' path_tolerance='0.02' "
	"least_input='0.001' length_offset_moves='yes'>\n"
	"    <tool_change Y='-10' C='90' X='3' order='Y XC'/><reference number='1' Y='11'/>\n"
	"    <reference number='3' X='1' Y='-2' order='YX'/>\n"
	"    <mcode number='428' action='tcp-on'/><mcode number='429' action='tcp-off'/><mcode number='10' "
	"action='ignore'/>\n"
	"  </controller>\n"
	"  <base>\n"
	"    <body name='bed' mesh='ac/bed.stl'/>\n"
	"    <axis name='Y' type='linear' direction='0 2 0' limit_min='-250' limit_max='250' rate_max='30000' home='10'>\n"
	"      <axis name='X' type='linear' direction='0 3 4' rate_max='6000'>\n"
	"        <body name='head' mesh='/abs/head.stl' units='inch' location='1 2 3' rotation='90 0 90'/>\n"
	"        <spindle location='0 0 520' direction='0 0 -2'/>\n"
	"      </axis>\n"
	"    </axis>\n"
	"    <axis name='A' title='First axis' type='rotary' direction='-1 0 0' location='0 0 120'\n"
	"        limit_min='-120' limit_max='30' rate_max='7200' wrap='sign' half_turn='negative'>\n"
	"      <body name='cradle' mesh='ac/cradle.stl'/><body name='cover' mesh='cover.stl' units='m'/>\n"
	"      <axis name='C' type='rotary' direction='0 0 -1' location='0 0 120' rate_max='14400'>\n"
	"        <workholding location='0 0 120' rotation='0 0 90'/>\n"
	"      </axis>\n"
	"    </axis>\n"
	"  </base>\n"
	"</machine>\n";

static struct machine *load_good(const char *path)
{
	struct messages messages;
	struct machine *machine;

	messages_init(&messages);
	machine = machine_load(path, &messages.diag);
	ck_assert_str_eq(strbuf_text(&messages.text), "");
	ck_assert_ptr_nonnull(machine);
	strbuf_release(&messages.text);
	return machine;
}

static void assert_vec3(vec3 v, double x, double y, double z)
{
	ck_assert_double_eq_tol(v.x, x, 1e-12);
	ck_assert_double_eq_tol(v.y, y, 1e-12);
	ck_assert_double_eq_tol(v.z, z, 1e-12);
}

START_TEST(reads_axes)
{
	struct machine *m;
	const struct axis *a;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "trunnion & co");
	ck_assert_str_eq(m->path, "m.xml");
	ck_assert_uint_eq(m->axis_count, 4);
	for (size_t i = 0; i < 4; i++)
		ck_assert_int_eq(m->axes[i].name[0], "YXAC"[i]);
	ck_assert_int_eq(m->axes[0].parent, 0);
	ck_assert_int_eq(m->axes[1].parent, 1);
	ck_assert_int_eq(m->axes[2].parent, 0);
	ck_assert_int_eq(m->axes[3].parent, 3);
	assert_vec3(m->axes[0].direction, 0, 1, 0);
	assert_vec3(m->axes[1].direction, 0, 0.6, 0.8);
	ck_assert_double_eq(m->axes[0].home, 10);
	ck_assert_double_eq(m->axes[0].limit_min, -250);
	ck_assert_double_eq(m->axes[0].rate_max, 500);
	ck_assert(isinf(m->axes[1].limit_max) && m->axes[1].limit_min < 0);
	a = machine_axis(m, SLOT_A);
	ck_assert_str_eq(a->title, "First axis");
	ck_assert_ptr_null(m->axes[0].title);
	ck_assert(a->rotary && a->wrap == WRAP_SIGN && a->half_turn == -1);
	assert_vec3(a->location, 0, 0, 120);
	ck_assert_double_eq_tol(a->limit_min, -120 * PI / 180, 1e-15);
	ck_assert_double_eq_tol(a->rate_max, 120 * PI / 180, 1e-15);
	ck_assert_ptr_null(machine_axis(m, SLOT_B));
	ck_assert_str_eq(machine_link_name(m, 0), "base");
	ck_assert_str_eq(machine_link_name(m, 4), "C");
	ck_assert_double_eq(machine_home(m).v[SLOT_Y], 10);
	ck_assert_double_eq(machine_home(m).v[SLOT_A], 0);
	machine_free(m);
}
END_TEST

START_TEST(reads_bodies_and_mounts)
{
	struct machine *m;
	vec3 p;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_uint_eq(m->body_count, 4);
	ck_assert_str_eq(m->bodies[0].name, "bed");
	ck_assert_str_eq(m->bodies[0].mesh_path, "ac/bed.stl");
	ck_assert_int_eq(m->bodies[0].loc.line, 14);
	ck_assert_str_eq(m->bodies[0].loc.file, "m.xml");
	ck_assert_double_eq(m->bodies[0].scale, 1);
	ck_assert_str_eq(m->bodies[1].mesh_path, "/abs/head.stl");
	ck_assert_int_eq(m->bodies[1].link, 2);
	ck_assert_double_eq(m->bodies[1].scale, 25.4);
	ck_assert_double_eq(m->bodies[3].scale, 1000);
	ck_assert_ptr_null(m->bodies[1].solid);
	/* X by 90 takes y to z, then Z by 90 takes x to y: y -> z, z -> -y -> x, x -> y. */
	p = xform_apply(&m->bodies[1].placement, (vec3){10, 20, 30});
	assert_vec3(p, 1 + 30, 2 + 10, 3 + 20);
	ck_assert(m->spindle.present && m->spindle.link == 2);
	assert_vec3(m->spindle.location, 0, 0, 520);
	assert_vec3(m->spindle.direction, 0, 0, -1);
	ck_assert(m->workholding.present && m->workholding.link == 4);
	assert_vec3(xform_apply(&m->workholding.frame, (vec3){1, 0, 0}), 0, 1, 120);
	machine_free(m);
}
END_TEST

static void check_places(const struct controller *controller)
{
	const struct machine_place *change = &controller->tool_change, *first = &controller->references[0],
				   *third = &controller->references[2];

	ck_assert_double_eq(controller->least_input, 0.001);
	ck_assert_int_eq(controller->length_moves, ANSWER_YES);
	ck_assert(change->given && change->has[SLOT_X] && change->has[SLOT_Y] && change->has[SLOT_C]);
	ck_assert(!change->has[SLOT_Z] && !change->has[SLOT_A]);
	ck_assert_double_eq(change->value.v[SLOT_Y], -10);
	ck_assert_double_eq(change->value.v[SLOT_C], radians(90));
	ck_assert_uint_eq(change->order_count, 3);
	ck_assert(change->order[0] == SLOT_Y && change->order[1] == SLOT_X && change->order[2] == SLOT_C);
	ck_assert(first->given && first->has[SLOT_Y] && !first->has[SLOT_X]);
	ck_assert_double_eq(first->value.v[SLOT_Y], 11);
	ck_assert_uint_eq(first->order_count, 0);
	ck_assert(!controller->references[1].given && !controller->references[3].given);
	ck_assert(third->order_count == 2 && third->order[0] == SLOT_Y && third->order[1] == SLOT_X);
}

START_TEST(reads_controller_and_pairs)
{
	struct machine *m;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_int_eq(m->controller.dialect, DIALECT_HAAS);
	ck_assert_int_eq(m->controller.rapid, RAPID_DOGLEG);
	ck_assert(m->controller.tcp_zero_offset);
	ck_assert_double_eq(m->controller.path_tolerance, 0.02);
	ck_assert_uint_eq(m->controller.mcode_count, 3);
	ck_assert_int_eq(m->controller.mcodes[1].number, 429);
	ck_assert_int_eq(m->controller.mcodes[1].action, MCODE_TCP_OFF);
	check_places(&m->controller);
	ck_assert_double_eq(m->adjacent_within, 7.5);
	ck_assert_uint_eq(m->rule_count, 3);
	ck_assert_int_eq(m->rules[0].a.kind, NAME_BODY);
	ck_assert_str_eq(m->rules[0].a.body, "cradle");
	ck_assert_int_eq(m->rules[0].b.kind, NAME_LINK);
	ck_assert_int_eq(m->rules[0].b.link, 2);
	ck_assert_int_eq(m->rules[0].check, PAIR_ALWAYS);
	ck_assert_double_eq(m->rules[0].clearance, 2);
	ck_assert_int_eq(m->rules[0].line, 4);
	ck_assert_int_eq(m->rules[1].a.kind, NAME_LINK);
	ck_assert_int_eq(m->rules[1].a.link, 0);
	ck_assert_int_eq(m->rules[1].check, PAIR_NEVER);
	ck_assert_str_eq(m->rules[1].reason, "bellows");
	ck_assert(m->rules[1].clearance < 0);
	ck_assert_int_eq(m->rules[2].a.kind, NAME_ROLE);
	ck_assert_int_eq(m->rules[2].a.role, ROLE_HOLDER);
	ck_assert_int_eq(m->rules[2].b.role, ROLE_FIXTURE);
	ck_assert_int_eq(m->rules[2].check, PAIR_DERIVED);
	machine_free(m);
}
END_TEST

START_TEST(defaults)
{
	struct machine *m;

	write_text("m.xml", MACHINE("<base/>"));
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "");
	ck_assert_uint_eq(m->axis_count + m->body_count + m->rule_count + m->controller.mcode_count, 0);
	ck_assert_int_eq(m->controller.dialect, DIALECT_LINUXCNC);
	ck_assert_int_eq(m->controller.rapid, RAPID_LINEAR);
	ck_assert(!m->controller.tcp_zero_offset && !m->spindle.present && !m->workholding.present);
	ck_assert_double_eq(m->controller.path_tolerance, 0);
	ck_assert_double_eq(m->adjacent_within, 5);
	ck_assert_ptr_null(m->setup);
	machine_free(m);
}
END_TEST

START_TEST(inches)
{
	struct machine *m;

	write_text("m.xml",
		   "<machine version='1' units='inch'><controller path_tolerance='0.01'/><base>"
		   "<body name='b' mesh='b.stl' location='1 0 0'/><body name='c' mesh='c.stl' units='cm'/>" AXIS_X
		   " limit_min='-1' limit_max='2' home='1'>" AXIS_C
		   " limit_max='90' home='45'><spindle location='0 0 10' direction='0 0 -1'/></axis></axis></base>"
		   "<pairs adjacent_within='0.5'><pair a='b' b='c' clearance='0.1'/></pairs>"
		   "<setup><offset number='1' length='3'/></setup></machine>");
	m = load_good("m.xml");
	ck_assert_double_eq_tol(m->axes[0].limit_min, -25.4, 1e-12);
	ck_assert_double_eq_tol(m->axes[0].home, 25.4, 1e-12);
	ck_assert_double_eq_tol(m->axes[0].rate_max, 2540, 1e-9);
	ck_assert_double_eq_tol(m->axes[1].rate_max, PI / 3, 1e-12);
	ck_assert_double_eq_tol(m->axes[1].limit_max, PI / 2, 1e-12);
	assert_vec3(m->axes[1].location, 25.4, 50.8, 3 * 25.4);
	assert_vec3(m->spindle.location, 0, 0, 254);
	assert_vec3(m->bodies[0].placement.translation, 25.4, 0, 0);
	ck_assert_double_eq(m->bodies[0].scale, 25.4);
	ck_assert_double_eq(m->bodies[1].scale, 10);
	ck_assert_double_eq_tol(m->adjacent_within, 12.7, 1e-12);
	ck_assert_double_eq_tol(m->rules[0].clearance, 2.54, 1e-12);
	ck_assert_double_eq_tol(m->controller.path_tolerance, 0.254, 1e-12);
	ck_assert_double_eq_tol(m->setup->lengths[0].length, 76.2, 1e-12);
	machine_free(m);
}
END_TEST

START_TEST(mesh_beside_its_file)
{
	struct machine *m;
	char path[128];

	ck_assert_int_eq(mkdir("sub", 0777), 0);
	write_text("sub/m.xml", BASE("<body name='b' mesh='stl/b.stl'/><body name='c' mesh='/c.stl'/>"));
	m = load_good("sub/m.xml");
	ck_assert_str_eq(m->bodies[0].mesh_path, "sub/stl/b.stl");
	ck_assert_str_eq(m->bodies[1].mesh_path, "/c.stl");
	machine_free(m);
	snprintf(path, sizeof(path), "%s/sub/m.xml", folder);
	m = load_good(path);
	ck_assert_int_eq(strncmp(m->bodies[0].mesh_path, folder, strlen(folder)), 0);
	ck_assert_str_eq(m->bodies[0].mesh_path + strlen(folder), "/sub/stl/b.stl");
	machine_free(m);
}
END_TEST

/* The setup stands before what it is mounted on. */
START_TEST(setup_inside)
{
	struct machine *m;

	write_text("m.xml", "<machine version='1' units='mm'><setup units='inch' initial_tool='2'>"
			    "<work_offset name='G55' X='1' C='90'/><fixture name='vise' mesh='v.stl' location='1 0 0'/>"
			    "<tool number='2' length='1'><cutter><section length='1' "
			    "diameter='1'/></cutter></tool></setup><base>" AXIS_X
			    "><spindle location='0 0 100' direction='0 0 -1'/></axis>" AXIS_C
			    "><workholding location='0 0 7'/></axis></base></machine>");
	m = load_good("m.xml");
	ck_assert_ptr_nonnull(m->setup);
	ck_assert_int_eq(m->setup->initial_tool, 2);
	ck_assert_str_eq(m->setup->bodies[0].name, "vise");
	ck_assert_int_eq(m->setup->bodies[0].link, 2);
	ck_assert_double_eq(m->setup->bodies[0].scale, 25.4);
	assert_vec3(m->setup->bodies[0].placement.translation, 25.4, 0, 7);
	ck_assert_int_eq(m->setup->bodies[1].link, 1);
	assert_vec3(m->setup->bodies[1].placement.translation, 0, 0, 100);
	ck_assert_double_eq_tol(m->setup->offsets[0].value.v[SLOT_X], 25.4, 1e-12);
	ck_assert_double_eq_tol(m->setup->offsets[0].value.v[SLOT_C], PI / 2, 1e-12);
	machine_free(m);
}
END_TEST

START_TEST(limits_have_a_tolerance)
{
	struct machine *m;

	write_text("m.xml", BASE(AXIS_X " limit_min='0.0000009' limit_max='5'/>" AXIS_C
				       " limit_min='-90' limit_max='-0.0000009'/>"));
	m = load_good("m.xml");
	machine_free(m);
}
END_TEST

static const struct xml_case bad[] = {
    /* the file as XML */
    {"", "m.xml:1: error: this is not XML: it does not start with '<'\n"},
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
     "m.xml:1: error: document type declarations (<!DOCTYPE ...>) are not allowed; remove it\n"},
    {"<?xml version='1.0'?>\n<!DOCTYPE m [<!ENTITY a 'x'><!ENTITY b '&a;&a;&a;'>]>\n<machine version='&b;'/>",
     "m.xml:2: error: document type declarations (<!DOCTYPE ...>) are not allowed; remove it\n"},
    {"<machine version='1' name='&nbsp;'><base/></machine>",
     "m.xml:1: error: this is not well-formed XML: Entity 'nbsp' not defined\n"},
    {"<lathe version='1'/>",
     "m.xml:1: error: the root element is <lathe>, but a machine file starts with <machine version=\"1\">\n"},
    {"<setup version='1'/>",
     "m.xml:1: error: this is a setup file where a machine file is wanted: give it with --setup\n"},
    {"<machine version='2'><novelty/></machine>",
     "m.xml:1: error: version \"2\" of the machine file is not supported; this program reads version 1\n"},
    /* its form */
    {"<machine><base/></machine>", "m.xml:1: error: <machine> lacks the attribute 'version'\n"},
    {MACHINE(""), "m.xml:1: error: <machine> lacks <base>\n"},
    {MACHINE("<base/>\n<base/>"), "m.xml:3: error: <machine> has a second <base>\n"},
    {MACHINE("<base/><pairs/><pairs/>"), "m.xml:2: error: <machine> has a second <pairs>\n"},
    {MACHINE("<base/><controler/>"),
     "m.xml:2: error: unknown element <controler> in <machine>; did you mean <controller>?\n"},
    {BASE("<conveyor/>"), "m.xml:2: error: unknown element <conveyor> in <base>\n"},
    {BASE("<pair a='b' b='c'/>"), "m.xml:2: error: element <pair> does not belong in <base>\n"},
    {BASE(AXIS_X " direcion='0 0 1'/>"),
     "m.xml:2: error: unknown attribute 'direcion' of <axis>; did you mean 'direction'?\n"},
    {BASE(AXIS_X " colour='red'/>"), "m.xml:2: error: unknown attribute 'colour' of <axis>\n"},
    {BASE("<axis name='X' type='linear' direction='1 0 0'/>"),
     "m.xml:2: error: <axis> lacks the attribute 'rate_max'\n"},
    {BASE(AXIS_X " home='ten'/>"), "m.xml:2: error: home=\"ten\" of <axis> is not a number\n"},
    {BASE(AXIS_X " home='1,5'/>"), "m.xml:2: error: home=\"1,5\" of <axis> is not a number\n"},
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
     "m.xml:2: error: dialect=\"heidenhain\" of <controller> must be linuxcnc, fanuc or haas\n"},
    {MACHINE("<controller><mcode number='-5' action='on'/></controller><base/>"),
     "m.xml:2: error: number=\"-5\" of <mcode> must be a whole number, 0 or more\n"
     "m.xml:2: error: action=\"on\" of <mcode> must be tcp-on, tcp-off or ignore\n"},
    {BASE("<body name='b' mesh='b.stl' units='feet'/>"),
     "m.xml:2: error: units=\"feet\" of <body> must be mm, inch, cm or m\n"},
    {BASE("steel"), "m.xml:2: error: <base> holds text; only elements belong there\n"},
    {"<machine version='1' xmlns='http://example.org/'><base/></machine>",
     "m.xml:1: error: <machine> declares a namespace; these files use none\n"
     "m.xml:1: error: element <base> is in a namespace; these files use none\n"
     "m.xml:1: error: <machine> lacks <base>\n"},
    /* its meaning */
    {BASE("<body name='b' mesh=''/>"), "m.xml:2: error: mesh=\"\" of <body> is empty\n"},
    {BASE("<body name='' mesh='b.stl'/>"), "m.xml:2: error: name=\"\" of <body> is empty\n"},
    {BASE("<body name='a&#9;b' mesh='b.stl'/>"), "m.xml:2: error: name=\"a?b\" of <body> holds a control character\n"},
    {BASE("<body name='a&#155;b' mesh='b.stl'/>"),
     "m.xml:2: error: name=\"a??b\" of <body> holds a control character\n"},
    {BASE("<body name='b' mesh='b.stl'/>\n<body name='b' mesh='c.stl'/>"),
     "m.xml:3: error: the name 'b' is taken: another body has it (m.xml:2)\n"},
    {BASE("<body name='holder' mesh='b.stl'/>\n<body name='Z' mesh='c.stl'/>"),
     "m.xml:2: error: a body cannot be named 'holder': in a <pair> that word means something else\n"
     "m.xml:3: error: a body cannot be named 'Z': in a <pair> that word means something else\n"},
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
     "m.xml:2: error: axis B is rotary and lacks the attribute 'location', a point on its axis\n"},
    {BASE(AXIS_X " wrap='shortest'/>"), "m.xml:2: error: axis X is linear: only a rotary axis can have wrap\n"},
    {BASE(AXIS_X " half_turn='positive'/>"),
     "m.xml:2: error: axis X is linear: only a rotary axis can have half_turn\n"},
    {BASE("<axis name='X' type='linear' direction='0 0 0' rate_max='1'/>"),
     "m.xml:2: error: direction=\"0 0 0\" of <axis> is no direction: its length must be between 1e-6 and 1e6\n"},
    {BASE("<axis name='X' type='linear' direction='1 0 0' rate_max='0'/>"),
     "m.xml:2: error: rate_max=\"0\" of axis X is not between 1e-6 and 1e9 mm a minute\n"},
    {BASE("<axis name='C' type='rotary' direction='1 0 0' location='0 0 0' rate_max='-3'/>"),
     "m.xml:2: error: rate_max=\"-3\" of axis C is not between 1e-6 and 1e9 degrees a minute\n"},
    {BASE(AXIS_X " limit_min='5' limit_max='5'/>"),
     "m.xml:2: error: limit_min=\"5\" of axis X is not less than limit_max=\"5\"\n"},
    {BASE(AXIS_X " limit_min='5' limit_max='9'/>"),
     "m.xml:2: error: 0, the default home, lies outside the limits of axis X: give it a home\n"},
    {BASE(AXIS_C " limit_max='90' home='90.000002'/>"),
     "m.xml:2: error: home=\"90.000002\" of axis C lies outside its limits\n"},
    {BASE(AXIS_X " home='1e8'/>"), "m.xml:2: error: home=\"1e8\" of <axis> is beyond 10 km: check the units\n"},
    {BASE("<spindle location='0 0 0' direction='0 0 1'/>" AXIS_X
	  ">\n<spindle location='0 0 0' direction='0 0 1'/></axis>"),
     "m.xml:3: error: the machine has a second <spindle>\n"},
    {BASE("<workholding/>" AXIS_X ">\n<workholding/></axis>"),
     "m.xml:3: error: the machine has a second <workholding>\n"},
    {MACHINE("<controller least_input='0.001'/><base/>"),
     "m.xml:2: error: least_input of <controller>: LinuxCNC has no least input increment\n"},
    {MACHINE("<controller dialect='fanuc' least_input='2'/><base/>"),
     "m.xml:2: error: least_input=\"2\" of <controller> is not between 1e-6 and 1\n"},
    {MACHINE("<controller><tool_change X='1'/></controller><base/>"),
     "m.xml:2: error: <tool_change> has a position for X, but the machine has no axis X\n"},
    {MACHINE("<controller><tool_change order='X'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: <tool_change> gives no position\n"},
    {MACHINE("<controller><tool_change/>\n<tool_change/></controller><base/>"),
     "m.xml:3: error: <tool_change> is given twice\n"},
    {MACHINE("<controller length_offset_moves='no'/><base/>"),
     "m.xml:2: error: length_offset_moves of <controller>: LinuxCNC moves no axis then\n"},
    {MACHINE("<controller><reference number='5'/></controller><base/>"),
     "m.xml:2: error: number=\"5\" of <reference> is not between 1 and 4\n"
     "m.xml:2: error: <reference> gives no position\n"},
    {MACHINE("<controller><tool_change X='1' order='Z'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change>: it gives no position for 'Z'\n"},
    {MACHINE("<controller><tool_change X='1' order='XX'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change> names X twice\n"},
    {MACHINE("<controller><tool_change X='1' order=''/></controller><base>" AXIS_X "/></base>"),
     "m.xml:2: error: order of <tool_change> leaves out X\n"},
    {MACHINE("<controller><tool_change X='1'/>\n<tool_change X='2'/></controller><base>" AXIS_X "/></base>"),
     "m.xml:3: error: <tool_change> is given twice\n"},
    {MACHINE("<controller path_tolerance='0'/><base/>"),
     "m.xml:2: error: path_tolerance of <controller> must be more than 0\n"},
    {MACHINE(
	 "<controller><mcode number='6' action='ignore'/><mcode number='1000' action='ignore'/></controller><base/>"),
     "m.xml:2: error: M6 has a fixed meaning that cannot be changed\n"
     "m.xml:2: error: number=\"1000\" of <mcode> is not between 0 and 999\n"},
    {MACHINE(
	 "<controller><mcode number='50' action='ignore'/>\n<mcode number='50' action='tcp-on'/></controller><base/>"),
     "m.xml:3: error: M50 is given twice\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never'/></pairs>"),
     "m.xml:2: error: <pair> with check=\"never\" needs a reason=\"...\"\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never' reason=''/></pairs>"),
     "m.xml:2: error: <pair> with check=\"never\" needs a reason=\"...\"\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' check='never' reason='r' clearance='1'/></pairs>"),
     "m.xml:2: error: <pair>: what is never checked has no clearance\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c' clearance='-1'/></pairs>"),
     "m.xml:2: error: clearance=\"-1\" of <pair> is negative\n"},
    {MACHINE("<base/><pairs><pair a='b' b='c'/></pairs>"),
     "m.xml:2: error: <pair> says nothing: give it a check or a clearance\n"},
    {MACHINE("<base/><pairs><pair a='b' b='b' check='always'/></pairs>"), "m.xml:2: error: <pair> names 'b' twice\n"},
    {MACHINE("<base/><pairs><pair a='b' b='W' check='always'/></pairs>"),
     "m.xml:2: error: b=\"W\" of <pair>: the machine has no axis W\n"},
    {MACHINE("<base/><pairs adjacent_within='-1'/>"),
     "m.xml:2: error: adjacent_within=\"-1\" of <pairs> is negative\n"},
    {MACHINE("<base/><setup version='7'/>"), "m.xml:2: error: version=\"7\" of <setup> must be 1\n"},
    {MACHINE("<base/><setup><fixture name='f' mesh='f.stl'/></setup>"),
     "m.xml:2: error: the machine has no <workholding> for a <fixture>\n"},
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

static void assert_refused(const char *path, const char *expected)
{
	struct messages messages;

	messages_init(&messages);
	ck_assert_ptr_null(machine_load(path, &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text), expected);
	strbuf_release(&messages.text);
}

START_TEST(refuses_what_is_no_file)
{
	assert_refused("none.xml", "none.xml: error: cannot open: No such file or directory\n");
	assert_refused("-", "-: error: XML files are not read from standard input: name a file\n");
	assert_refused("/", "/: error: is a directory, not an XML file\n");
	assert_refused("/dev/null", "/dev/null: error: is not a regular file\n");
	ck_assert_int_eq(mkfifo("fifo", 0600), 0);
	assert_refused("fifo", "fifo: error: is not a regular file\n");
}
END_TEST

START_TEST(refuses_giants)
{
	size_t size = 4 * 1024 * 1024 + 1;
	char *bytes = mem_alloc(size);

	memset(bytes, ' ', size);
	write_bytes("m.xml", bytes, size);
	assert_refused("m.xml", "m.xml: error: larger than 4 MiB: this is no machine, setup or waivers file\n");
	memcpy(bytes, "<machine version='1' name='", 27);
	memset(bytes + 27, 'x', size - 28);
	memcpy(bytes + size - 31, "'><base/></machine>", 19);
	write_bytes("m.xml", bytes, size - 12);
	assert_refused("m.xml",
		       "m.xml:1: error: name=\"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
		       "xxxxxxxxxxxxxxxx...\" of <machine> is too long\n");
	free(bytes);
}
END_TEST

START_TEST(refuses_foreign_bytes)
{
	static const char utf16[] = "\xff\xfe<\0m\0a\0c\0h\0i\0n\0e\0/\0>";
	static const char ebcdic[] = "\x4c\x6f\xa7\x94\x93";

	write_bytes("m.xml", utf16, sizeof(utf16));
	assert_refused("m.xml", "m.xml: error: there are NUL bytes in it: this is no text, or not UTF-8\n");
	write_text("m.xml", ebcdic);
	assert_refused("m.xml", "m.xml:1: error: this is not XML: it does not start with '<'\n");
}
END_TEST

START_TEST(reads_other_encodings)
{
	struct machine *m;

	write_text(
	    "m.xml",
	    "<?xml version='1.0' encoding='ISO-8859-1'?>\n<machine version='1' name='Fr\xe4se'><base/></machine>");
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "Fr\xc3\xa4se");
	machine_free(m);
	write_text(
	    "m.xml",
	    "\xef\xbb\xbf<?xml version='1.0'?><!-- ====== <x a='> --><machine version='1' name='>='><base/></machine>");
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, ">=");
	machine_free(m);
}
END_TEST

/* Each of these kept a parser or validator busy for minutes. */
START_TEST(refuses_quickly)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<?xml version='1.0'?>\n<!-- <x '> --><machine version='1'></x '>\n<x");
	for (int i = 0; i < 250000; i++)
		strbuf_addf(&text, " a%d=''", i);
	strbuf_addf(&text, "><base/></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:3: error: this tag has more than 1000 attributes\n");
	strbuf_clear(&text);
	strbuf_addf(&text, "<machine version='1'><base/><setup>");
	for (int i = 0; i < 120000; i++)
		strbuf_addf(&text, "<offset number='1' length='1'/>");
	strbuf_addf(&text, "</setup></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: <setup> holds more than 20000 elements\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(refuses_depth)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 100; i++)
		strbuf_addf(&text, AXIS_X ">");
	for (int i = 0; i < 100; i++)
		strbuf_addf(&text, "</axis>");
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: elements are nested more than 64 deep\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(refuses_crowds)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 4097; i++)
		strbuf_addf(&text, "<body name='b%d' mesh='b'/>", i);
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: there are 4097 bodies; more than 4096 are not supported\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(stops_telling_after_twenty)
{
	struct strbuf text = {0};
	struct messages messages;
	size_t lines = 0;

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 50; i++)
		strbuf_addf(&text, "<bdy/>");
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	messages_init(&messages);
	ck_assert_ptr_null(machine_load("m.xml", &messages.diag));
	ck_assert_uint_eq(messages.diag.errors, 20);
	for (const char *at = strbuf_text(&messages.text); *at; at++)
		lines += *at == '\n';
	ck_assert_uint_eq(lines, 21);
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&messages.text), "m.xml: note: there are more faults than these 20\n"));
	strbuf_release(&messages.text);
	strbuf_release(&text);
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
	    "m.xml:3: warning: <pair>: the machine has no body 'sadle', and there is no setup that could\n"
	    "m.xml:4: warning: <pair>: the machine has no body 'vise', and there is no setup that could\n"
	    "m.xml:5: warning: <pair>: the machine has no body 'qqqqqq', and there is no setup that could\n");
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

/* Cut anywhere, or with any byte replaced, a file is read or refused, no more. */
START_TEST(survives_damage)
{
	static const char replacements[] = {'<', '>', '"', '\'', '&', '\0', ' ', '9', (char)0xff};
	char damaged[sizeof(trunnion)];
	size_t length = sizeof(trunnion) - 1;
	struct diag diag = {0};

	/* Without the final newline it is whole. */
	for (size_t i = 0; i < length - 1; i++) {
		write_bytes("m.xml", trunnion, i);
		ck_assert_ptr_null(machine_load("m.xml", &diag));
	}
	for (size_t i = 0; i < length; i++) {
		memcpy(damaged, trunnion, sizeof(trunnion));
		damaged[i] = replacements[i % sizeof(replacements)];
		write_bytes("m.xml", damaged, length);
		machine_free(machine_load("m.xml", &diag));
	}
	ck_assert_uint_gt(diag.errors, length);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("machine");
	TCase *good = tcase_create("good"), *faulty = tcase_create("faulty");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(good, enter_folder, leave_folder);
	tcase_add_test(good, reads_axes);
	tcase_add_test(good, reads_bodies_and_mounts);
	tcase_add_test(good, reads_controller_and_pairs);
	tcase_add_test(good, defaults);
	tcase_add_test(good, inches);
	tcase_add_test(good, mesh_beside_its_file);
	tcase_add_test(good, setup_inside);
	tcase_add_test(good, reads_other_encodings);
	tcase_add_test(good, limits_have_a_tolerance);
	suite_add_tcase(suite, good);
	tcase_add_checked_fixture(faulty, enter_folder, leave_folder);
	tcase_set_timeout(faulty, 120);
	tcase_add_loop_test(faulty, faults, 0, (int)(sizeof(bad) / sizeof(bad[0])));
	tcase_add_test(faulty, refuses_what_is_no_file);
	tcase_add_test(faulty, refuses_giants);
	tcase_add_test(faulty, refuses_foreign_bytes);
	tcase_add_test(faulty, refuses_quickly);
	tcase_add_test(faulty, refuses_depth);
	tcase_add_test(faulty, refuses_crowds);
	tcase_add_test(faulty, stops_telling_after_twenty);
	tcase_add_test(faulty, unknown_names_in_pairs);
	tcase_add_test(faulty, survives_damage);
	suite_add_tcase(suite, faulty);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
