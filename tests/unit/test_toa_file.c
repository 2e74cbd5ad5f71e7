/* test_toa_file.c - archived tool data: random edges, written in any order and form, are read back. */
#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/strbuf.h"
#include "machine/library/toa_file.h"
#include "random.h"
#include "suite.h"

enum { TOOLS = 5, EDGES = 3, VALUES = 6 };

static const int parameters[VALUES] = {1, 3, 6, 12, 15, 21};

struct data {
	bool given[TOOLS][EDGES][VALUES];
	double value[TOOLS][EDGES][VALUES];
	bool named[TOOLS];
};

static void add_blanks(struct strbuf *out, struct random *random)
{
	for (int i = random_below(random, 3); i > 0; i--)
		strbuf_addf(out, random_below(random, 2) ? " " : "\t");
}

/* One assignment; it may share its line with the next one. */
static void add_value(struct strbuf *out, struct random *random, const char *name, int tool, int edge, double value)
{
	static const char *const forms[] = {"%.3f", "%+.3f", "%.9e"};

	if (out->text[out->length - 1] == '\n' && random_below(random, 5) == 0)
		strbuf_addf(out, "N%d ", 10 * random_below(random, 1000));
	add_blanks(out, random);
	strbuf_addf(out, "$%s[", name);
	add_blanks(out, random);
	strbuf_addf(out, "%d,%d]", tool, edge);
	add_blanks(out, random);
	strbuf_addf(out, "=");
	add_blanks(out, random);
	strbuf_addf(out, forms[random_below(random, 3)], value);
	strbuf_addf(out, random_below(random, 4) ? "\r\n" : random_below(random, 2) ? " ; $TC_DP3[1,1]=7\n" : " ");
}

/* Variables of other kinds, which do not matter. */
static void add_noise(struct strbuf *out, struct random *random)
{
	static const char *const noise[] = {"$TC_MPP6[1,1]=7\n", "$TC_TP8[3]='H2'\n",	   "$TC_DP24[1,1]='B1'\n",
					    "CHANDATA(1)\n",	  "$P_UIFR[1]=CTRANS(X,1)\n", "\n",
					    "$TC_SCP13[1,1]=0\n", "$TC_DPCE[1,1]=5\n",	   "; $TC_DP3[1,1]=8\n"};

	if (random_below(random, 3) == 0)
		strbuf_addf(out, "\n%s", noise[random_below(random, COUNT(noise))]);
}

static void write_data(struct strbuf *out, struct random *random, struct data *data)
{
	*data = (struct data){.named = {false}};
	strbuf_addf(out, "%%_N_TO_TMA\nMETRIC\n");
	for (int i = 0; i < TOOLS; i++) {
		data->named[i] = random_below(random, 2);
		if (data->named[i])
			strbuf_addf(out, "\n$TC_TP2[%d]=\"TOOL; $%d\"\n", i, i);
	}
	for (int n = 0; n < 4 * TOOLS * EDGES * VALUES; n++) {
		const int i = random_below(random, TOOLS), k = random_below(random, EDGES);
		const int p = random_below(random, VALUES);
		struct strbuf name = {0};

		if (data->given[i][k][p])
			continue;
		data->given[i][k][p] = true;
		data->value[i][k][p] = (random_below(random, 200000) - 100000) / 1000.0;
		strbuf_addf(&name, "TC_DP%d", parameters[p]);
		add_value(out, random, strbuf_text(&name), i, k, data->value[i][k][p]);
		add_noise(out, random);
		strbuf_release(&name);
	}
	strbuf_addf(out, "\nM17\n");
}

static void check_edge(const struct toa_edge *edge, const struct data *data, bool given[TOOLS][EDGES])
{
	given[edge->tool][edge->number] = true;
	for (int p = 0; p < VALUES; p++) {
		ck_assert(data->given[edge->tool][edge->number][p] == (edge->lines[parameters[p]] > 0));
		ck_assert_double_eq_tol(edge->value[parameters[p]], data->value[edge->tool][edge->number][p], 1e-9);
	}
}

START_TEST(reads_back)
{
	for (long n = 0; n < random_cases(200); n++) {
		struct random random = random_case(1, n);
		struct diag silent = {.handle = NULL};
		struct toa_file file = {.unit = 0};
		struct arena arena = {0};
		struct strbuf text = {0};
		struct data data;
		bool given[TOOLS][EDGES] = {{false}};

		write_data(&text, &random, &data);
		ck_assert(toa_file_is(strbuf_text(&text)));
		ck_assert(toa_file_read(&file, &arena, strbuf_text(&text), "TO_INI", &silent));
		ck_assert(same_double(file.unit, 1));
		for (size_t i = 0; i < file.edge_count; i++)
			check_edge(&file.edges[i], &data, given);
		for (int i = 0; i < TOOLS; i++) {
			const struct toa_tool *tool = toa_file_tool(&file, i);

			ck_assert(data.named[i] == (tool != NULL));
			ck_assert(!tool || (!strncmp(tool->name, "TOOL; $", 7) && tool->name[7] == '0' + i));
			for (int k = 0; k < EDGES; k++)
				for (int p = 0; p < VALUES; p++)
					ck_assert(given[i][k] || !data.given[i][k][p]);
		}
		toa_file_release(&file);
		arena_release(&arena);
		strbuf_release(&text);
	}
}
END_TEST

START_TEST(has_a_limit)
{
	for (int more = 0; more < 2; more++) {
		struct toa_file file = {0};
		struct arena arena = {0};
		struct diag diag = {0};
		struct strbuf text = {0};

		for (int i = 0; i < TOA_MOST + more; i++)
			strbuf_addf(&text, "$TC_DP3[%d,1]=5\n", i + 1);
		ck_assert(toa_file_read(&file, &arena, strbuf_text(&text), "t", &diag) == !more);
		ck_assert((int)diag.errors == more);
		toa_file_release(&file);
		arena_release(&arena);
		strbuf_release(&text);
	}
}
END_TEST

/* Of the number 120.25 in the last line any part may be left. */
START_TEST(is_cut_off)
{
	static const char text[] = "METRIC\n$TC_DP3[1,1]=120.25";

	for (size_t left = strlen(text) - 6; left <= strlen(text) + 1; left++) {
		struct toa_file file = {0};
		struct arena arena = {0};
		struct diag diag = {0};
		struct strbuf part = {0};

		strbuf_add(&part, text, left <= strlen(text) ? left : strlen(text));
		strbuf_addf(&part, "%s", left <= strlen(text) ? "" : "\n");
		ck_assert(toa_file_read(&file, &arena, strbuf_text(&part), "t", &diag) == (left > strlen(text)));
		toa_file_release(&file);
		arena_release(&arena);
		strbuf_release(&part);
	}
}
END_TEST

START_TEST(is_no_archive)
{
	ck_assert(!toa_file_is("G0 X1\n; $TC_DP3[1,1]=5\n"));
	ck_assert(!toa_file_is("$TC_DPV[1,1]=5\n$P_UIFR[1]=CTRANS()\n"));
	ck_assert(!toa_file_is("$TC_DP"));
	ck_assert(!toa_file_is(""));
	ck_assert(toa_file_is("\xef\xbb\xbf\tN10  $tc_dp3[1,1]=5"));
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {reads_back, has_a_limit, is_cut_off, is_no_archive};

	return RUN_TESTS("toa_file", tests);
}
