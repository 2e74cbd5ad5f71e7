#include "geom/stl.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/mem.h"
#include "base/path_sandbox.h"

/*
 * Binary format: 80 arbitrary bytes, a 32-bit count, then 50 bytes for each triangle: the normal and three corners of
 * three floats each, and 2 bytes of attributes; all little-endian.
 */
#define HEADER_SIZE 84
#define COUNT_AT 80
#define RECORD_SIZE 50
#define CORNERS_AT 12

#define BUFFER_SIZE ((size_t)256 * 1024)
#define SHOWN_MAX 40	/* bytes of a faulty word in a message */

/* A window on the file: bytes [at, end) of the buffer are unread, and a NUL follows them. */
struct reader {
	int fd;
	uint64_t file_size;
	struct diag *diag;
	char *buffer;
	size_t at, end;
	uint64_t buffer_start;	/* where in the file buffer[0] was */
	bool failed;	/* reported already */
	struct srcloc loc;	/* of the current word */
	uint64_t line_start;	/* where in the file the line begins */
	const char *word;
	size_t word_length;
};

/* The data read so far. */
struct soup {
	struct mesh mesh;
	size_t capacity;
	double rounding;	/* the most by which a coordinate differs from its text */
	double largest;
};

static bool fail(struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool fail(struct reader *r, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	diag_report(r->diag, DIAG_ERROR, r->loc, NULL, format, args);
	va_end(args);
	r->failed = true;
	return false;
}

/*
 * Moves the unread bytes to the front and reads more behind them. False at the end, on failure, or with a full buffer.
 */
static bool fill(struct reader *r)
{
	ssize_t got;

	memmove(r->buffer, r->buffer + r->at, r->end - r->at);
	r->buffer_start += r->at;
	r->end -= r->at;
	r->at = 0;
	do
		got = read(r->fd, r->buffer + r->end, BUFFER_SIZE - r->end);
	while (got < 0 && errno == EINTR);
	if (got < 0)
		return fail(r, "cannot read: %s", strerror(errno));
	r->end += (size_t)got;
	r->buffer[r->end] = '\0';
	return got > 0;
}

static uint32_t little_endian(const char *bytes)
{
	const unsigned char *b = (const unsigned char *)bytes;

	return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* ---- binary ---- */

/* The corners of one record; false if a coordinate is not finite. */
static bool decode_record(mesh_triangle *t, const char *record)
{
	bool finite = true;

	for (int k = 0; k < 9; k++) {
		uint32_t bits = little_endian(record + CORNERS_AT + 4 * k);

		memcpy(&t->v[k / 3][k % 3], &bits, sizeof(bits));
		finite &= (bits & 0x7f800000) != 0x7f800000;
	}
	return finite;
}

static bool is_at_origin(const mesh_triangle *t)
{
	for (int k = 0; k < 3; k++)
		if (vec3_norm2(mesh_corner(t, k)) > 0)
			return false;
	return true;
}

/* The number of triangles at the end that have all corners at the origin. */
static size_t zeros_at_end(const struct mesh *mesh)
{
	size_t count = 0;

	while (count < mesh->count && is_at_origin(&mesh->triangles[mesh->count - 1 - count]))
		count++;
	return count;
}

/* One such triangle may be intended. More are space that was reserved for the file and never written. */
static bool is_written_to_end(struct reader *r, const struct mesh *mesh)
{
	size_t zeros = zeros_at_end(mesh);

	if (zeros < 2)
		return true;
	return fail(r,
		    "the last %zu of its %zu triangles are zeros: the file was not written or copied completely", zeros,
		    mesh->count);
}

static bool read_binary(struct reader *r, struct mesh *mesh, uint32_t count)
{
	if (count == 0)
		return fail(r, "has no triangles");
	if (count > STL_TRIANGLES_MAX)
		return fail(r, "has more than %d triangles", STL_TRIANGLES_MAX);
	mesh->triangles = mem_alloc(count * sizeof(*mesh->triangles));
	r->at = HEADER_SIZE;
	while (mesh->count < count) {
		if (r->end - r->at < RECORD_SIZE) {
			if (!fill(r))
				return r->failed ? false : fail(r, "became shorter while it was read");
			continue;
		}
		if (!decode_record(&mesh->triangles[mesh->count], r->buffer + r->at))
			return fail(r, "triangle %zu, byte %llu: a coordinate is not a finite number", mesh->count + 1,
				    (unsigned long long)r->buffer_start + r->at + CORNERS_AT);
		mesh->count++;
		r->at += RECORD_SIZE;
	}
	return is_written_to_end(r, mesh);
}

/* ---- ASCII ---- */

/* False at the end of the file, or on failure. */
static bool skip_space(struct reader *r)
{
	for (;;) {
		for (; r->at < r->end; r->at++) {
			if (!ascii_is_space(r->buffer[r->at]))
				return true;
			if (r->buffer[r->at] == '\n') {
				r->loc.line++;
				r->line_start = r->buffer_start + r->at + 1;
			}
		}
		if (!fill(r))
			return false;
	}
}

/* The next word, terminated by the character after it; valid until the next call. False at the end, or on failure. */
static bool next_word(struct reader *r)
{
	size_t length = 0;
	uint64_t column;

	if (!skip_space(r))
		return false;
	for (;;) {
		while (r->at + length < r->end && !ascii_is_space(r->buffer[r->at + length]))
			length++;
		if (r->at + length < r->end || !fill(r))
			break;
	}
	if (r->failed)
		return false;
	column = r->buffer_start + r->at - r->line_start + 1;
	r->loc.column = column < INT32_MAX ? (int)column : 0;
	if (length == BUFFER_SIZE)
		return fail(r, "a word of more than %zu bytes", BUFFER_SIZE - 1);
	r->word = r->buffer + r->at;
	r->word_length = length;
	r->at += length;
	return true;
}

/* The name after "solid" or "endsolid" may be anything. */
static void skip_line(struct reader *r)
{
	do {
		for (; r->at < r->end; r->at++) {
			if (r->buffer[r->at] == '\n' || r->buffer[r->at] == '\r')
				return;
		}
	} while (fill(r));
}

static bool word_is(const struct reader *r, const char *keyword)
{
	return r->word_length == strlen(keyword) && ascii_same_start(r->word, keyword, r->word_length);
}

/* Reports the failure of next_word. */
static bool truncated(struct reader *r, const char *expected)
{
	r->loc.column = 0;
	return r->failed ? false : fail(r, "the file ends where %s is expected: it is truncated", expected);
}

static bool unexpected(struct reader *r, const char *expected)
{
	char shown[SHOWN_MAX + 1];
	size_t length = r->word_length < SHOWN_MAX ? r->word_length : SHOWN_MAX;

	for (size_t i = 0; i < length; i++)
		shown[i] = r->word[i] >= ' ' && r->word[i] <= '~' ? r->word[i] : '?';
	shown[length] = '\0';
	return fail(r, "\"%s%s\" where %s is expected", shown, length < r->word_length ? "..." : "", expected);
}

static bool expect(struct reader *r, const char *keyword)
{
	if (!next_word(r))
		return truncated(r, keyword);
	return word_is(r, keyword) || unexpected(r, keyword);
}

static bool is_not_a_number(const struct reader *r)
{
	size_t sign = *r->word == '-' || *r->word == '+';

	return r->word_length >= sign + 3 &&
	       (ascii_same_start(r->word + sign, "nan", 3) || ascii_same_start(r->word + sign, "inf", 3));
}

static bool read_coordinate(struct reader *r, struct soup *soup, float *out)
{
	double value;

	if (!next_word(r))
		return truncated(r, "a coordinate");
	if (!decimal_read_float(r->word, r->word_length, out, &value)) {
		if (!is_not_a_number(r))
			return unexpected(r, "a coordinate");
		*out = NAN;
	}
	if (!isfinite(*out))
		return fail(r, "triangle %zu: a coordinate is not a finite 32-bit number", soup->mesh.count + 1);
	soup->rounding = fmax(soup->rounding, fabs(value - (double)*out));
	soup->largest = fmax(soup->largest, fabs(value));
	return true;
}

/*
 * Reads what follows "facet". The normal is not used, and bad ones are common in degenerate facets: any three words are
 * accepted.
 */
static bool read_facet(struct reader *r, struct soup *soup)
{
	mesh_triangle t;

	if (!expect(r, "normal"))
		return false;
	for (int k = 0; k < 3; k++) {
		if (!next_word(r))
			return truncated(r, "the normal");
		if (word_is(r, "outer"))
			return unexpected(r, "the normal");
	}
	if (!expect(r, "outer") || !expect(r, "loop"))
		return false;
	for (int k = 0; k < 9; k++) {
		if (k % 3 == 0 && !expect(r, "vertex"))
			return false;
		if (!read_coordinate(r, soup, &t.v[k / 3][k % 3]))
			return false;
	}
	if (!expect(r, "endloop") || !expect(r, "endfacet"))
		return false;
	if (soup->mesh.count == STL_TRIANGLES_MAX)
		return fail(r, "has more than %d triangles", STL_TRIANGLES_MAX);
	soup->mesh.triangles = mem_grow(soup->mesh.triangles, &soup->capacity, soup->mesh.count + 1, sizeof(t));
	soup->mesh.triangles[soup->mesh.count++] = t;
	return true;
}

/* Reads from the name after "solid" to the one after "endsolid". */
static bool read_solid(struct reader *r, struct soup *soup)
{
	for (skip_line(r); next_word(r);) {
		if (word_is(r, "endsolid")) {
			skip_line(r);
			return !r->failed;
		}
		if (!word_is(r, "facet"))
			return unexpected(r, "facet or endsolid");
		if (!read_facet(r, soup))
			return false;
	}
	return truncated(r, "facet or endsolid");
}

/* Reads any number of solids, one after the other. */
static bool read_solids(struct reader *r, struct soup *soup)
{
	r->loc.line = 1;
	while (next_word(r)) {
		if (!word_is(r, "solid"))
			return unexpected(r, "solid");
		if (!read_solid(r, soup))
			return false;
	}
	r->loc = (struct srcloc){.file = r->loc.file};
	if (r->failed || soup->mesh.count == 0)
		return r->failed ? false : fail(r, "has no triangles");
	/*
	 * The error of each coordinate is its rounding to float and, much smaller, to double; that of a point is
	 * sqrt(3) times as large.
	 */
	soup->mesh.rounding = 1.8 * (soup->rounding + DBL_EPSILON * soup->largest);
	soup->mesh.triangles = mem_realloc(soup->mesh.triangles, soup->mesh.count, sizeof(mesh_triangle));
	return true;
}

/* ---- binary or ASCII ---- */

static bool is_text(const struct reader *r)
{
	return !memchr(r->buffer, '\0', r->end);
}

/* The bytes of a byte order mark, which some programs put before text; 0: there is none. */
static size_t byte_order_mark(const struct reader *r)
{
	return strncmp(r->buffer, "\xef\xbb\xbf", 3) ? 0 : 3;
}

static bool starts_with_solid(const struct reader *r)
{
	const char *at = r->buffer + byte_order_mark(r);

	while (ascii_is_space(*at))
		at++;
	return ascii_same_start(at, "solid", 5) && (at[5] == '\0' || ascii_is_space(at[5]));
}

/* Reports the error in a file whose size does not match its header and that is not ASCII, either. */
static bool fail_unfitting(struct reader *r)
{
	uint64_t expected, size = r->file_size;
	uint32_t count;

	if (size == 0)
		return fail(r, "is empty");
	if (size < HEADER_SIZE || is_text(r))
		return fail(r,
			    "is not an STL file: neither ASCII (text that starts with \"solid\") nor binary (a header "
			    "of 84 bytes whose last 4 are the number of triangles, then 50 bytes per triangle)");
	count = little_endian(r->buffer + COUNT_AT);
	expected = HEADER_SIZE + (uint64_t)count * RECORD_SIZE;
	if (size < expected)
		return fail(r, "truncated binary STL: the header announces %lu triangles, %llu bytes are missing",
			    (unsigned long)count, (unsigned long long)(expected - size));
	return fail(r, "binary STL: the header announces %lu triangles, %llu bytes follow the last triangle",
		    (unsigned long)count, (unsigned long long)(size - expected));
}

static bool read_either(struct reader *r, struct soup *soup)
{
	/* Read as much as the buffer holds: the whole of a small file. */
	while (fill(r))
		continue;
	if (r->failed)
		return false;
	if (r->end >= HEADER_SIZE) {
		uint32_t count = little_endian(r->buffer + COUNT_AT);

		/* An ASCII file would have to be some gigabytes long to match this size. */
		if (r->file_size == HEADER_SIZE + (uint64_t)count * RECORD_SIZE)
			return read_binary(r, &soup->mesh, count);
	}
	if (!starts_with_solid(r) || !is_text(r))
		return fail_unfitting(r);
	r->at = byte_order_mark(r);
	return read_solids(r, soup);
}

/* Opening must not wait for the writer of a FIFO, nor block on a device. */
static bool open_regular(struct reader *r, const char *root)
{
	struct stat status;

	r->fd = path_sandbox_open(root, r->loc.file);
	if (r->fd < 0 && errno == EXDEV)
		return fail(r, "is outside the input root %s, or a link leads there", root);
	if (r->fd < 0)
		return fail(r, "cannot open: %s", strerror(errno));
	if (fstat(r->fd, &status) != 0)
		return fail(r, "cannot read: %s", strerror(errno));
	if (!S_ISREG(status.st_mode))
		return fail(r, S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
	r->file_size = (uint64_t)status.st_size;
	return true;
}

bool stl_read(struct mesh *out, const char *path, struct diag *diag)
{
	return stl_read_below(out, NULL, path, diag);
}

bool stl_read_below(struct mesh *out, const char *root, const char *path, struct diag *diag)
{
	struct reader r = {.fd = -1, .diag = diag, .loc = {.file = path}};
	struct soup soup = {0};
	bool ok;

	r.buffer = mem_alloc(BUFFER_SIZE + 1);
	ok = open_regular(&r, root) && read_either(&r, &soup);
	if (ok)
		*out = soup.mesh;
	else
		mesh_release(&soup.mesh);
	free(r.buffer);
	if (r.fd >= 0)
		close(r.fd);
	return ok;
}
