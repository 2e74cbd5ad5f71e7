/* test_tool_name.c - names of tools that say another diameter than the setup. */
#include "base/units.h"
#include "machine/tool_name.h"
#include "suite.h"

struct named {
	const char *name;
	double diameter;
	bool twice;
};

static const struct named cases[] = {
    /* The diameter of each is half of what its name says. */
    {"ball 10", 5, true},
    {"EM D6", 3, true},
    {"EM d6", 3, true},
    {"D=10", 5, true},
    {"EM D 12,7", 6.35, true},
    {"mill .5", 0.25 * MM_PER_INCH, true},
    {"1/2 endmill", MM_PER_INCH / 4, true},
    {"END MILL 6.4", 3.175, true},
    /* The name has the diameter, in mm or inch, perhaps rounded. */
    {"ball 10", 10, false},
    {"10 x 5", 5, false},
    {"1/4 endmill", MM_PER_INCH / 4, false},
    {"END MILL 6.4", 6.35, false},
    /* No diameters: a radius, a length, teeth, a thread, an angle, the tool's own number. */
    {"BALL R10", 5, false},
    {"BALL R=10", 5, false},
    {"L10", 5, false},
    {"EM Z6", 3, false},
    {"M8", 4, false},
    {"V 90 deg", 45, false},
    {"V 90deg", 45, false},
    {"V 90\xb0", 45, false},
    {"V 90\xc2\xb0", 45, false},
    {"T 7", 3.5, false},
    /* Too far from twice the diameter, a fraction of nothing, and an unknown diameter. */
    {"ball 10", 4.8, false},
    {"1/0", 0.5, false},
    {"ball 10", 0, false},
    {"", 5, false},
};

START_TEST(what_a_name_says)
{
	const struct named *named = &cases[_i];
	const struct tool tool = {.number = 7, .name = named->name, .diameter = named->diameter};

	ck_assert_msg(tool_name_tells_twice(&tool) == named->twice, "\"%s\", diameter %g", named->name, named->diameter);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("tool_name");

	tcase_add_loop_test(tcase, what_a_name_says, 0, COUNT(cases));
	return run_suite("tool_name", tcase);
}
