/* test_report.c - numbers, names and JSON of the reports, against a JSON parser and closed forms. */
#include <jansson.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/units.h"
#include "report/format/format_units.h"
#include "report/writers/ndjson.h"
#include "suite.h"

static void expect(struct strbuf *out, const char *text)
{
	ck_assert_str_eq(strbuf_text(out), text);
	strbuf_clear(out);
}

START_TEST(test_quantities)
{
	struct strbuf out = {0};

	format_units_add(&out, -0.00004);
	expect(&out, "0.0000");
	format_units_add(&out, -0.00006);
	expect(&out, "-0.0001");
	format_units_add(&out, 1234.56785);
	expect(&out, "1234.5678");
	format_units_add_duration(&out, 59.9);
	expect(&out, "59.900 s");
	format_units_add_duration(&out, 61.5);
	expect(&out, "1 min 01.500 s");
	format_units_add_duration(&out, 2 * 3600 + 3 * 60 + 4.25);
	expect(&out, "2 h 03 min 04.250 s");
	format_units_add_duration(&out, 59.9996);
	expect(&out, "1 min 00.000 s");
	format_units_add_duration(&out, 3599.9999);
	expect(&out, "1 h 00 min 00.000 s");
	format_units_add_plain(&out, " \tG0 X1\r\033[31m (\x7f) \r\n");
	expect(&out, "G0 X1  [31m ( )");
	format_units_add_plain(&out, " \r\n");
	expect(&out, "");
	strbuf_release(&out);
}
END_TEST

/* Is this UTF-8? Each sequence is decoded, and encoded again. */
static bool is_utf8(const unsigned char *s)
{
	while (*s) {
		uint32_t code;
		int more = *s < 0x80 ? 0 : *s < 0xc0 ? -1 : *s < 0xe0 ? 1 : *s < 0xf0 ? 2 : *s < 0xf8 ? 3 : -1;
		static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};

		if (more < 0)
			return false;
		code = more ? *s & (0x3fu >> more) : *s;
		for (int i = 1; i <= more; i++) {
			if (s[i] < 0x80 || s[i] > 0xbf)
				return false;
			code = code << 6 | (s[i] & 0x3fu);
		}
		if (code < least[more] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000))
			return false;
		s += more + 1;
	}
	return true;
}

static struct machine two_axes(void)
{
	struct machine machine = {.axis_count = 2};

	machine.axes[0] = (struct axis){.name = "C", .slot = SLOT_C, .rotary = true};
	machine.axes[1] = (struct axis){.name = "X", .slot = SLOT_X};
	return machine;
}

/* For a name with any bytes the line can be parsed, and a name in UTF-8 comes back unchanged. */
START_TEST(test_names)
{
	struct machine machine = two_axes();
	struct finding finding = {.kind = FINDING_COLLISION, .of.pair = {.a = "a", .b = "b"}, .line = 1, .column = 1};
	struct strbuf out = {0};
	int kept = 0;

	srand(5);
	for (int run = 0; run < 20000; run++) {
		char name[8] = "";
		json_t *object;
		const char *read;

		for (int i = 0; i < 4; i++)
			name[i] = (char)(rand() % 3 ? 0x80 + rand() % 0x80 : 1 + rand() % 0x7f);
		finding.file = name;
		ndjson_finding(&out, &machine, &finding, (struct finding_style){0});
		ck_assert_ptr_eq(strchr(out.text, '\n'), out.text + out.length - 1);
		object = json_loads(out.text, 0, NULL);
		ck_assert_ptr_nonnull(object);
		read = json_string_value(json_object_get(object, "file"));
		if (is_utf8((const unsigned char *)name)) {
			ck_assert_str_eq(read, name);
			kept++;
		} else {
			ck_assert_ptr_nonnull(strstr(read, "\xef\xbf\xbd"));
		}
		json_decref(object);
		strbuf_clear(&out);
	}
	ck_assert_int_gt(kept, 500);
	strbuf_release(&out);
}
END_TEST

static double number(const json_t *object, const char *key)
{
	const json_t *value = json_object_get(object, key);

	ck_assert_msg(json_is_number(value), "%s", key);
	return json_number_value(value);
}

START_TEST(test_finding)
{
	struct machine machine = two_axes();
	struct finding finding = {
		.kind = FINDING_CLEARANCE, .file = "p.nc", .line = 118, .column = 1, .move = 2, .moves = 3,
		.fraction = 1.0 / 3, .time = 12345.678912,
		.of.pair = {.a = "head", .b = "table", .point = {1e-7, -0.0, 98765.4321012},
			    .clearance = 0.123456789012, .required = 1},
	};
	struct strbuf out = {0};
	json_t *object, *point;

	finding.axes.v[SLOT_X] = -123.456789012;
	finding.axes.v[SLOT_C] = radians(33.3333333333);
	ndjson_finding(&out, &machine, &finding, (struct finding_style){0});
	object = json_loads(out.text, JSON_REJECT_DUPLICATES, NULL);
	ck_assert_ptr_nonnull(object);
	ck_assert_uint_eq(json_object_size(object), 13);
	ck_assert_str_eq(json_string_value(json_object_get(object, "kind")), "clearance");
	ck_assert_double_eq_tol(number(object, "line"), 118, 1e-12);
	ck_assert_double_eq_tol(number(object, "fraction"), 1.0 / 3, 1e-11);
	ck_assert_double_eq_tol(number(object, "time"), 12345.678912, 1e-6);
	ck_assert_double_eq_tol(number(object, "clearance"), 0.123456789012, 1e-12);
	ck_assert_double_eq_tol(number(json_object_get(object, "axes"), "X"), -123.456789012, 1e-9);
	ck_assert_double_eq_tol(number(json_object_get(object, "axes"), "C"), 33.3333333333, 1e-9);
	point = json_object_get(object, "point");
	ck_assert_uint_eq(json_array_size(point), 3);
	ck_assert_double_eq_tol(json_number_value(json_array_get(point, 2)), 98765.4321012, 1e-6);
	/* X before C, in whatever order the file has them. */
	ck_assert_ptr_nonnull(strstr(out.text, "\"axes\":{\"X\":"));
	ck_assert_ptr_null(strstr(out.text, "-0.0,"));
	json_decref(object);
	strbuf_release(&out);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("report");

	tcase_add_test(tests, test_quantities);
	tcase_add_test(tests, test_names);
	tcase_add_test(tests, test_finding);
	return run_suite("report", tests);
}
