/* machine_case.h - for the tests of machine files: a good one, and what becomes of a file. */
#ifndef FIVECHECK_TESTS_MACHINE_CASE_H
#define FIVECHECK_TESTS_MACHINE_CASE_H

#include "machine/machine.h"
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
	"least_input='0.001' length_offset_moves='yes' length_after_reference='cancels' g53_with_g91='incremental' power_on_units='inch' "
	"power_on_distance='incremental' power_on_plane='yz' m6_with_move='before' m6_with_t='before' length_under_g68='straight' polar_axes='XB' semicolon='comment' colon='block' power_on_motion='feed' cycle_repeats='L' arc_radius_tolerance='0.5'>\n"
	"    <tool_change Y='-10' C='90' X='3' order='Y XC'/><reference number='1' Y='11'/>\n"
	"    <reference number='3' X='1' Y='-2' order='YX'/>\n"
	"    <mcode number='428' action='tcp-on'/><mcode number='429' action='tcp-off'/><mcode number='10' "
	"action='ignore'/>\n"
	"  </controller>\n"
	"  <base>\n"
	"    <body name='bed' mesh='ac/bed.stl'/>\n"
	"    <axis name='Y' type='linear' direction='0 2 0' limit_min='-250' limit_max='250' "
	"rate_max='30000' home='10'>\n"
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

static inline struct machine *load_good(const char *path)
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

static inline void assert_refused(const char *path, const char *expected)
{
	struct messages messages;

	messages_init(&messages);
	ck_assert_ptr_null(machine_load(path, &messages.diag));
	ck_assert_str_eq(strbuf_text(&messages.text), expected);
	strbuf_release(&messages.text);
}

/* Runs the one suite of a test program, every test in an empty folder. */
static inline int run_in_folders(const char *name, TCase *tcase)
{
	tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
	return run_suite(name, tcase);
}

#endif
