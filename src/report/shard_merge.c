#include "report/shard_merge.h"

#include <jansson.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/json.h"
#include "report/ndjson_run.h"
#include "report/report.h"
#include "report/shard_match.h"

struct merge {
	struct ndjson_run *runs;	/* sorted by their part; owned */
	size_t count;
	bool of_blocks;	/* the shards are parts of the blocks of one program */
	json_t *lines;	/* an array: the joined findings and programs */
	json_int_t end;	/* of blocks: the block whose finding ends a check of the whole program */
	struct diag *diag;
};

static json_int_t integer(const json_t *object, const char *key)
{
	return json_integer_value(json_object_get(object, key));
}

static json_int_t part_of(const struct ndjson_run *run)
{
	const json_t *shard = json_object_get(run->header, "shard");

	return json_is_object(shard) ? integer(shard, "part") : 1;
}

static int compare_parts(const void *a, const void *b)
{
	json_int_t x = part_of(a), y = part_of(b);

	return (x > y) - (x < y);
}

static bool load_runs(struct merge *merge, char *const *paths, size_t count)
{
	merge->runs = mem_zalloc(count + 1, sizeof(*merge->runs));
	for (size_t i = 0; i < count; i++) {
		merge->count++;
		if (!ndjson_run_load(&merge->runs[i], paths[i], merge->diag))
			return false;
	}
	qsort(merge->runs, merge->count, sizeof(*merge->runs), compare_parts);
	return true;
}

/* Programs were distributed one by one: takes the i-th program of each shard, with its findings, for each i. */
static void join_programs(struct merge *merge)
{
	size_t *next = mem_zalloc(merge->count, sizeof(*next));

	for (bool more = true; more;) {
		more = false;
		for (size_t i = 0; i < merge->count; i++) {
			const struct ndjson_run *run = &merge->runs[i];
			bool ended = next[i] == run->count;

			while (!ended) {
				json_t *line = run->lines[next[i]++];

				json_push(merge->lines, json_incref(line));
				ended = ndjson_run_is_program(line);
				more = true;
			}
		}
	}
	free(next);
}

static json_t *program_of(const struct ndjson_run *run)
{
	return run->lines[run->count - 1];
}

/* The next finding of a run that was not taken, *next or later; NULL: there is none. */
static json_t *next_finding(const struct ndjson_run *run, size_t *next)
{
	while (*next < run->count && ndjson_run_is_program(run->lines[*next]))
		(*next)++;
	return *next < run->count ? run->lines[*next] : NULL;
}

/* At the same time, the end of a block comes before the beginning of the next block, which is in another share. */
static bool comes_before(const json_t *a, const json_t *b)
{
	const double time_a = json_number_value(json_object_get(a, "time"));
	const double time_b = json_number_value(json_object_get(b, "time"));

	if (time_a < time_b || time_a > time_b)
		return time_a < time_b;
	return json_number_value(json_object_get(a, "fraction")) > json_number_value(json_object_get(b, "fraction"));
}

/* Does the error come after the finding that ends a check of the whole program? */
static bool is_after_end(const struct merge *merge, const json_t *error)
{
	return integer(error, "block") > merge->end;
}

/*
 * Adds the findings of all shards in the order of time. Those of one shard keep their order: at the same time no number
 * in them tells which one is the first. Without --all a run ends at the first finding that fails it.
 */
static void join_findings(struct merge *merge)
{
	const bool all = json_is_true(json_object_get(merge->runs[0].header, "all"));
	size_t *next = mem_zalloc(merge->count, sizeof(*next));
	json_int_t end_of = 0;
	json_t *first;

	do {
		size_t of = 0;

		first = NULL;
		for (size_t i = 0; i < merge->count; i++) {
			json_t *line = next_finding(&merge->runs[i], &next[i]);

			if (!line || (first && !comes_before(line, first)))
				continue;
			first = line;
			of = i;
		}
		if (first) {
			json_push(merge->lines, json_incref(first));
			next[of]++;
			end_of = integer(program_of(&merge->runs[of]), "blocks");
		}
	} while (first && (all || json_object_get(first, "accepted")));
	if (first)
		merge->end = end_of;
	free(next);
}

