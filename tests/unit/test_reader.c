/*
 * test_reader.c - the lines of a pipe are those of a file with the same bytes, in whatever packets the bytes arrive;
 * the lines of a long file are its bytes up to each line feed, in whatever order the program jumps.
 */
#include "gcode/text/reader.h"

#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "random.h"
#include "suite.h"

enum { BYTES_MOST = 60, LINES_MOST = BYTES_MOST + 2 };

struct lines {
	enum reader_status status[LINES_MOST];
	char text[LINES_MOST][BYTES_MOST + 1];
	long line[LINES_MOST];
	bool open_end[LINES_MOST];
	int count;
};

static bool ends(enum reader_status status)
{
	return status != READER_LINE;
}

static void read_lines(struct reader *reader, struct lines *lines)
{
	enum reader_status status;
	const char *text;

	lines->count = 0;
	do {
		text = "";
		status = reader_next(reader, &text);
		ck_assert_int_lt(lines->count, LINES_MOST);
		lines->status[lines->count] = status;
		snprintf(lines->text[lines->count], sizeof(lines->text[0]), "%s", ends(status) ? "" : text);
		lines->line[lines->count] = reader->line;
		lines->open_end[lines->count++] = reader->open_end;
	} while (!ends(status));
}

/* Random bytes, in which those with a meaning for the reader are frequent. */
static size_t make_bytes(struct random *random, char *bytes)
{
	static const char *const pieces[] = {"\n", "\r\n", "\r", "\r\r\n", "\n\r\r", "\0", "\x11", "\x1a", "G1", " X1",
					     "\xef\xbb\xbf", "\xff\xfe"};
	const int frequent = 1 + random_below(random, COUNT(pieces));
	size_t count = 0;

	for (size_t most = (size_t)random_below(random, BYTES_MOST - 3); count < most;) {
		const int kind = random_below(random, 3) ? random_below(random, frequent) : 8;
		const char *piece = pieces[kind];
		const size_t length = *piece ? strlen(piece) : 1;

		memcpy(bytes + count, piece, length);
		count += length;
	}
	return count;
}

static FILE *file_of(const char *bytes, size_t count)
{
	FILE *file = tmpfile();

	ck_assert_ptr_nonnull(file);
	ck_assert_uint_eq(fwrite(bytes, 1, count, file), count);
	rewind(file);
	return file;
}

/* A socket from which each read gets one packet. */
static FILE *packets_of(struct random *random, const char *bytes, size_t count)
{
	const int longest = 1 + random_below(random, 12);
	int ends[2];

	ck_assert_int_eq(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends), 0);
	for (size_t at = 0, length; at < count; at += length) {
		length = 1 + (size_t)random_below(random, longest);
		length = length < count - at ? length : count - at;
		ck_assert_int_eq(write(ends[1], bytes + at, length), (ssize_t)length);
	}
	close(ends[1]);
	return fdopen(ends[0], "rb");
}

START_TEST(packets_are_as_a_file)
{
	static struct lines expected, found;

	for (long n = 0; n < random_cases(4000); n++) {
		struct random random = random_case(1, n);
		char bytes[BYTES_MOST + 1];
		const size_t count = make_bytes(&random, bytes);
		FILE *file = file_of(bytes, count), *pipe = packets_of(&random, bytes, count);
		struct reader of_file, of_pipe;
		/* If the stream was read before, its buffer has bytes. */
		bool begun = count > 1 && random_below(&random, 2);

		if (begun)
			ck_assert_int_eq(getc(file), getc(pipe));
		reader_init(&of_file, file);
		reader_init(&of_pipe, pipe);
		ck_assert(of_pipe.is_pipe && !of_file.is_pipe);
		read_lines(&of_file, &expected);
		read_lines(&of_pipe, &found);
		require(expected.count == found.count, "case %ld: %d lines, not %d", n, found.count, expected.count);
		for (int i = 0; i < expected.count; i++)
			require(expected.status[i] == found.status[i] && expected.line[i] == found.line[i] &&
				    expected.open_end[i] == found.open_end[i] &&
				    !strcmp(expected.text[i], found.text[i]),
				"case %ld: line %d differs", n, i + 1);
		reader_release(&of_file);
		reader_release(&of_pipe);
		fclose(file);
		fclose(pipe);
	}
}
END_TEST

/* A writer that sends the next text each time that the reader has to wait. */
struct writer {
	const char *const *says;
	int end;	/* of the socket */
	int asked;
};

static bool say(void *context)
{
	struct writer *writer = context;
	const char *text = writer->says[writer->asked++];

	if (text)
		ck_assert_int_eq(write(writer->end, text, strlen(text)), (ssize_t)strlen(text));
	return !text;
}

