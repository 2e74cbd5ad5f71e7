/*
 * test_undecided.c - steps that need more effort than allowed: the verdict does not depend on the number of blocks that
 * are checked together, nor on the number of threads.
 */
#include <stdio.h>
#include <string.h>

#include "base/strbuf.h"
#include "check/check.h"
#include "model_case.h"
#include "scene/pairs.h"
#include "suite.h"

/* Node pairs: enough for an ordinary step, but not for many turns next to the table. */
#define EFFORT 20000

static void on_diag(void *context, const struct diag_entry *entry)
{
	diag_format(context, entry);
}

static bool on_finding(void *context, const struct finding *finding)
{
	const bool pair = finding->kind != FINDING_LIMIT;

	strbuf_addf(context, "%s %ld %s - %s %a\n", finding_kind_name(finding->kind), finding->line,
		    pair ? finding->of.pair.a : "", pair ? finding->of.pair.b : "", finding->time);
	return true;
}

static void on_block(void *context, const struct check_block *block)
{
	(void)context;
	(void)block;
}

/* A head (b0) above a turning table (b1), and a slide (b2) that meets a post (b3) at X250. */
static void place_bodies(struct model *model)
{
	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_Z, (vec3){-20, -20, 100}, (vec3){20, 20, 200});
	model_box(model, ROLE_MACHINE, LINK_C, (vec3){-60, -60, -20}, (vec3){60, 60, 0});
	model_box(model, ROLE_MACHINE, LINK_X, (vec3){-30, -30, 250}, (vec3){30, 30, 300});
	model_box(model, ROLE_MACHINE, LINK_BASE, (vec3){280, -30, 250}, (vec3){300, 30, 300});
	pairs_derive(model->scene, 0, 1);
}

static void run(struct model *model, const char *text, const struct check_options *options, struct strbuf *heard)
{
	const struct check_sink sink = {heard, on_finding, NULL, options->times ? on_block : NULL};
	struct diag diag = {.handle = on_diag, .context = heard};
	struct check_stats stats;
	FILE *in = tmpfile();
	enum check_result result;

	ck_assert_ptr_nonnull(in);
	fputs(text, in);
	rewind(in);
	result = check_run(model->scene, options, in, "a.nc", &sink, &diag, &stats, NULL);
	strbuf_addf(heard, "result %d\n", (int)result);
	fclose(in);
}

/* Runs the program in several ways, which must give the same output. It must contain `expected` and not `never`. */
static void require_one_verdict(const char *text, bool all, const char *expected, const char *never)
{
	struct strbuf plain = {0};

	for (int way = 0; way < 8; way++) {
		const struct check_options options = {
			.tolerance = 0.001, .effort = EFFORT, .all = all, .times = way == 1, .threads = way > 1 && way < 5 ? way : 1,
			.block_clearances = way == 5 || way == 6, .block_clearance_cap = 10, .least_clearances = way == 6,
		};
		struct strbuf heard = {0};
		struct model model;

		place_bodies(&model);
		run(&model, text, &options, way ? &heard : &plain);
		model_release(&model);
		ck_assert_msg(!way || !strcmp(strbuf_text(&plain), strbuf_text(&heard)), "way %d, plain:\n%s\nbut:\n%s", way,
			      strbuf_text(&plain), strbuf_text(&heard));
		strbuf_release(&heard);
	}
	ck_assert_msg(strstr(strbuf_text(&plain), expected) != NULL, "%s\n%s", expected, strbuf_text(&plain));
	ck_assert_msg(!strstr(strbuf_text(&plain), never), "%s\n%s", never, strbuf_text(&plain));
	strbuf_release(&plain);
}

/* A check ends with the step that needs too much effort: contacts of other pairs later in the batch are not listed. */
START_TEST(ends_with_its_step)
{
	static const char text[] = "G21 G90 G94 F60000\nG1 X80 Z-50\nG1 X260\nG1 X80.01 Z-99.999\nG1 C360000\nG1 X260\nG1 X80\n"
				   "G1 Z600\n";
	static const char first[] = "G21 G90 G94 F60000\nG1 X80.01 Z-99.999\nG1 C360000\nG1 X260\nG1 X80\n";

	require_one_verdict(text, true, "a.nc:5:1: error: 'b0' and 'b1'", "limit");
	require_one_verdict(text, true, "collision 3", "collision 6");
	require_one_verdict(first, false, "a.nc:3:1: error: 'b0' and 'b1'", "collision");
}
END_TEST

/* A post (b0) that turns within a frame of four bars (b1), which moves with X and Z: no plane separates them. */
static void place_frame(struct model *model)
{
	static const vec3 half[] = {{4, 20, 10}, {4, 20, 10}, {20, 4, 10}, {20, 4, 10}};
	static const vec3 at[] = {{18.2, 0, 0}, {-18.2, 0, 0}, {0, 18.2, 0}, {0, -18.2, 0}};
	struct mesh frame = {0};

	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_C, (vec3){-10, -10, -100}, (vec3){10, 10, 100});
	for (int i = 0; i < 4; i++) {
		xform place = {mat3_identity(), at[i]};
		struct mesh bar = {0};

		solid_box(&bar, half[i]);
		solid_place(&bar, &place);
		for (size_t t = 0; t < bar.count; t++) {
			const tri it = tri_of(&bar, t);

			solid_add(&frame, it.p[0], it.p[1], it.p[2]);
		}
		mesh_release(&bar);
	}
	model_mesh(model, model_body(model, ROLE_MACHINE, LINK_Z), &frame);
	pairs_derive(model->scene, 0, 1);
}

/*
 * A rapid whose path is not known, and that needs too much effort: the message names its line, and why the path is not
 * known. The check goes on after it.
 */
START_TEST(names_the_rapid)
{
	static const struct {
		enum rapid rapid;
		const char *text, *message;
	} cases[] = {
		{RAPID_ANY, "G21 G90 G94 F60000\nG1 X0.05\nG0 X-0.04 Z80 C90\nG1 X20\n",
		 "a.nc:3:1: error: 'b0' and 'b1' cannot be decided with reasonable effort: too many axes move at once in "
		 "this rapid, whose path is not known (rapid=\"any\"); "},
		{RAPID_DOGLEG, "G21 G90 G94 F60000\nG43.4 H0\nG0 Z80 C90\nG1 X20\n",
		 "a.nc:3:1: error: 'b0' and 'b1' cannot be decided with reasonable effort: too many axes move at once in "
		 "this rapid, whose path is not known (rapid=\"dogleg\": with TCP each axis "},
	};

	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		const struct check_options options = {.tolerance = 0.001, .effort = EFFORT, .all = true};
		struct strbuf heard = {0};
		struct model model;

		place_frame(&model);
		model.machine.controller.rapid = cases[i].rapid;
		run(&model, cases[i].text, &options, &heard);
		ck_assert_ptr_nonnull(strstr(strbuf_text(&heard), cases[i].message));
		ck_assert_ptr_nonnull(strstr(strbuf_text(&heard), "\ncollision 4 b0 - b1"));
		model_release(&model);
		strbuf_release(&heard);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("undecided");

	tcase_add_test(tcase, ends_with_its_step);
	tcase_add_test(tcase, names_the_rapid);
	return run_suite("undecided", tcase);
}
