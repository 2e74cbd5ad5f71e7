/*
 * test_spare_threads.c - threads that others no longer need: none is lost, and a check that takes one has the same
 * result as without it.
 */
#include "base/spare_threads.h"

#include <stdio.h>
#include <string.h>

#include "base/parallel_for.h"
#include "base/strbuf.h"
#include "check/check.h"
#include "check/measure/path_record.h"
#include "model_case.h"
#include "scene/pairs.h"
#include "suite.h"

/* ------------------------------------------------------------------ count */

enum { TAKERS = 4, TRIES = 20000, SPARE = 3 };

struct takers {
	struct spare_threads spare;
	atomic_int in_use, strange;
};

static void take_and_give(void *context, int worker, size_t i)
{
	struct takers *takers = context;

	(void)worker;
	(void)i;
	if (!spare_threads_take(&takers->spare))
		return;
	if (atomic_fetch_add(&takers->in_use, 1) >= SPARE)
		atomic_fetch_add(&takers->strange, 1);
	atomic_fetch_sub(&takers->in_use, 1);
	spare_threads_give(&takers->spare, 1);
}

START_TEST(none_is_lost)
{
	struct takers takers = {0};

	ck_assert(!spare_threads_take(NULL));
	ck_assert(!spare_threads_take(&takers.spare));
	spare_threads_give(&takers.spare, SPARE);
	parallel_for(TRIES, TAKERS, take_and_give, &takers);
	ck_assert_int_eq(takers.strange, 0);
	for (int i = 0; i < SPARE; i++)
		ck_assert(spare_threads_take(&takers.spare));
	ck_assert(!spare_threads_take(&takers.spare));
}
END_TEST

/* ------------------------------------------------------------------ check */

enum { BLOCKS = 9000, ASKED_MOST = 10 };

/* All messages and findings of a check, and the number of its events. */
struct heard {
	struct strbuf text;
	struct spare_threads spare;
	int until;	/* from this call of progress on there are spare threads */
	int more;	/* the number of these threads */
	bool ends;	/* the check is interrupted as soon as the threads are taken */
	int least;	/* the least number of spare threads since then */
	int events;
};

static void on_diag(void *context, const struct diag_entry *entry)
{
	struct heard *heard = context;

	diag_format(&heard->text, entry);
}

static bool on_finding(void *context, const struct finding *finding)
{
	struct heard *heard = context;
	const bool pair = finding->kind != FINDING_LIMIT;

	strbuf_addf(&heard->text, "%s %s:%ld %s - %s %a, %d events\n", finding_kind_name(finding->kind), finding->file,
		    finding->line, pair ? finding->of.pair.a : "", pair ? finding->of.pair.b : "", finding->time,
		    heard->events);
	return true;
}

static bool on_progress(void *context, long lines)
{
	struct heard *heard = context;

	(void)lines;
	if (heard->until-- == 0)
		spare_threads_give(&heard->spare, heard->more);
	else if (heard->until < 0 && heard->spare.count < heard->least)
		heard->least = heard->spare.count;
	return !heard->ends || heard->until >= 0 || heard->spare.count > 0;
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct heard *heard = context;

	(void)event;
	heard->events++;
	return true;
}

/*
 * A head above a table that turns: it moves down toward the corners of the table, block by block, and into one of them.
 */
static void place_bodies(struct model *model)
{
	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_Z, (vec3){-20, -20, 100}, (vec3){20, 20, 200});
	model_box(model, ROLE_MACHINE, LINK_X, (vec3){-30, -30, 250}, (vec3){30, 30, 300});
	model_box(model, ROLE_MACHINE, LINK_C, (vec3){-60, -60, -20}, (vec3){60, 60, 0});
	model_box(model, ROLE_MACHINE, LINK_Y, (vec3){-90, -90, -80}, (vec3){90, 90, -40});
	pairs_derive(model->scene, 0, 1);
}

static FILE *program_with(int hit, int fault)
{
	FILE *out = tmpfile();

	ck_assert_ptr_nonnull(out);
	fprintf(out, "G21 G90 G94 F60000\nG0 X80 Z-99\n");
	for (int i = 0; i < BLOCKS; i++) {
		if (i == fault)
			fprintf(out, "G1 Q1\n");
		else
			fprintf(out, "G1 X%d Z%.3f C%d\n", 78 + i % 7, i == hit ? -101.0 : -99.9, i * 3);
	}
	rewind(out);
	return out;
}

/* `more` threads are spare after `until` calls of progress. The value is all output, which the caller releases. */
static struct strbuf check(struct model *model, FILE *in, bool all, bool watched, int until, int more)
{
	struct heard heard = {.until = until, .more = more};
	const struct motion_sink watch = {&heard, on_event};
	const struct check_options options = {.tolerance = 0.001, .threads = 1, .all = all, .spare = &heard.spare,
					      .watch = watched ? &watch : NULL};
	const struct check_sink sink = {&heard, on_finding, on_progress, NULL};
	struct diag diag = {.handle = on_diag, .context = &heard};
	struct check_stats stats;
	enum check_result result;

