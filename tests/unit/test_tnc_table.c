/* test_tnc_table.c - tables with columns of fixed widths: random ones are read back, also with rows that have slipped. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/strbuf.h"
#include "machine/library/tnc_table.h"
#include "random.h"
#include "suite.h"

enum { COLUMNS = 5, ROWS = 6, WIDTH_MAX = 20 };

static const char *const names[COLUMNS] = {"T", "NAME", "L", "R", "DL"};
static const char *const needed[] = {"T", "L", "R", NULL};

/* Letters in Latin-1 and UTF-8: both are one place wide. */
static const char *const latin[] = {"D8", "FR\xc4S", "\xfc", "BOHR ER", ""};
static const char *const utf8[] = {"D8", "FR\xc3\x84S", "\xc3\xbc", "BOHR ER", ""};

struct table {
	struct strbuf text;
	int name[ROWS];
	double number[ROWS][COLUMNS];
};

static void pad(struct strbuf *out, const char *text, int width)
{
	strbuf_addf(out, "%s", text);
	for (int i = (int)strlen(text); i < width; i++)
		strbuf_addf(out, " ");
}

/* `as_utf8`: letters have several bytes, which the widths do not count. */
static void add_name(struct strbuf *out, int name, int width, bool as_utf8)
{
	const char *text = as_utf8 ? utf8[name] : latin[name];

	pad(out, text, width + (int)(strlen(text) - strlen(latin[name])));
}

static void make_row(struct table *table, struct random *random, const int widths[COLUMNS], int row, bool as_utf8)
{
	char text[WIDTH_MAX];

	snprintf(text, sizeof(text), "%d", row);
	pad(&table->text, text, widths[0]);
	table->number[row][0] = row;
	table->name[row] = random_below(random, COUNT(latin));
	add_name(&table->text, table->name[row], widths[1], as_utf8);
	for (int i = 2; i < COLUMNS; i++) {
		const int value = random_below(random, 200000) - 100000;
		const double number = value % 3 ? value / 1000.0 : value % 100;

		/* Some cells are empty, some numbers are short. */
		table->number[row][i] = value % 5 ? number : NAN;
		snprintf(text, sizeof(text), value % 5 == 0 ? "" : value % 3 ? "%+.3f" : "%+.0f", number);
		pad(&table->text, text, widths[i]);
	}
}

/* With `slip`, blanks are inserted into (or, if negative, removed from) the last row, before its second number. */
static void make_table(struct table *table, struct random *random, int slip, bool as_utf8)
{
	int widths[COLUMNS];
	size_t row = 0;

	*table = (struct table){.text = {0}};
	strbuf_addf(&table->text, "BEGIN TOOL.T MM\n");
	for (int i = 0; i < COLUMNS; i++) {
		widths[i] = 10 + random_below(random, WIDTH_MAX - 10);
		pad(&table->text, names[i], widths[i]);
	}
	for (int i = 0; i < ROWS; i++) {
		strbuf_addf(&table->text, "\n");
		row = table->text.length;
		make_row(table, random, widths, i, as_utf8);
	}
	if (slip) {
		struct strbuf slipped = {0};
		const size_t at = row + (size_t)widths[0] - (slip < 0 ? (size_t)-slip : 0);

		strbuf_add(&slipped, table->text.text, at);
		for (int i = 0; i < slip; i++)
			strbuf_addf(&slipped, " ");
		strbuf_addf(&slipped, "%s", table->text.text + row + widths[0]);
		strbuf_release(&table->text);
		table->text = slipped;
	}
	strbuf_addf(&table->text, "\n[END]\n");
}

struct row {
	struct strbuf name;
	double number[COLUMNS];
};

static bool read_row(const struct tnc_table *table, struct row *row)
{
	for (int i = 0; i < COLUMNS; i++)
		if (i == 1 ? !tnc_table_text(table, names[i], &row->name)
			   : !tnc_table_number(table, names[i], &row->number[i]))
			return false;
	return true;
}

