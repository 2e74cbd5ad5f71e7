/* test_gcode_text.c - bytes to lines to words: numbers, line ends, faulty files, long programs on a pipe. */
#define _GNU_SOURCE /* fopencookie: a file whose reading fails */
#include "gcode_case.h"

#include <errno.h>
#include <pthread.h>
#include <unistd.h>

#include "gcode/text/number.h"
#include "gcode/text/reader.h"
#include "random.h"

static double read_number(const char *text, size_t *length)
{
	double value = NAN;
	bool point;

	*length = 0;
	require(number_read(text, length, &value, &point) == NUMBER_OK, "%s", text);
	require(point == (strchr(text, '.') != NULL), "%s", text);
	return value;
}

/* The bits of strtod, on decimals of every length. */
START_TEST(numbers_are_correctly_rounded)
{
	struct random random = random_case(1, 0);

	for (long i = 0; i < random_cases(400000); i++) {
		char text[64];
		size_t length = 0, used;
		int whole = (int)(random_bits(&random) % 12), fraction = (int)(random_bits(&random) % 28);
		double expected, value;

		if (random_bits(&random) % 2)
			text[length++] = '-';
		for (int k = 0; k < whole; k++)
			text[length++] = (char)('0' + random_bits(&random) % 10);
		if (fraction || random_bits(&random) % 2 || whole == 0)
			text[length++] = '.';
		for (int k = 0; k < fraction + (whole == 0); k++)
			text[length++] = (char)('0' + random_bits(&random) % 10);
		text[length] = '\0';
		expected = strtod(text, NULL);
		value = read_number(text, &used);
		require(!memcmp(&expected, &value, sizeof(value)) && used == length, "%s", text);
		if (strchr(text, '.') && random_bits(&random) % 2)
			*strchr(text, '.') = ',';
		used = 0;
		require(number_read_with_comma(text, &used, &value) == NUMBER_OK &&
				!memcmp(&expected, &value, sizeof(value)) && used == length,
			"%s", text);
	}
}
END_TEST

START_TEST(numbers_beyond_the_mantissa)
{
	size_t used;

	/* 2^53 + 1 lies between two doubles and rounds to even; so do the halfway cases with a digit far behind. */
	ck_assert(read_number("9007199254740993", &used) == 9007199254740992.0);
	ck_assert(read_number("9007199254740993.00000000000000000000000000001", &used) == 9007199254740994.0);
	ck_assert(read_number("0000000000000000000000000000001.5", &used) == 1.5);
	ck_assert(read_number("0.000000000000000000000000000000000000000001", &used) == 1e-42);
	ck_assert(signbit(read_number("-0.0", &used)));
}
END_TEST

START_TEST(number_forms)
{
	char digits[NUMBER_LENGTH_MAX + 3];
	size_t used;
	double value;
	bool point;

	ck_assert(read_number(" + 1 2 . 5 0 X", &used) == 12.5);
	ck_assert_uint_eq(used, 13);
	ck_assert(read_number("5.", &used) == 5);
	ck_assert(read_number("1.5.5", &used) == 1.5);
	ck_assert_uint_eq(used, 3);
	ck_assert_int_eq(number_read("-.", &(size_t){0}, &value, &point), NUMBER_MISSING);
	ck_assert_int_eq(number_read("1e5", &(size_t){1}, &value, &point), NUMBER_MISSING);
	memset(digits, '9', sizeof(digits));
	digits[NUMBER_LENGTH_MAX] = '\0';
	ck_assert(read_number(digits, &used) == 1e255);
	digits[NUMBER_LENGTH_MAX] = '9';
	digits[NUMBER_LENGTH_MAX + 1] = '\0';
	ck_assert_int_eq(number_read(digits, &(size_t){0}, &value, &point), NUMBER_TOO_LONG);
	ck_assert_int_eq(number_read_with_comma(digits, &(size_t){0}, &value), NUMBER_TOO_LONG);
	used = 0;
	ck_assert_int_eq(number_read_with_comma("+7,25,5", &used, &value), NUMBER_OK);
	ck_assert(value == 7.25 && used == 5);
	ck_assert_int_eq(number_read_with_comma("-,", &(size_t){0}, &value), NUMBER_MISSING);
	ck_assert_int_eq(number_read_with_comma("- 5", &(size_t){0}, &value), NUMBER_MISSING);
}
END_TEST

