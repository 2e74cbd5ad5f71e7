/* test_digesting.c - digests of the files of a run equal the examples of FIPS 180-4 with any number of threads. */
#include "cli/digesting.h"

#include <string.h>

#include "xml_case.h"

enum { MILLION = 1000000 };

static const struct {
	const char *name, *digest;
} files[] = {
	{"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
	{"empty", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
	{"million", "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
	{"none", ""},
};

static void write_files(void)
{
	struct strbuf text = {0};

	for (int i = 0; i < MILLION; i++)
		strbuf_add(&text, "a", 1);
	write_text(files[0].name, "abc");
	write_text(files[1].name, "");
	write_text(files[2].name, strbuf_text(&text));
	strbuf_release(&text);
}

static void remove_files(void)
{
	for (int i = 0; i < COUNT(files); i++)
		unlink(files[i].name);
}

static void add_files(struct input_files *inputs)
{
	input_files_init(inputs);
	for (int i = 0; i < COUNT(files); i++)
		inputs->opened.call(inputs->opened.context, files[i].name);
}

START_TEST(each_file_has_its_digest)
{
	write_files();
	for (int threads = 1; threads < 9; threads++) {
		struct digesting digesting = {0};
		struct input_files inputs;

		add_files(&inputs);
		digesting_begin(&digesting, &inputs, threads);
		digesting_finish(&digesting);
		for (int i = 0; i < COUNT(files); i++)
			ck_assert_str_eq(inputs.items[i].digest, files[i].digest);
		digesting_end(&digesting);
		input_files_release(&inputs);
	}
	remove_files();
}
END_TEST

/* A file that was not read to its end gets no digest. */
START_TEST(what_is_given_up_has_no_digest)
{
	write_files();
	for (int threads = 1; threads < 3; threads++) {
		struct digesting digesting = {0};
		struct input_files inputs;

		add_files(&inputs);
		digesting_begin(&digesting, &inputs, threads);
		digesting_end(&digesting);
		for (int i = 0; i < COUNT(files); i++)
			ck_assert(!inputs.items[i].digest[0] || !strcmp(inputs.items[i].digest, files[i].digest));
		input_files_release(&inputs);
	}
	remove_files();
}
END_TEST

START_TEST(nothing_to_do_is_done)
{
	struct digesting digesting = {0};

	digesting_finish(&digesting);
	digesting_end(&digesting);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("digesting");

	tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
	tcase_add_test(tcase, each_file_has_its_digest);
	tcase_add_test(tcase, what_is_given_up_has_no_digest);
	tcase_add_test(tcase, nothing_to_do_is_done);
	return run_suite("digesting", tcase);
}
