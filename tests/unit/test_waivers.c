/* test_waivers.c - which findings a waivers file accepts, and which it does not. */
#include "base/units.h"
#include "machine/machine.h"
#include "machine/waivers.h"
#include "report/waiver_match.h"
#include "xml_case.h"

static const char machine_text[] =
	"<machine version='1'><base><axis name='X' type='linear' direction='1 0 0' rate_max='1'/>\n"
	"<axis name='C' type='rotary' direction='0 0 1' location='0 0 0' rate_max='1'/></base></machine>";

#define WAIVER(rest) "<waiver program='p.nc' kind='collision' a='head' b='bed' reason='r' " rest "/>\n"
#define WAIVERS(content) "<waivers version='1'>\n" content "</waivers>"

static struct machine *machine;
static struct waivers *waivers;
static struct waiver_match waiving;
static int matched[4];

static void start(void)
{
	struct diag diag = {0};

	enter_folder();
	write_text("m.xml", machine_text);
	machine = machine_load("m.xml", &diag);
	ck_assert_ptr_nonnull(machine);
	memset(matched, 0, sizeof(matched));
}

static void finish(void)
{
	waivers_free(waivers);
	waivers = NULL;
	machine_free(machine);
	leave_folder();
}

static void load(const char *content, const char *today)
{
	struct diag diag = {0};

	write_text("s.xml", content);
	waivers = waivers_load("s.xml", machine, &diag);
	ck_assert_ptr_nonnull(waivers);
	waiving.file = waivers;
	snprintf(waiving.today, sizeof(waiving.today), "%s", today);
}

static struct finding finding_at(double x, double degrees_c)
{
	struct finding f = {.kind = FINDING_COLLISION, .file = "p.nc", .text = "\tG1 X10\r\n",
			    .of.pair = {.a = "bed", .b = "head"}};

	f.axes.v[SLOT_X] = x;
	f.axes.v[SLOT_C] = radians(degrees_c);
	return f;
}

static const struct waiver *find(const struct finding *f)
{
	return waiver_match_find(&waiving, matched, machine, "p.nc", f);
}

static void assert_not_found(struct finding f)
{
	ck_assert_ptr_null(find(&f));
}

START_TEST(accepts_what_it_names_once)
{
	struct finding f = finding_at(10, -90);

	load(WAIVERS(WAIVER("block='G1 X10' axes='X 10.0000 mm, C -90.0000 deg' expires='2026-12-31'")), "2026-12-31");
	ck_assert_ptr_eq(find(&f), &waivers->items[0]);
	ck_assert(!waiver_match_is_expired(&waiving, &waivers->items[0]));
	/* The same finding again needs another waiver. */
	ck_assert_ptr_null(find(&f));
}
END_TEST

START_TEST(accepts_nothing_else)
{
	struct finding f = finding_at(10, -90);

	load(WAIVERS(WAIVER("block='G1 X10' axes='C-90 X10' expires='2026-12-31' times='9'")), "2026-01-01");
	f.kind = FINDING_CLEARANCE;
	assert_not_found(f);
	f = finding_at(10, -90);
	f.text = "G1 X10.";
	assert_not_found(f);
	f = finding_at(10, -90);
	f.of.pair.a = "table";
	assert_not_found(f);
	f.of.pair.a = "head";
	assert_not_found(f);
	f = finding_at(10, -90);
	f.kind = FINDING_LIMIT;
	f.of.limit = (struct travel_excess){.slot = SLOT_X};
	assert_not_found(f);
	f = finding_at(10, -90);
	ck_assert_ptr_null(waiver_match_find(&waiving, matched, machine, "dir/p.nc", &f));
	f.text = NULL;
	assert_not_found(f);
	ck_assert_int_eq(matched[0], 0);
}
END_TEST

