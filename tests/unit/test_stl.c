/* test_stl.c - STL files as other programs write them, complete and broken; decimals against strtof. */
#include "geom/stl.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/decimal.h"
#include "base/strbuf.h"
#include "suite.h"

static char folder[] = "/tmp/test_stl.XXXXXX";

static uint64_t random_bits(uint64_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	*state ^= *state << 17;
	return *state;
}

static const char *path_of(char *path, size_t size, const char *name)
{
	snprintf(path, size, "%s/%s", folder, name);
	return path;
}

static void keep_message(void *context, const struct diag_entry *entry)
{
	diag_format(context, entry);
}

/* Reads the file. The messages go to `said`, without the name of the folder. */
static bool read_named(struct mesh *mesh, const char *name, struct strbuf *said)
{
	struct strbuf raw = {0};
	struct diag diag = {.handle = keep_message, .context = &raw};
	char path[256];
	bool ok = stl_read(mesh, path_of(path, sizeof(path), name), &diag);
	const char *text = strbuf_text(&raw);

	ck_assert_uint_eq(diag.errors, !ok);
	strbuf_clear(said);
	strbuf_addf(said, "%s", strncmp(text, folder, strlen(folder)) == 0 ? text + strlen(folder) + 1 : text);
	strbuf_release(&raw);
	return ok;
}

static void write_named(const char *name, const void *bytes, size_t count)
{
	char path[256];
	FILE *file = fopen(path_of(path, sizeof(path), name), "wb");

	ck_assert_ptr_nonnull(file);
	ck_assert_uint_eq(fwrite(bytes, 1, count, file), count);
	ck_assert_int_eq(fclose(file), 0);
}

static bool read_bytes(struct mesh *mesh, const void *bytes, size_t count, struct strbuf *said)
{
	write_named("t.stl", bytes, count);
	return read_named(mesh, "t.stl", said);
}

/* A binary file of `count` triangles of random bits (finite), with a header that announces `announced` triangles. */
static unsigned char *binary_stl(size_t count, uint32_t announced, const char *title, size_t *size)
{
	unsigned char *bytes = calloc(1, 84 + 50 * count);
	uint64_t state = 1 + count;

	ck_assert_ptr_nonnull(bytes);
	strncpy((char *)bytes, title, 80);
	for (int k = 0; k < 4; k++)
		bytes[80 + k] = (unsigned char)(announced >> 8 * k);
	for (size_t i = 0; i < count; i++) {
		for (int k = 0; k < 50; k++)
			bytes[84 + 50 * i + (size_t)k] = (unsigned char)(random_bits(&state) >> 20);
		/* A cleared bit in each exponent keeps the corners finite; the normals are arbitrary. */
		for (int k = 3; k < 12; k++)
			bytes[84 + 50 * i + 4 * (size_t)k + 3] &= 0xbf;
	}
	*size = 84 + 50 * count;
	return bytes;
}

static void expect_error(const void *bytes, size_t count, const char *message)
{
	struct mesh mesh = {.count = 12345};
	struct strbuf said = {0};

	ck_assert_msg(!read_bytes(&mesh, bytes, count, &said), "was read: %s", message);
	ck_assert_str_eq(strbuf_text(&said), message);
	ck_assert_uint_eq(mesh.count, 12345);
	ck_assert_ptr_null(mesh.triangles);
	strbuf_release(&said);
}

/* ---- binary ---- */

START_TEST(binary_is_read_to_the_bit)
{
	static const size_t counts[] = {1, 2, 5000, 20001};
	static const char *const titles[] = {"", "made by hand", "solid cube", "solid"};

	for (int c = 0; c < 4; c++) {
		struct mesh mesh;
		struct strbuf said = {0};
		size_t size, count = counts[c];
		unsigned char *bytes = binary_stl(count, (uint32_t)count, titles[c], &size);

		ck_assert_msg(read_bytes(&mesh, bytes, size, &said), "%s", strbuf_text(&said));
		ck_assert_uint_eq(mesh.count, count);
		ck_assert(mesh.rounding <= 0);
		for (size_t i = 0; i < count; i++)
			ck_assert_mem_eq(&mesh.triangles[i], bytes + 84 + 50 * i + 12, 36);
		mesh_release(&mesh);
		strbuf_release(&said);
		free(bytes);
	}
}
END_TEST