	rewind(in);
	result = check_run(model->scene, &options, in, "a.nc", &sink, &diag, &stats, NULL);
	strbuf_addf(&heard.text,
		    "result %d, %ld blocks, %ld findings, %ld budgets, %ld planes, %ld queries, %d events\n",
		    (int)result, stats.blocks_checked, stats.findings, stats.budgets, stats.planes, stats.queries,
		    heard.events);
	/* The taken threads are spare again. */
	while (heard.until < 0 && more > 0) {
		ck_assert(spare_threads_take(&heard.spare));
		more--;
	}
	ck_assert(!spare_threads_take(&heard.spare));
	return heard.text;
}

static void expect_same(int hit, int fault, const char *must_say)
{
	struct model model;
	FILE *in = program_with(hit, fault);

	place_bodies(&model);
	for (int way = 0; way < 4; way++) {
		const bool all = way & 1, watched = way & 2;
		struct strbuf alone = check(&model, in, all, watched, 0, 0);

		ck_assert_msg(strstr(strbuf_text(&alone), must_say), "%s", strbuf_text(&alone));
		for (int until = 0; until < ASKED_MOST; until += 1 + until / 2) {
			struct strbuf helped = check(&model, in, all, watched, until, 1 + until % 3);

			ck_assert_str_eq(strbuf_text(&helped), strbuf_text(&alone));
			strbuf_release(&helped);
		}
		strbuf_release(&alone);
	}
	model_release(&model);
	fclose(in);
}

START_TEST(a_clear_check_stays_clear)
{
	expect_same(-1, -1, "result 0, 9002 blocks, 0 findings");
}
END_TEST

START_TEST(findings_and_faults_stay_the_same)
{
	expect_same(6543, 8765, "a.nc:6546");
	expect_same(-1, 4321, "a.nc:4324");
}
END_TEST

/* Taking a spare thread may settle the batch after which the check stops, while other batches have begun. */
START_TEST(an_interrupted_check_gives_its_threads_back)
{
	struct model model;
	FILE *in = program_with(-1, -1);

	place_bodies(&model);
	for (int until = 0; until < ASKED_MOST; until++) {
		struct heard heard = {.until = until, .more = 1, .ends = true};
		/* Sampling takes so long that the reader is ahead of the check. */
		const struct check_options options = {.method = CHECK_CONVENTIONAL, .step = 2e-3, .tolerance = 0.001,
						      .threads = 3, .spare = &heard.spare};
		const struct check_sink sink = {&heard, on_finding, on_progress, NULL};
		struct diag diag = {.handle = on_diag, .context = &heard};
		struct check_stats stats;

		rewind(in);
		ck_assert_int_eq(check_run(model.scene, &options, in, "a.nc", &sink, &diag, &stats, NULL),
				 CHECK_INCOMPLETE);
		ck_assert_msg(strstr(strbuf_text(&heard.text), "interrupted after line"), "%s",
			      strbuf_text(&heard.text));
		ck_assert(spare_threads_take(&heard.spare));
		ck_assert(!spare_threads_take(&heard.spare));
		strbuf_release(&heard.text);
	}
	model_release(&model);
	fclose(in);
}
END_TEST

/* The least number of spare threads during the check, of one at the start. */
static int least_spare(struct model *model, FILE *in, struct path_record *record)
{
	struct heard heard = {.more = 1, .least = 1};
	const struct check_options options = {.tolerance = 0.001, .threads = 1, .spare = &heard.spare,
					      .record = record};
	const struct check_sink sink = {&heard, on_finding, on_progress, NULL};
	struct diag diag = {.handle = on_diag, .context = &heard};
	struct check_stats stats;

	rewind(in);
	ck_assert_int_eq(check_run(model->scene, &options, in, "a.nc", &sink, &diag, &stats, NULL), CHECK_CLEAR);
	strbuf_release(&heard.text);
	return heard.least;
}

/* A check that records its path cannot use a second thread, so it leaves it for the check of another program. */
START_TEST(a_thread_of_no_use_is_left)
{
	struct path_record record;
	struct model model;
	FILE *in = program_with(-1, -1);

	place_bodies(&model);
	ck_assert_int_eq(least_spare(&model, in, NULL), 0);
	ck_assert(path_record_init(&record));
	path_record_start(&record);
	ck_assert_int_eq(least_spare(&model, in, &record), 1);
	path_record_release(&record);
	model_release(&model);
	fclose(in);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {none_is_lost, a_clear_check_stays_clear, findings_and_faults_stay_the_same,
				      an_interrupted_check_gives_its_threads_back,
				      a_thread_of_no_use_is_left};

	return RUN_TESTS("spare_threads", tests);
}