/* Every axis within 0.01 mm or degrees, or the value of the waiver: not in radians, and not as a sum over the axes. */
START_TEST(stays_at_its_place)
{
	static const char text[] =
		WAIVERS(WAIVER("block='G1 X10' axes='X10C-90' expires='2026-12-31' times='100'")
			WAIVER("block='G1 X20' axes='X10C-90' expires='2026-12-31' times='100' within='0.5'"));
	struct finding f;

	load(text, "2026-01-01");
	f = finding_at(10.0099, -90.0099);
	ck_assert_ptr_eq(find(&f), &waivers->items[0]);
	assert_not_found(finding_at(10.0101, -90));
	assert_not_found(finding_at(10, -89.9899));
	assert_not_found(finding_at(10, 270));
	f = finding_at(10.5, -89.501);
	f.text = "G1 X20";
	ck_assert_ptr_eq(find(&f), &waivers->items[1]);
	f = finding_at(10.501, -90);
	f.text = "G1 X20";
	assert_not_found(f);
}
END_TEST

/* After its last day a waiver is still found, for the warning, but only if no other one matches. */
START_TEST(expires)
{
	struct finding f = finding_at(10, 0);

	load(WAIVERS(WAIVER("block='G1 X10' axes='X10C0' expires='2026-02-28'")
		     WAIVER("block='G1 X10' axes='X10C0' expires='2026-03-01'")), "2026-03-01");
	ck_assert_ptr_eq(find(&f), &waivers->items[1]);
	ck_assert(!waiver_match_is_expired(&waiving, &waivers->items[1]));
	ck_assert_ptr_eq(find(&f), &waivers->items[0]);
	ck_assert(waiver_match_is_expired(&waiving, &waivers->items[0]));
	ck_assert_ptr_null(find(&f));
}
END_TEST

START_TEST(knows_the_calendar)
{
	static const char *const good[] = {"2024-02-29", "2000-02-29", "2026-04-30", "9999-12-31"};
	static const char *const bad[] = {"2026-02-29", "1900-02-29", "2026-04-31", "2026-00-10", "2026-13-01",
					  "0000-01-01", "2026-1-1", "2026-01-01Z", "26-01-01",
					  "2026/01/01", "", "2026-01--1", "20-6-01-01"};
	char text[512];

	for (size_t i = 0; i < COUNT(good) + COUNT(bad); i++) {
		bool is_good = i < COUNT(good);
		const char *date = is_good ? good[i] : bad[i - COUNT(good)];
		struct diag diag = {0};
		struct waivers *read;

		snprintf(text, sizeof(text), WAIVERS(WAIVER("block='G1' axes='X0C0' expires='%s'")), date);
		write_text("s.xml", text);
		read = waivers_load("s.xml", machine, &diag);
		ck_assert_msg((read != NULL) == is_good, "%s", date);
		ck_assert((diag.errors > 0) == !is_good);
		waivers_free(read);
	}
}
END_TEST

START_TEST(counts_from_1_to_a_million)
{
	static const struct {
		const char *times;
		bool good;
	} cases[] = {{"0", false}, {"1", true}, {"1000000", true}, {"1000001", false}, {"4294967297", false}};
	char text[512];

	for (int i = 0; i < COUNT(cases); i++) {
		struct diag diag = {0};
		struct waivers *read;

		snprintf(text, sizeof(text), WAIVERS(WAIVER("block='G1' axes='X0C0' expires='2026-12-31' times='%s'")),
			 cases[i].times);
		write_text("s.xml", text);
		read = waivers_load("s.xml", machine, &diag);
		ck_assert_msg((read != NULL) == cases[i].good, "%s", cases[i].times);
		waivers_free(read);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("waivers");

	tcase_add_checked_fixture(tcase, start, finish);
	tcase_add_test(tcase, accepts_what_it_names_once);
	tcase_add_test(tcase, accepts_nothing_else);
	tcase_add_test(tcase, stays_at_its_place);
	tcase_add_test(tcase, expires);
	tcase_add_test(tcase, knows_the_calendar);
	tcase_add_test(tcase, counts_from_1_to_a_million);
	return run_suite("waivers", tcase);
}