START_TEST(binary_that_lies)
{
	size_t size;
	unsigned char *bytes = binary_stl(3, 3, "solid x", &size);
	unsigned char *more = binary_stl(3, 2, "x", &size), *lie = binary_stl(3, 0xffffffff, "x", &size);

	expect_error(bytes, size - 1,
		     "t.stl: error: truncated binary STL: the header announces 3 triangles, 1 bytes are missing\n");
	expect_error(bytes, 84,
		     "t.stl: error: truncated binary STL: the header announces 3 triangles, 150 bytes are missing\n");
	expect_error(more, size,
		     "t.stl: error: binary STL: the header announces 2 triangles, 50 bytes follow the last triangle\n");
	expect_error(lie, size,
		     "t.stl: error: truncated binary STL: the header announces 4294967295 triangles, "
		     "214748364600 bytes are missing\n");
	memset(bytes + 80, 0, 4);
	expect_error(bytes, 84, "t.stl: error: has no triangles\n");
	free(bytes);
	free(more);
	free(lie);
}
END_TEST

/* A copy that was broken off after its file had got the full size. */
START_TEST(binary_of_zeros)
{
	size_t size;
	unsigned char *bytes = binary_stl(40, 40, "x", &size);
	struct strbuf said = {0};
	struct mesh mesh;

	memset(bytes + size - 50, 0, 50);
	ck_assert_msg(read_bytes(&mesh, bytes, size, &said), "one may be meant: %s", strbuf_text(&said));
	mesh_release(&mesh);
	memset(bytes + size - 17 * 50, 0, 17 * 50);
	expect_error(bytes, size,
		     "t.stl: error: the last 17 of its 40 triangles are zeros: the file was not written or copied "
		     "completely\n");
	memset(bytes + 84, 0, size - 84);
	expect_error(bytes, size,
		     "t.stl: error: the last 40 of its 40 triangles are zeros: the file was not written or copied "
		     "completely\n");
	free(bytes);
	strbuf_release(&said);
}
END_TEST

START_TEST(binary_not_finite)
{
	static const uint32_t bad[] = {0x7f800000, 0xff800000, 0x7fc00000, 0xffffffff, 0x7f800001};

	for (int b = 0; b < 5; b++) {
		size_t size;
		unsigned char *bytes = binary_stl(3, 3, "x", &size);

		for (int k = 0; k < 4; k++)
			bytes[84 + 50 + 12 + 4 * b + k] = (unsigned char)(bad[b] >> 8 * k);
		expect_error(bytes, size,
			     "t.stl: error: triangle 2, byte 146: a coordinate is not a finite number\n");
		free(bytes);
	}
}
END_TEST

/* ---- ASCII ---- */

#define FACET(x, y, z) "facet normal 0 0 1\nouter loop\nvertex " x "\nvertex " y "\nvertex " z "\nendloop\nendfacet\n"
#define GOOD FACET("0 0 0", "1 0 0", "0 1 0")

static void expect_mesh(const char *text, size_t count, const float *first)
{
	struct mesh mesh;
	struct strbuf said = {0};

	ck_assert_msg(read_bytes(&mesh, text, strlen(text), &said), "%s", strbuf_text(&said));
	ck_assert_uint_eq(mesh.count, count);
	for (int k = 0; k < 9; k++)
		ck_assert_float_eq(mesh.triangles[0].v[k / 3][k % 3], first[k]);
	mesh_release(&mesh);
	strbuf_release(&said);
}

