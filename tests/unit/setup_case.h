/* setup_case.h - a machine and a whole setup file, for tests of setup files. */
#ifndef FIVECHECK_TESTS_SETUP_CASE_H
#define FIVECHECK_TESTS_SETUP_CASE_H

#include "machine/machine.h"
#include "machine/setup.h"
#include "xml_case.h"

static const char machine_text[] =
	"<machine version='1'><base><body name='bed' mesh='bed.stl'/><body name='T8 cutter' mesh='t.stl'/>\n"
	"<axis name='X' type='linear' direction='1 0 0' rate_max='1'><spindle location='1 2 300' direction='0 3 "
	"4'/></axis>\n"
	"<axis name='C' type='rotary' direction='0 0 1' location='0 0 0' rate_max='1'>\n"
	"<workholding location='5 0 40' rotation='0 0 90'/></axis></base></machine>";

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

#endif