/* A row that has slipped is refused, or nothing of it is lost. */
static void check_row(const struct tnc_table *read, const struct table *table, int row, bool slipped)
{
	struct row found = {.name = {0}};
	const bool good = read_row(read, &found);

	ck_assert(good || slipped);
	if (good)
		ck_assert_str_eq(strbuf_text(&found.name), utf8[table->name[row]]);
	for (int i = 0; good && i < COLUMNS; i += i ? 1 : 2) {
		const double truth = table->number[row][i];

		if (isnan(truth))
			ck_assert(isnan(found.number[i]));
		else
			ck_assert_double_eq_tol(found.number[i], truth, 1e-9);
	}
	strbuf_release(&found.name);
}

static void check_table(const struct table *table, int slip)
{
	struct diag silent = {.handle = NULL};
	static struct tnc_table read;

	ck_assert(tnc_table_is(table->text.text, needed, ".T"));
	ck_assert(tnc_table_begin(&read, table->text.text, "TOOL.T", needed, &silent));
	ck_assert_double_eq(read.unit, 1);
	for (int i = 0; i < ROWS; i++) {
		ck_assert_int_eq(tnc_table_next(&read), 1);
		ck_assert_int_eq(read.at.line, 3 + i);
		check_row(&read, table, i, slip && i == ROWS - 1);
	}
	ck_assert_int_eq(tnc_table_next(&read), 0);
}

START_TEST(reads_back)
{
	for (long i = 0; i < random_cases(500); i++) {
		struct random random = random_case(1, i);
		const int slip = i % 3 ? random_below(&random, 25) - 8 : 0;
		struct table table;

		make_table(&table, &random, slip, i % 2);
		check_table(&table, slip);
		strbuf_release(&table.text);
	}
}
END_TEST

START_TEST(finds_the_end_of_long_names)
{
	static const char text[] = "BEGIN TOOL.T\nT   NAME  L     R\n5   ABCDEF+1.5  -2\n6   ABCDEF1.5   -2\n[END]\n";
	struct diag silent = {.handle = NULL};
	static struct tnc_table table;
	struct strbuf name = {0};
	double value;

	ck_assert(tnc_table_begin(&table, text, "TOOL.T", needed, &silent));
	ck_assert_double_eq(table.unit, 0);
	ck_assert_int_eq(tnc_table_next(&table), 1);
	ck_assert(tnc_table_text(&table, "NAME", &name) && tnc_table_number(&table, "L", &value));
	ck_assert_str_eq(strbuf_text(&name), "ABCDEF");
	ck_assert_double_eq(value, 1.5);
	ck_assert(tnc_table_number(&table, "R", &value));
	ck_assert_double_eq(value, -2);
	/* There is no such column. */
	ck_assert(tnc_table_number(&table, "DL", &value) && isnan(value));
	/* A name of seven letters, or one of six and a number without a sign? */
	ck_assert_int_eq(tnc_table_next(&table), 1);
	ck_assert(!tnc_table_text(&table, "NAME", &name));
	ck_assert(!tnc_table_number(&table, "L", &value));
	strbuf_release(&name);
}
END_TEST

START_TEST(is_no_table)
{
	ck_assert(!tnc_table_is("0 BEGIN PGM A MM\n1 T L R\n", needed, ".T"));
	ck_assert(!tnc_table_is("BEGIN PGM A.T MM\nT L R\n", needed, ".T"));
	ck_assert(!tnc_table_is("BEGIN PRESET.PR MM\nNO X Y Z\n[END]\n", needed, ".T"));
	ck_assert(!tnc_table_is("T L R\n1 2 3\n", needed, ".T"));
	ck_assert(!tnc_table_is("", needed, ".T"));
	ck_assert(tnc_table_is("\nBEGIN MILLS MM\n#STRUCTBEGIN\nany\n#STRUCTEND\nNO T L R\n", needed, ".T"));
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {reads_back, finds_the_end_of_long_names, is_no_table};

	return RUN_TESTS("tnc_table", tests);
}