START_TEST(ascii_in_its_variants)
{
	static const float unit[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
	static const float other[9] = {1500, -0.25f, 1e-7f, 3, 4, 5e30f, 0.1f, -0.0f, .5f};

	expect_mesh("solid\n" GOOD "endsolid\n", 1, unit);
	expect_mesh("solid a name, of facet normal\n" GOOD GOOD "endsolid a name", 2, unit);
	expect_mesh("\xef\xbb\xbfsolid marked\n" GOOD "endsolid marked\n", 1, unit);
	expect_mesh("  \n\tSOLID X\r\nFACET NORMAL 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1 0 0\r\n"
		    "VERTEX 0 1 0\r\nENDLOOP\r\nENDFACET\r\nENDSOLID X\r\n", 1, unit);
	expect_mesh("solid\rfacet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 1 0\r"
		    "endloop\rendfacet\rendsolid\r", 1, unit);
	expect_mesh("solid\nfacet normal nan -nan(ind) 1.#QNAN outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 "
		    "endloop endfacet endsolid\n", 1, unit);
	expect_mesh("solid empty\nendsolid\nsolid one\n" GOOD "endsolid one\n\n\nsolid two\n" GOOD GOOD "endsolid\n", 3,
		    unit);
	expect_mesh("solid\n" FACET("1.5e+3 -2.5E-01 +0.0000001", "3. 4.0 5e30", ".1 -0 5.e-1") "endsolid", 1, other);
}
END_TEST

START_TEST(ascii_that_is_broken)
{
	static const struct {
		const char *text, *message;
	} cases[] = {
		{"", "t.stl: error: is empty\n"},
		{"solid\nendsolid\n", "t.stl: error: has no triangles\n"},
		{"solid", "t.stl:1: error: the file ends where facet or endsolid is expected: it is truncated\n"},
		{"solid\n" GOOD,
		 "t.stl:9: error: the file ends where facet or endsolid is expected: it is truncated\n"},
		{"solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2",
		 "t.stl:4: error: the file ends where a coordinate is expected: it is truncated\n"},
		{"solid\n" GOOD "facet normal 0 0",
		 "t.stl:9: error: the file ends where the normal is expected: it is truncated\n"},
		{"solid\n" FACET("0 0 0", "1 0 x", "0 1 0") "endsolid",
		 "t.stl:5:12: error: \"x\" where a coordinate is expected\n"},
		{"solid\n" FACET("0 0 0", "1 0 0x1p3", "0 1 0") "endsolid",
		 "t.stl:5:12: error: \"0x1p3\" where a coordinate is expected\n"},
		{"solid\n" FACET("0 0 0", "1 0 0,5", "0 1 0") "endsolid",
		 "t.stl:5:12: error: \"0,5\" where a coordinate is expected\n"},
		{"solid\n" GOOD FACET("0 0 0", "1 0 -nan", "0 1 0") "endsolid",
		 "t.stl:12:12: error: triangle 2: a coordinate is not a finite 32-bit number\n"},
		{"solid\n" FACET("1e39 0 0", "1 0 0", "0 1 0") "endsolid",
		 "t.stl:4:8: error: triangle 1: a coordinate is not a finite 32-bit number\n"},
		{"solid\n" FACET("0 0 0", "1 0 0", "0 1 0\nvertex 0 0 1") "endsolid",
		 "t.stl:7:1: error: \"vertex\" where endloop is expected\n"},
		{"solid\n" FACET("0 0 0", "1 0", "0 1 0") "endsolid",
		 "t.stl:6:1: error: \"vertex\" where a coordinate is expected\n"},
		{"solid\nfacet normal 0 0 outer loop", "t.stl:2:18: error: \"outer\" where the normal is expected\n"},
		{"solid\n" GOOD "endsolid\nfacet", "t.stl:10:1: error: \"facet\" where solid is expected\n"},
		{"solid\n\x1b[31mfacets, and a word that goes on and on and on and on",
		 "t.stl:2:1: error: \"?[31mfacets,\" where facet or endsolid is expected\n"},
		{"solid\nface normal", "t.stl:2:1: error: \"face\" where facet or endsolid is expected\n"},
		{"solidity\nfacet",
		 "t.stl: error: is not an STL file: neither ASCII (text that starts with \"solid\") nor binary (a "
		 "header of 84 bytes whose last 4 are the number of triangles, then 50 bytes per triangle)\n"},
	};

	for (size_t i = 0; i < COUNT(cases); i++)
		expect_error(cases[i].text, strlen(cases[i].text), cases[i].message);
}
END_TEST

START_TEST(ascii_crosses_the_buffer)
{
	/* A few megabytes, with words at all offsets from the ends of the reader's buffer. */
	struct strbuf text = {0}, said = {0};
	struct mesh mesh;
	uint64_t state = 3;
	size_t count = 20000;

	strbuf_addf(&text, "solid\n");
	for (size_t i = 0; i < count; i++) {
		float v[9];

		for (int k = 0; k < 9; k++)
			v[k] = (float)((double)(int32_t)random_bits(&state) * 1e-5);
		strbuf_addf(&text, "facet normal 0 0 0%*s\nouter loop\n", (int)(i % 13), "");
		for (int k = 0; k < 9; k += 3)
			strbuf_addf(&text, "vertex %.9g %.9g %.9g\n", (double)v[k], (double)v[k + 1], (double)v[k + 2]);
		strbuf_addf(&text, "endloop\nendfacet\n");
	}
	strbuf_addf(&text, "endsolid\n");
	ck_assert_msg(read_bytes(&mesh, text.text, text.length, &said), "%s", strbuf_text(&said));
	ck_assert_uint_eq(mesh.count, count);
	state = 3;
	for (size_t i = 0; i < 9 * count; i++)
		ck_assert_float_eq(mesh.triangles[i / 9].v[i % 9 / 3][i % 3],
				   (float)((double)(int32_t)random_bits(&state) * 1e-5));
	/* Nine digits are less exact than a float of this size: there is rounding, but no more than half a unit. */
	ck_assert_double_gt(mesh.rounding, 0);
	ck_assert_double_le(mesh.rounding, 1.8 * 22000 * (double)FLT_EPSILON / 2);
	mesh_release(&mesh);
	text.text[text.length / 2] = 'q';
	ck_assert(!read_bytes(&mesh, text.text, text.length, &said));
	strbuf_release(&text);
	strbuf_release(&said);
}
END_TEST

START_TEST(ascii_word_without_end)
{
	size_t length = 1000000;
	char *text = malloc(length);

	memset(text, '1', length);
	memcpy(text, "solid\n", 6);
	expect_error(text, length, "t.stl:2:1: error: a word of more than 262143 bytes\n");
	free(text);
}
END_TEST

/* ---- files that are no STL ---- */

START_TEST(not_a_regular_file)
{
	struct mesh mesh;
	struct strbuf said = {0};
	char path[256];
	struct diag diag = {0};

	ck_assert(!read_named(&mesh, "absent.stl", &said));
	ck_assert_str_eq(strbuf_text(&said), "absent.stl: error: cannot open: No such file or directory\n");
	ck_assert_int_eq(mkdir(path_of(path, sizeof(path), "folder.stl"), 0700), 0);
	ck_assert(!read_named(&mesh, "folder.stl", &said));
	ck_assert_str_eq(strbuf_text(&said), "folder.stl: error: is a directory\n");
	ck_assert_int_eq(mkfifo(path_of(path, sizeof(path), "fifo.stl"), 0600), 0);
	ck_assert(!read_named(&mesh, "fifo.stl", &said));
	ck_assert_str_eq(strbuf_text(&said), "fifo.stl: error: is not a regular file\n");
	ck_assert(!stl_read(&mesh, "/dev/zero", &diag));
	ck_assert_uint_eq(diag.errors, 1);
	rmdir(path_of(path, sizeof(path), "folder.stl"));
	unlink(path_of(path, sizeof(path), "fifo.stl"));
	strbuf_release(&said);
}
END_TEST

/* For every damaged file, reading ends: with finite triangles or with one error. */
START_TEST(mutilated_files)
{
	static const char ascii[] = "solid a\n" GOOD FACET("1e5 -2.25 3e-4", "0.5 .5 5.", "7 8 9") "endsolid a\n";
	uint64_t state = 12;

	for (int turn = 0; turn < 3000; turn++) {
		struct mesh mesh;
		struct strbuf said = {0};
		size_t size = sizeof(ascii) - 1;
		unsigned char *bytes = turn % 2 ? binary_stl(3, 3, "solid", &size) : calloc(1, size);

		if (turn % 2 == 0)
			memcpy(bytes, ascii, size);
		for (uint64_t k = random_bits(&state) % 4; k > 0; k--)
			bytes[random_bits(&state) % size] = (unsigned char)(random_bits(&state) >> 9);
		size -= random_bits(&state) % 3 ? 0 : random_bits(&state) % size;
		if (read_bytes(&mesh, bytes, size, &said)) {
			ck_assert_uint_gt(mesh.count, 0);
			for (size_t i = 0; i < 9 * mesh.count; i++)
				ck_assert(isfinite(mesh.triangles[i / 9].v[i % 9 / 3][i % 3]));
			mesh_release(&mesh);
		}
		strbuf_release(&said);
		free(bytes);
	}
}
END_TEST

/* ---- decimals ---- */

static void expect_decimal(const char *word)
{
	float nearest;
	double value, nearest_double;

	ck_assert_msg(decimal_read_float(word, strlen(word), &nearest, &value), "%s", word);
	ck_assert_msg(nearest == strtof(word, NULL) && value == strtod(word, NULL), "%s gives %.9g and %.17g", word,
		      (double)nearest, value);
	nearest_double = 7;
	ck_assert(decimal_read(word, strlen(word), &nearest_double) && nearest_double == value);
}

START_TEST(decimals_are_the_nearest)
{
	static const char *const chosen[] = {
		"0", "-0", "1", "16777217", "16777217.0000000000000001", "16777216.9999999999999999999",
		"33554434.5e-0",
		"0.1", "123456789012345678901234567890", "1e400", "-1e-400", "1e99999999999", "3.4028235e38",
		"3.4028236e38",
		"1.17549435e-38", "1.17549428e-38", "1e-45", "7e-46", "0.000000000000000000000000000000000000001",
		"9e22",
		"9007199254740993", "9007199254740993e-3", "1.00000005960464477539062500",
		"1.00000005960464477539062501",
	};
	uint64_t state = 8;
	char word[64];

	for (size_t i = 0; i < COUNT(chosen); i++)
		expect_decimal(chosen[i]);
	for (int turn = 0; turn < 500000; turn++) {
		uint32_t bits = (uint32_t)(random_bits(&state) >> 8);
		int digits = 1 + (int)(random_bits(&state) >> 12) % 19;
		float f;
		double d;

		memcpy(&f, &bits, sizeof(f));
		if (turn % 3 == 0)
			d = (double)(int32_t)bits / (double)(1 + (random_bits(&state) >> 40) % 100000);
		else
			d = (double)f;
		/* Half-way between two floats, where rounding twice may go wrong, and a little beside. */
		if (turn % 3 == 1)
			d += ((double)nextafterf(f, INFINITY) - d) / 2 * (turn % 2 ? 1 : 1 + 1e-15);
		if (!isfinite(d))
			continue;
		snprintf(word, sizeof(word), turn % 2 ? "%.*g" : "%.*e", digits, d);
		expect_decimal(word);
	}
}
END_TEST

START_TEST(what_is_no_decimal)
{
	static const char *const words[] = {"",	   ".",	   "-",	  "+-1", "e5",	"1e",	"1e+",	"1.2.3", "1f",
					    "0x1", "inf",  "nan", "1 ",	 "--1", ".e5",	"1e5.",	 "1,5",	 "-.",};

	for (size_t i = 0; i < COUNT(words); i++) {
		float nearest;
		double value;

		ck_assert_msg(!decimal_read_float(words[i], strlen(words[i]), &nearest, &value), "\"%s\"", words[i]);
		ck_assert_msg(!decimal_read(words[i], strlen(words[i]), &value), "\"%s\"", words[i]);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");
	char path[256];
	int status;

	if (!mkdtemp(folder))
		return EXIT_FAILURE;
	tcase_add_test(tcase, binary_is_read_to_the_bit);
	tcase_add_test(tcase, binary_that_lies);
	tcase_add_test(tcase, binary_of_zeros);
	tcase_add_test(tcase, binary_not_finite);
	tcase_add_test(tcase, ascii_in_its_variants);
	tcase_add_test(tcase, ascii_that_is_broken);
	tcase_add_test(tcase, ascii_crosses_the_buffer);
	tcase_add_test(tcase, ascii_word_without_end);
	tcase_add_test(tcase, not_a_regular_file);
	tcase_add_test(tcase, mutilated_files);
	tcase_add_test(tcase, decimals_are_the_nearest);
	tcase_add_test(tcase, what_is_no_decimal);
	status = run_suite("stl", tcase);
	unlink(path_of(path, sizeof(path), "t.stl"));
	rmdir(folder);
	return status;
}