/* Appends the elements of `more` that are new; cautions about a shard are left out. */
static void add_distinct(json_t *array, const json_t *more)
{
	for (size_t i = 0; i < json_array_size(more); i++) {
		json_t *item = json_array_get(more, i);
		const char *text = json_string_value(item);
		bool known = text && !strncmp(text, "shard ", 6);

		for (size_t k = 0; k < json_array_size(array) && !known; k++)
			known = json_equal(json_array_get(array, k), item);
		if (!known)
			json_push(array, json_incref(item));
	}
}

/*
 * Was the run incomplete only because of what comes after the end of a check of the whole program? Its errors are in
 * the order of their blocks. A run that names none was broken off.
 */
static bool is_excused(const struct merge *merge, const struct ndjson_run *run)
{
	const char *verdict = merge->of_blocks ? ndjson_run_text(program_of(run), "verdict") : NULL;
	const json_t *errors = merge->of_blocks ? json_object_get(program_of(run), "errors") : NULL;

	return verdict && !strcmp(verdict, "incomplete") && json_array_size(errors) &&
	       is_after_end(merge, json_array_get(errors, 0));
}

/* Is the same message in the array, of whatever block? */
static bool is_known(const json_t *array, const json_t *error)
{
	json_t *message = json_copy((json_t *)error);
	bool known = false;

	for (size_t i = 0; i < json_array_size(array) && !known; i++) {
		json_t *other = json_copy(json_array_get(array, i));

		json_object_del(message, "block");
		json_object_del(other, "block");
		known = json_equal(message, other);
		json_decref(other);
	}
	json_decref(message);
	return known;
}

/* The first errors of all runs in the order of their blocks: those that a check of the whole program names. */
static json_t *joined_errors(const struct merge *merge)
{
	size_t *next = mem_zalloc(merge->count, sizeof(*next));
	json_t *errors = json_array(), *first;

	do {
		size_t of = 0;

		first = NULL;
		for (size_t i = 0; i < merge->count; i++) {
			json_t *error = json_array_get(json_object_get(program_of(&merge->runs[i]), "errors"), next[i]);

			if (!error || (first && integer(error, "block") >= integer(first, "block")))
				continue;
			first = error;
			of = i;
		}
		if (!first)
			break;
		next[of]++;
		if (!is_after_end(merge, first) && !is_known(errors, first))
			json_push(errors, json_incref(first));
	} while (json_array_size(errors) < REPORT_ERRORS_MAX);
	free(next);
	return errors;
}

/* The verdict about the program as a whole. */
static const char *joined_verdict(const struct merge *merge)
{
	static const char *const order[] = {"incomplete", "found", "accepted"};
	const char *method = ndjson_run_text(merge->runs[0].header, "method");

	for (size_t k = 0; k < sizeof(order) / sizeof(order[0]); k++) {
		for (size_t i = 0; i < merge->count; i++) {
			const char *verdict = ndjson_run_text(program_of(&merge->runs[i]), "verdict");

			if (verdict && !strcmp(verdict, order[k]) && !is_excused(merge, &merge->runs[i]))
				return order[k];
		}
	}
	return method && !strcmp(method, "certified") ? "clear" : "passed";
}

/* Each shard checked its own blocks of one program: adds the program as a whole, after its findings. */
static bool join_blocks(struct merge *merge)
{
	json_t *program = json_copy(program_of(&merge->runs[0])), *cautions = json_array();
	json_int_t blocks = 0, checked = 0;
	bool all = json_is_true(json_object_get(merge->runs[0].header, "all")), stopped;
	const char *verdict;

	join_findings(merge);
	verdict = joined_verdict(merge);
	stopped = !strcmp(verdict, "incomplete") || (!strcmp(verdict, "found") && !all);

	for (size_t i = 0; i < merge->count; i++) {
		const json_t *part = program_of(&merge->runs[i]);

		blocks = integer(part, "blocks") > blocks ? integer(part, "blocks") : blocks;
		checked += integer(part, "checked");
		add_distinct(cautions, json_object_get(part, "cautions"));
	}
	json_put(program, "verdict", json_string(verdict));
	json_put(program, "blocks", json_integer(blocks));
	json_put(program, "checked", json_integer(checked));
	json_put(program, "findings", json_integer((json_int_t)json_array_size(merge->lines)));
	json_put(program, "cautions", cautions);
	json_put(program, "errors", joined_errors(merge));
	json_push(merge->lines, program);
	if (stopped || checked == blocks)
		return true;
	diag_error(merge->diag, (struct srcloc){0}, "the shards checked %lld of %lld blocks", (long long)checked,
		   (long long)blocks);
	return false;
}