/* For all bytes: a blank before them, which prevents the fast path of the reader, changes nothing. */
START_TEST(quick_and_slow_numbers_agree)
{
	static const char bytes[] = "0123456789012345678901234567890123456789...+-  \tX";
	struct random random = random_case(2, 0);

	for (long i = 0; i < random_cases(600000); i++) {
		size_t length = 1 + random_bits(&random) % 26, quick = 0, slow = 0;
		double quick_value = 0, slow_value = 0;
		bool quick_point = false, slow_point = false;
		char text[32] = " ";

		for (size_t k = 1; k <= length; k++)
			text[k] = bytes[random_bits(&random) % (sizeof(bytes) - 1)];
		require(number_read(text + 1, &quick, &quick_value, &quick_point) ==
			    number_read(text, &slow, &slow_value, &slow_point),
			"%s", text);
		require(quick + (quick > 0) == slow && quick_point == slow_point &&
			    !memcmp(&quick_value, &slow_value, sizeof(quick_value)),
			"%s", text);
	}
}
END_TEST

START_TEST(line_ends)
{
	const char *moves = "rapid 1 0 0 0 0\nrapid 1 2 0 0 0\n";

	expect_moves("G0 X1\nY2\nM2\n", moves);
	expect_moves("G0 X1\r\nY2\r\nM2", moves);
	expect_moves("G0 X1\rY2\rM2\r", moves);
	expect_moves("\xef\xbb\xbfG0 X1\nY2\n", moves);
	expect_moves("\xef\xbb\xbf%\nG0 X1\nY2\n%", moves);
}
END_TEST

static void expect_message(const char *bytes, size_t length, const char *message)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(!case_run_bytes(&c, bytes, length));
	ck_assert_str_eq(strbuf_text(&c.messages), message);
	case_release(&c);
}

START_TEST(faulty_files)
{
	expect_message("G0 X1\nX2\0\nX3\n", 13,
		       "p.nc:2:3: error: a NUL byte: the file was not written completely, or is no NC program; write or "
		       "copy it again\n");
	expect_message("\xff\xfeG\0", 4,
		       "p.nc:1: error: this file is in UTF-16: save it as UTF-8 (a text editor does)\n");
	expect_message("\0G\0001\0\n", 6,
		       "p.nc:1: error: this file is in UTF-16: save it as UTF-8 (a text editor does)\n");
	expect_message("\x1f\x8b\x08\0\n", 5, "p.nc:1: error: this file is compressed by gzip: unpack it first\n");
	expect_message("G0 X1\nX2\rY3\n", 12,
		       "p.nc:2:3: error: mixed line ends: some are a carriage return alone, some have a line feed; save "
		       "the file with one kind of line end\n");
	expect_message("G0 X1\rX2\nY3\n", 12,
		       "p.nc:2:3: error: mixed line ends: some are a carriage return alone, some have a line feed; save "
		       "the file with one kind of line end\n");
}
END_TEST