START_TEST(a_line_is_handed_out_when_it_is_there)
{
	static const char *const says[] = {"G1 X1\n", "G1 ", "X2\nG1 X3\r", "\n", "G1 X4\r\nG1 X5\nG1", NULL};
	static const int asked[] = {1, 3, 4, 5, 5};
	struct writer writer = {.says = says};
	const struct cancel waiting = {&writer, say};
	struct reader reader;
	const char *text;
	char expected[] = "G1 X0";
	int sockets[2];
	FILE *in;

	ck_assert_int_eq(socketpair(AF_UNIX, SOCK_STREAM, 0, sockets), 0);
	in = fdopen(sockets[0], "rb");
	writer.end = sockets[1];
	reader_init(&reader, in);
	reader.waiting = &waiting;
	for (int i = 0; i < COUNT(asked); i++) {
		expected[4]++;
		ck_assert_int_eq(reader_next(&reader, &text), READER_LINE);
		ck_assert_str_eq(text, expected);
		ck_assert_int_eq(writer.asked, asked[i]);
	}
	/* The rest of an unfinished line is not returned. */
	ck_assert_int_eq(reader_next(&reader, &text), READER_STOPPED);
	ck_assert_int_eq(reader_next(&reader, &text), READER_STOPPED);
	reader_release(&reader);
	fclose(in);
	close(sockets[1]);
}
END_TEST

/* Lines that end with LF or CR LF, as a simple program splits them. */
struct text {
	char *bytes;
	size_t length;
	size_t starts[6000];
	int lines;
	bool open;	/* the last line has no end */
};

/* Short and long lines, so that the text is several times as long as all that a reader looks at together. */
static void make_text(struct random *random, struct text *text)
{
	const int longest = random_below(random, 2) ? 100 : 1000, returns = random_below(random, 3) ? 0 : 2;

	text->bytes = malloc(COUNT(text->starts) * (size_t)(longest + 2));
	ck_assert_ptr_nonnull(text->bytes);
	/* The first line shows that the file is a program, and how its lines end. */
	text->length = (size_t)sprintf(text->bytes, "G1\n");
	text->starts[0] = 0;
	for (text->lines = 1; text->lines < COUNT(text->starts); text->lines++) {
		const int length = random_below(random, longest);

		text->starts[text->lines] = text->length;
		for (int i = 0; i < length; i++)
			text->bytes[text->length++] = (char)('A' + random_below(random, 26));
		if (returns && random_below(random, returns))
			text->bytes[text->length++] = '\r';
		text->bytes[text->length++] = '\n';
	}
	text->open = random_below(random, 2);
	text->length -= text->open;
}

/* Puts a byte that no line may have into a line. Returns its number, from 0, or that of no line. */
static int spoil(struct random *random, struct text *text, char *odd)
{
	const size_t at = (size_t)random_below(random, (int)text->length);
	int line = text->lines - 1;

	*odd = random_below(random, 2) ? '\0' : '\r';
	/* A CR before the line's LF, or at the end of the text, would be allowed; one at the start is skipped. */
	if (random_below(random, 3) == 0 || at <= text->starts[1] || at + 2 >= text->length ||
	    text->bytes[at - 1] < 'A' || text->bytes[at + 1] < 'A')
		return text->lines;
	while (text->starts[line] > at)
		line--;
	text->bytes[at] = *odd;
	return line;
}

START_TEST(lines_are_the_same_after_jumps)
{
	static struct text text;

	for (long n = 0; n < random_cases(60); n++) {
		struct random random = random_case(2, n);
		struct reader reader;
		int odd_line, line = 0;
		const char *found;
		char odd;
		FILE *file;

		make_text(&random, &text);
		odd_line = spoil(&random, &text, &odd);
		file = file_of(text.bytes, text.length);
		reader_init(&reader, file);
		for (long step = 0; line < text.lines && step < 3L * text.lines; step++) {
			const char *start = text.bytes + text.starts[line];
			const char *feed = memchr(start, '\n', (size_t)(text.bytes + text.length - start));
			size_t length = (size_t)((feed ? feed : text.bytes + text.length) - start);
			enum reader_status status = reader_next(&reader, &found);

			length -= length > 0 && start[length - 1] == '\r';
			require(reader.line == line + 1 && reader.start == (long long)text.starts[line],
				"case %ld: line %ld, not %d", n, reader.line, line + 1);
			if (line == odd_line) {
				require(status == (odd ? READER_MIXED_ENDS : READER_NUL_BYTE),
					"case %ld: status %d of line %d", n, status, line + 1);
				break;
			}
			require(status == READER_LINE && strlen(found) == length && !memcmp(found, start, length),
				"case %ld: line %d differs", n, line + 1);
			require(reader.open_end == !feed, "case %ld: the end of line %d", n, line + 1);
			line++;
			if (random_below(&random, 500))
				continue;
			line = random_below(&random, line + 1);
			require(reader_seek(&reader, (long long)text.starts[line], line + 1), "case %ld: seek", n);
		}
		if (line == text.lines)
			ck_assert_int_eq(reader_next(&reader, &found), READER_END);
		reader_release(&reader);
		fclose(file);
		free(text.bytes);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {packets_are_as_a_file, a_line_is_handed_out_when_it_is_there,
				      lines_are_the_same_after_jumps};

	return RUN_TESTS("reader", tests);
}