static void add_header(struct strbuf *out, const struct merge *merge)
{
	json_t *header = json_copy(merge->runs[0].header);
	json_int_t programs = 0;

	for (size_t i = 0; i < merge->count; i++)
		programs += integer(merge->runs[i].header, "programs");
	json_put(header, "programs", json_integer(merge->of_blocks ? 1 : programs));
	json_put(header, "shard", json_null());
	json_put(header, "program_list", json_null());
	json_put(header, "files", shard_match_files(merge->runs, merge->count, false));
	json_add_line(out, header);
}

/*
 * The programs that passed: `clear` of them have such a verdict, but with --fail-on=warning their warnings may fail the
 * run, which only the summaries say.
 */
static json_int_t count_passed(const struct merge *merge, json_int_t clear, json_int_t status)
{
	json_int_t passed = 0;

	if (merge->of_blocks)
		return status ? 0 : clear;
	for (size_t i = 0; i < merge->count; i++)
		passed += integer(merge->runs[i].summary, "passed");
	return passed;
}

/* Appends the lines and the summary, and returns the exit status. */
static int add_rest(struct strbuf *out, const struct merge *merge)
{
	json_int_t programs = 0, clear = 0, incomplete = 0, blocks = 0, findings = 0, status = 0;
	json_t *summary = json_object();

	for (size_t i = 0; i < json_array_size(merge->lines); i++) {
		json_t *line = json_array_get(merge->lines, i);
		const char *verdict = ndjson_run_is_program(line) ? ndjson_run_text(line, "verdict") : NULL;

		json_add_line(out, json_incref(line));
		if (!verdict)
			continue;
		programs++;
		clear += !strcmp(verdict, "clear") || !strcmp(verdict, "passed");
		incomplete += !strcmp(verdict, "incomplete");
		blocks += integer(line, "blocks");
		findings += integer(line, "findings");
	}
	for (size_t i = 0; i < merge->count; i++) {
		json_int_t one = integer(merge->runs[i].summary, "status");

		/* Of an excused run only its findings could count, and they would come after the end, too. */
		if (!is_excused(merge, &merge->runs[i]))
			status = one > status ? one : status;
	}
	json_put(summary, "kind", json_string("summary"));
	json_put(summary, "status", json_integer(status));
	json_put(summary, "programs", json_integer(programs));
	json_put(summary, "passed", json_integer(count_passed(merge, clear, status)));
	json_put(summary, "incomplete", json_integer(incomplete));
	json_put(summary, "blocks", json_integer(blocks));
	json_put(summary, "findings", json_integer(findings));
	json_put(summary, "files", shard_match_files(merge->runs, merge->count, true));
	json_add_line(out, summary);
	return (int)status;
}

bool shard_merge(struct strbuf *out, int *status, char *const *paths, size_t count, struct diag *diag)
{
	struct merge merge = {.diag = diag, .lines = json_array(), .end = INT64_MAX};
	bool good = load_runs(&merge, paths, count) && shard_match(merge.runs, merge.count, &merge.of_blocks, diag);

	if (good && merge.of_blocks)
		good = join_blocks(&merge);
	else if (good)
		join_programs(&merge);
	if (good) {
		add_header(out, &merge);
		*status = add_rest(out, &merge);
	}
	for (size_t i = 0; i < merge.count; i++)
		ndjson_run_release(&merge.runs[i]);
	free(merge.runs);
	json_decref(merge.lines);
	return good;
}