START_TEST(long_lines)
{
	struct strbuf program = {0};
	struct gcode_case c;

	strbuf_addf(&program, "G0 X1\n(");
	while (program.length < 6 + LINE_LENGTH_MAX - 1)
		strbuf_add(&program, "x", 1);
	strbuf_addf(&program, ")\nX2\n");
	expect_moves(program.text, "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	program.text[program.length - 5] = 'x';
	strbuf_addf(&program, ")\nX3\n");
	program.text[program.length - 9] = ')';
	program.text[program.length - 8] = ' ';
	case_init(&c);
	ck_assert(!case_run(&c, program.text));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2: error: a line of more than 65536 bytes is not an NC block\n");
	case_release(&c);
	/* Without an end at all. */
	strbuf_clear(&program);
	for (int i = 0; i < 100000; i++)
		strbuf_add(&program, "G0 X1 ", 6);
	expect_message(program.text, program.length,
		       "p.nc:1: error: a line of more than 65536 bytes is not an NC block\n");
	strbuf_release(&program);
}
END_TEST

static ssize_t read_and_fail(void *cookie, char *buffer, size_t size)
{
	int *calls = cookie;

	(void)size;
	if ((*calls)++) {
		errno = EIO;
		return -1;
	}
	memcpy(buffer, "G0 X1\n", 6);
	return 6;
}

START_TEST(read_error)
{
	cookie_io_functions_t functions = {.read = read_and_fail};
	int calls = 0;
	FILE *in = fopencookie(&calls, "r", functions);
	struct gcode_case c;

	case_init(&c);
	ck_assert(!case_run_stream(&c, in));
	ck_assert_str_eq(strbuf_text(&c.messages), "p.nc: error: cannot read: Input/output error\n");
	fclose(in);
	case_release(&c);
}
END_TEST

#define STREAM_BLOCKS 200000

static void *write_program(void *stream)
{
	for (int i = 1; i <= STREAM_BLOCKS; i++)
		fprintf(stream, "N%d G1 X%d.%03d Y-%d F1000 (block %d)\r\n", i, i % 500, i % 1000, i % 77, i);
	fprintf(stream, "M30\r\nthis is not read\r\n");
	fclose(stream);
	return NULL;
}

static bool check_stream_event(void *context, const struct canon_event *event)
{
	const struct canon_move *move = event->of.move;
	const struct canon_block *block = event->of.block;
	int *count = context, i = *count + 1;

	if (event->kind == CANON_BLOCK)
		return block->text[0] == 'N' ? block->moves == 1 : block->moves == 0;
	*count = i;
	require(move->line == i, "line %ld", move->line);
	require(fabs(move->end.v[SLOT_X] - (i % 500 + (i % 1000) / 1000.0)) < 1e-12, "line %d", i);
	require(move->end.v[SLOT_Y] == -(i % 77), "line %d", i);
	return true;
}

/* 8 MB through a pipe: every line whole, wherever the buffer ends. */
START_TEST(streaming)
{
	struct gcode_config config = {.dialect = &dialect_linuxcnc, .has_axis = {true, true, true}};
	int count = 0, ends[2];
	struct canon_sink sink = {.context = &count, .event = check_stream_event};
	struct kinematics none = {0};
	struct diag diag = {0};
	struct interp *interp;
	pthread_t writer;
	FILE *in;

	ck_assert_int_eq(pipe(ends), 0);
	in = fdopen(ends[0], "r");
	ck_assert_int_eq(pthread_create(&writer, NULL, write_program, fdopen(ends[1], "w")), 0);
	interp = interp_new(&config, &none, &sink, &diag);
	ck_assert(interp_run(interp, in, "pipe"));
	ck_assert_int_eq(interp_lines(interp), STREAM_BLOCKS + 1);
	interp_free(interp);
	pthread_join(writer, NULL);
	fclose(in);
	ck_assert_int_eq(count, STREAM_BLOCKS);
	ck_assert_uint_eq(diag.errors + diag.warnings, 0);
}
END_TEST

static const char sample[] =
    "%\nG21 G90 G17\nG10 L2 P2 X5 A10\nG43 G0 X1 Y2. Z-3 A45 F100\nG1 X2\nG2 X4 Y2 I1 P2\nG18 G3 X0 Z1 R50\n"
    "G92 X1\nG53 G0 Z0\nG28 Z5\nT1 M6\nG55 G91 G64 P.1\nG4 P1\nG93 G1 X1 F2\nG20 C-90\nG43.4 H0 X1\nG49\nM30\n%\n";

/* Any bytes: an error or a result, never a crash (the sanitizers watch), and never an error without a message. */
START_TEST(noise)
{
	static const char alphabet[] = "GGGGMMXYZACFIJKRPLTSHN0123456789..--  (\n\n\n);%/#[]\r\t*@";

	for (long i = 0; i < random_cases(40000); i++) {
		struct random random = random_case(2, i);
		char bytes[sizeof(sample) - 1];
		struct gcode_case c;
		bool good;

		memcpy(bytes, sample, sizeof(bytes));
		for (uint64_t k = random_bits(&random) % (i % 10 ? 5 : 500); k > 0; k--) {
			char other = random_bits(&random) % 50 ? alphabet[random_bits(&random) % (sizeof(alphabet) - 1)]
							       : (char)random_bits(&random);

			bytes[random_bits(&random) % sizeof(bytes)] = other;
		}
		case_init(&c);
		c.config.dialect = dialect_of_row((int)(i % 3));
		c.config.wrap[SLOT_A] = (enum wrap)(i % 3);
		c.config.read.last_duplicate_wins = i % 2;
		good = case_run_bytes(&c, bytes, sizeof(bytes));
		require(good == (c.diag.errors == 0), "case %ld", i);
		case_release(&c);
	}
}
END_TEST

static void add_random_words(struct strbuf *line, struct random *random)
{
	static const char *const numbers[] = {"1", "2.5", "-3.25", "+4", "0", "-0", "3", "03", "1.1", "", ".", "1 2", " 5",
					      "-.5", "9007199254740993", "7 ", "2\t"};
	static const char letters[] = "XXXYYYZZZAABCGGGGUVWIJKRFFPQNxgM";

	for (uint64_t k = random_bits(random) % 7; k > 0; k--) {
		const char letter = letters[random_bits(random) % (sizeof(letters) - 1)];
		const size_t number = random_bits(random) % (sizeof(numbers) / sizeof(*numbers));

		/* Most lines are to be read without a fault. */
		strbuf_addf(line, "%c%s%s", letter, numbers[random_bits(random) % 8 ? number % 9 : number],
			    random_bits(random) % 2 ? " " : "");
	}
}

/* The moves and messages of a program whose last line is this one. */
static void run_last_line(struct gcode_case *c, int dialect, const char *line)
{
	struct strbuf program = {0};

	case_init(c);
	c->show_feed = true;
	c->config.dialect = dialect_of_row(dialect);
	strbuf_addf(&program, "G21 G90 G17 G94 G1 X0 Y0 Z0 F100\n%s\n", line);
	case_run(c, program.text);
	strbuf_release(&program);
}

/* For all words: a comment after them, which prevents the fast path of the reader, changes nothing. */
START_TEST(plain_and_general_blocks_agree)
{
	struct random random = random_case(3, 0);
	const long cases = random_cases(60000);
	long good = 0;

	for (long i = 0; i < cases; i++) {
		struct gcode_case quick, slow;
		struct strbuf line = {0};

		if (random_bits(&random) % 3 == 0)
			strbuf_addf(&line, "N%ld ", i);
		if (random_bits(&random) % 2)
			strbuf_addf(&line, "G%d ", (int)(random_bits(&random) % 4));
		add_random_words(&line, &random);
		run_last_line(&quick, (int)(i % 3), strbuf_text(&line));
		strbuf_addf(&line, "()");
		run_last_line(&slow, (int)(i % 3), strbuf_text(&line));
		require(!strcmp(strbuf_text(&quick.moves), strbuf_text(&slow.moves)), "%s", line.text);
		/* Below its first line, the message shows the text. */
		require(!strncmp(strbuf_text(&quick.messages), strbuf_text(&slow.messages),
				 strcspn(strbuf_text(&quick.messages), "\n")),
			"%s", line.text);
		require(quick.diag.errors == slow.diag.errors && quick.diag.warnings == slow.diag.warnings, "%s",
			line.text);
		good += quick.diag.errors == 0;
		case_release(&quick);
		case_release(&slow);
		strbuf_release(&line);
	}
	ck_assert_int_ge(10 * good, cases);
}
END_TEST

/* The line ends of a long file with one CR or NUL where it may not be: every line before it is read, and it is seen. */
START_TEST(odd_bytes_far_behind)
{
	for (int i = 0; i < 300; i++) {
		struct random random = random_case(4, i);
		const char odd = i % 3 ? '\r' : '\0';
		struct strbuf bytes = {0};
		struct reader reader;
		size_t lines = 0, faulty, column;
		enum reader_status status;
		const char *text;
		FILE *in;

		while (bytes.length < 20000) {
			for (uint64_t k = random_bits(&random) % 60; k > 0; k--)
				strbuf_add(&bytes, "x", 1);
			strbuf_add(&bytes, "x\n", 2);
		}
		faulty = 100 + random_bits(&random) % (bytes.length - 100);
		while (bytes.text[faulty] == '\n' || bytes.text[faulty - 1] == '\n' || bytes.text[faulty + 1] == '\n')
			faulty--;
		bytes.text[faulty] = odd;
		for (column = 0; bytes.text[faulty - 1 - column] != '\n'; column++)
			continue;
		for (size_t k = 0; k < faulty; k++)
			lines += bytes.text[k] == '\n';
		in = fmemopen(bytes.text, bytes.length, "r");
		reader_init(&reader, in);
		for (size_t k = 0; k < lines; k++)
			require(reader_next(&reader, &text) == READER_LINE, "file %d, line %zu", i, k);
		/* Back to the beginning, and over the same lines once more. */
		require(reader_seek(&reader, 0, 1), "file %d", i);
		for (size_t k = 0; k < lines; k++)
			require(reader_next(&reader, &text) == READER_LINE && text[0] == 'x', "file %d, line %zu", i, k);
		status = reader_next(&reader, &text);
		require(status == (odd ? READER_MIXED_ENDS : READER_NUL_BYTE), "file %d: %d", i, (int)status);
		require(strlen(text) == column, "file %d", i);
		reader_release(&reader);
		fclose(in);
		strbuf_release(&bytes);
	}
}
END_TEST

START_TEST(looking_ahead_leaves_no_trace)
{
	char bytes[] = "G0\r\nG1 X1\r\nG2\r\nM30\r\n";
	FILE *in = fmemopen(bytes, strlen(bytes), "r");
	struct reader_mark mark;
	struct reader reader;
	const char *text;

	reader_init(&reader, in);
	require(reader_next(&reader, &text) == READER_LINE && reader_next(&reader, &text) == READER_LINE, "two lines");
	mark = reader_mark(&reader);
	for (int ahead = 0; ahead < 3; ahead++) {
		for (int k = 0; k < ahead; k++)
			require(reader_next(&reader, &text) == READER_LINE, "%d ahead", k);
		require(reader_return(&reader, &mark), "back from %d", ahead);
		require(reader.line == 2 && reader.furthest == 2 && reader.start == 4, "back from %d", ahead);
	}
	require(reader_next(&reader, &text) == READER_LINE && !strcmp(text, "G2") && reader.line == 3, "%s", text);
	reader_release(&reader);
	fclose(in);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {
	    numbers_are_correctly_rounded,
	    numbers_beyond_the_mantissa,
	    number_forms, quick_and_slow_numbers_agree,
	    plain_and_general_blocks_agree,
	    line_ends,
	    odd_bytes_far_behind,
	    looking_ahead_leaves_no_trace,
	    faulty_files,
	    long_lines,
	    read_error,
	    streaming,
	    noise,
	};

	return RUN_TESTS("gcode_text", tests);
}
