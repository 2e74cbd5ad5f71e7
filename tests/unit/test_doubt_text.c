/* test_doubt_text.c - each kind of doubt has its sentence, with all of its words filled in. */
#include "report/doubt_text.h"

#include <string.h>

#include "model_case.h"
#include "suite.h"

/* A mill with two bodies, a tool and a work offset: everything that a doubt may name. */
static void start(struct model *model, struct work_offset *offset)
{
	model_init(model);
	model_body(model, ROLE_MACHINE, LINK_BASE);
	model_body(model, ROLE_PART, LINK_C);
	model_tool(model, 7, 80);
	*offset = (struct work_offset){.name = "G54"};
	model->setup.offsets = offset;
	model->setup.offset_count = 1;
}

static void release(struct model *model)
{
	model->setup.offsets = NULL;
	model_release(model);
}

START_TEST(every_kind)
{
	struct work_offset offset;
	struct model model;

	start(&model, &offset);
	for (int kind = 0; kind <= DOUBT_OFFSET_FAR; kind++) {
		const struct doubt doubt = {.kind = (enum doubt_kind)kind, .axis = 1, .body = 1, .value = 2, .limit = 3};
		struct strbuf out = {0};

		doubt_text_add(&out, model.scene, &doubt);
		require(out.length > 60 && !strpbrk(out.text, "{}\n"), "kind %d: %s", kind, out.text);
		strbuf_release(&out);
	}
	release(&model);
}
END_TEST

static void expect(const struct model *model, struct doubt doubt, const char *text)
{
	struct strbuf out = {0};

	doubt_text_add(&out, model->scene, &doubt);
	ck_assert_str_eq(out.text, text);
	strbuf_release(&out);
}

/* Angles are written in degrees, and a statement about an axis names the bodies that it carries. */
START_TEST(words)
{
	struct work_offset offset;
	struct model model;

	start(&model, &offset);
	expect(&model, (struct doubt){.kind = DOUBT_OFFSET_OUTSIDE, .axis = 0, .value = 612.3456},
	       "work offset G54 has X 612.346 mm, outside the axis' travel (-500 to 500 mm); check its values, their "
	       "signs and units, or give it checked=\"reason\"");
	expect(&model, (struct doubt){.kind = DOUBT_RADIANS, .axis = 3, .value = 0.05},
	       "axis C has a travel of only 2.865 degrees: limits are degrees, not radians; check them, or say why "
	       "they are right: <axis name=\"C\" checked=\"reason\">");
	expect(&model, (struct doubt){.kind = DOUBT_ROTARY_SIGN, .axis = 3},
	       "axis C: a positive value turns the work so that the tool turns left-handed about Z relative to the work "
	       "(ISO 841: right-handed; an axis that turns the work has the opposite direction); reverse its "
	       "direction, or say why it is right: <axis name=\"C\" checked=\"reason\">");
	expect(&model, (struct doubt){.kind = DOUBT_TOOL_BARE},
	       "tool 7 has no <holder>, which is what collides first; describe it, or give it checked=\"reason\"");
	expect(&model, (struct doubt){.kind = DOUBT_TOOL_BARE, .value = 4},
	       "tool 7 and 4 more have no <holder>, which is what collides first; describe it, or give it "
	       "checked=\"reason\"");
	release(&model);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {every_kind, words};

	return RUN_TESTS("doubt_text", tests);
}
