/* test_machine_hostile.c - files that are no machine files, or are too large, too deep, foreign or damaged. */
#include <sys/stat.h>

#include "base/mem.h"
#include "machine_case.h"

START_TEST(refuses_what_is_no_file)
{
	assert_refused("none.xml", "none.xml: error: cannot open: No such file or directory\n");
	assert_refused("-", "-: error: XML files are not read from standard input: name a file\n");
	assert_refused("/", "/: error: is a directory, not an XML file\n");
	assert_refused("/dev/null", "/dev/null: error: is not a regular file\n");
	ck_assert_int_eq(mkfifo("fifo", 0600), 0);
	assert_refused("fifo", "fifo: error: is not a regular file\n");
}
END_TEST

START_TEST(refuses_giants)
{
	size_t size = 4 * 1024 * 1024 + 1;
	char *bytes = mem_alloc(size);

	memset(bytes, ' ', size);
	write_bytes("m.xml", bytes, size);
	assert_refused("m.xml", "m.xml: error: larger than 4 MiB: this is not a machine, setup or waivers file\n");
	memcpy(bytes, "<machine version='1' name='", 27);
	memset(bytes + 27, 'x', size - 28);
	memcpy(bytes + size - 31, "'><base/></machine>", 19);
	write_bytes("m.xml", bytes, size - 12);
	assert_refused("m.xml",
		       "m.xml:1: error: name=\"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
		       "xxxxxxxxxxxxxxxx...\" of <machine> is too long\n");
	free(bytes);
}
END_TEST

START_TEST(refuses_foreign_bytes)
{
	static const char utf16[] = "\xff\xfe<\0m\0a\0c\0h\0i\0n\0e\0/\0>";
	static const char ebcdic[] = "\x4c\x6f\xa7\x94\x93";

	write_bytes("m.xml", utf16, sizeof(utf16));
	assert_refused("m.xml", "m.xml: error: this file is in UTF-16: save it as UTF-8 (a text editor does)\n");
	write_bytes("m.xml", "<m\0/>", 5);
	assert_refused("m.xml", "m.xml: error: the file has NUL bytes: it is not text, or not UTF-8\n");
	write_text("m.xml", ebcdic);
	assert_refused("m.xml", "m.xml:1: error: this is not XML: it does not start with '<'\n");
}
END_TEST

/* Each of these files once kept a parser or validator busy for minutes. */
START_TEST(refuses_quickly)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<?xml version='1.0'?>\n<!-- <x '> --><machine version='1'></x '>\n<x");
	for (int i = 0; i < 250000; i++)
		strbuf_addf(&text, " a%d=''", i);
	strbuf_addf(&text, "><base/></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:3: error: this tag has more than 1000 attributes\n");
	strbuf_clear(&text);
	strbuf_addf(&text, "<machine version='1'><base/><setup>");
	for (int i = 0; i < 120000; i++)
		strbuf_addf(&text, "<offset number='1' length='1'/>");
	strbuf_addf(&text, "</setup></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: <setup> has more than 20000 elements\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(refuses_depth)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 100; i++)
		strbuf_addf(&text, AXIS_X ">");
	for (int i = 0; i < 100; i++)
		strbuf_addf(&text, "</axis>");
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: elements are nested deeper than 64 levels\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(refuses_crowds)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 4097; i++)
		strbuf_addf(&text, "<body name='b%d' mesh='b'/>", i);
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	assert_refused("m.xml", "m.xml:1: error: there are 4097 bodies; more than 4096 are not supported\n");
	strbuf_release(&text);
}
END_TEST

START_TEST(stops_telling_after_twenty)
{
	struct strbuf text = {0};
	struct messages messages;
	size_t lines = 0;

	strbuf_addf(&text, "<machine version='1'><base>");
	for (int i = 0; i < 50; i++)
		strbuf_addf(&text, "<bdy/>");
	strbuf_addf(&text, "</base></machine>");
	write_text("m.xml", strbuf_text(&text));
	messages_init(&messages);
	ck_assert_ptr_null(machine_load("m.xml", &messages.diag));
	ck_assert_uint_eq(messages.diag.errors, 20);
	for (const char *at = strbuf_text(&messages.text); *at; at++)
		lines += *at == '\n';
	ck_assert_uint_eq(lines, 21);
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&messages.text), "m.xml: note: more than 20 errors; the others are not listed\n"));
	strbuf_release(&messages.text);
	strbuf_release(&text);
}
END_TEST

/* A file that is cut anywhere, or in which a byte is replaced, is read or refused; nothing else happens. */
START_TEST(survives_damage)
{
	static const char replacements[] = {'<', '>', '"', '\'', '&', '\0', ' ', '9', (char)0xff};
	char damaged[sizeof(trunnion)];
	size_t length = sizeof(trunnion) - 1;
	struct diag diag = {0};

	/* Without its last newline the file is still complete. */
	for (size_t i = 0; i < length - 1; i++) {
		write_bytes("m.xml", trunnion, i);
		ck_assert_ptr_null(machine_load("m.xml", &diag));
	}
	for (size_t i = 0; i < length; i++) {
		memcpy(damaged, trunnion, sizeof(trunnion));
		damaged[i] = replacements[i % sizeof(replacements)];
		write_bytes("m.xml", damaged, length);
		machine_free(machine_load("m.xml", &diag));
	}
	ck_assert_uint_gt(diag.errors, length);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("machine_hostile");

	tcase_add_test(tcase, refuses_what_is_no_file);
	tcase_add_test(tcase, refuses_giants);
	tcase_add_test(tcase, refuses_foreign_bytes);
	tcase_add_test(tcase, refuses_quickly);
	tcase_add_test(tcase, refuses_depth);
	tcase_add_test(tcase, refuses_crowds);
	tcase_add_test(tcase, stops_telling_after_twenty);
	tcase_add_test(tcase, survives_damage);
	return run_in_folders("machine_hostile", tcase);
}
