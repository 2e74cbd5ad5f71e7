/*
 * test_path_sandbox.c - what is inside a folder, and that nothing else is opened while links and folders are exchanged.
 */
#include "base/path_sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "suite.h"

#define OPENINGS 20000

static char folder[] = "/tmp/test_path_sandbox.XXXXXX";

static void write_file(const char *path, const char *text)
{
	FILE *file = fopen(path, "w");

	ck_assert_ptr_nonnull(file);
	fputs(text, file);
	fclose(file);
}

/* in/f, in/d/f and in/up, a link to d/f, contain "i"; out/f, out/d/f and the targets of the other links contain "o". */
static void set_up(void)
{
	ck_assert_ptr_nonnull(mkdtemp(folder));
	ck_assert_int_eq(chdir(folder), 0);
	ck_assert(!mkdir("in", 0700) && !mkdir("in/d", 0700) && !mkdir("out", 0700) && !mkdir("out/d", 0700));
	write_file("in/f", "i");
	write_file("in/d/f", "i");
	write_file("out/f", "o");
	write_file("out/d/f", "o");
	ck_assert(!symlink("d/f", "in/within") && !symlink("../out/f", "in/file") && !symlink("../out/d", "in/folder") &&
		  !symlink("loop", "in/loop") && !symlink("../in/d/../f", "out/back") && !symlink("in", "root"));
}

static void tear_down(void)
{
	char command[64];

	snprintf(command, sizeof(command), "rm -rf %s", folder);
	ck_assert_int_eq(system(command), 0); /* NOLINT: the name is ours */
}

/* The first byte of the opened file, or '!' for a file outside, '?' for another error. */
static char first_byte(const char *root, const char *path)
{
	int fd = path_sandbox_open(root, path);
	char byte = '-';

	if (fd < 0)
		return errno == EXDEV ? '!' : '?';
	if (read(fd, &byte, 1) < 0)
		byte = errno == EISDIR ? '/' : '-';
	close(fd);
	return byte;
}

START_TEST(only_what_is_inside)
{
	static const struct {
		const char *root, *path;
		char byte;
	} cases[] = {
		{"in", "in/f", 'i'},
		{"in", "in/d/f", 'i'},
		{"in", "in/within", 'i'},
		{"in", "in/d/../f", 'i'},
		{"in/", "./in//d/../../in/f", 'i'},
		{"root", "in/f", 'i'},
		{"in", "root/d/f", 'i'},
		{"in", "out/back", 'i'},
		{"/", "in/f", 'i'},
		{".", "out/f", 'o'},
		{NULL, "in/file", 'o'},
		{"in", "in/file", '!'},
		{"in", "in/folder/f", '!'},
		{"in", "in/../out/f", '!'},
		{"in", "out/f", '!'},
		{"in", "in", '/'},
		{"in/d", "in/f", '!'},
		{"in", "in/none", '?'},
		{"in", "in/loop", '?'},
		{"none", "in/f", '?'},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		ck_assert_msg(first_byte(cases[i].root, cases[i].path) == cases[i].byte, "case %zu: %s below %s", i,
			      cases[i].path, cases[i].root ? cases[i].root : "nothing");
		if (cases[i].byte != '?')
			ck_assert_int_eq(path_sandbox_holds(cases[i].root, cases[i].path), cases[i].byte != '!');
	}
}
END_TEST

/* Makes the name a folder and a link that leads out, in turns. */
static void *exchange(void *context)
{
	atomic_bool *over = context;

	while (!*over) {
		if (rename("in/d", "in/real") || symlink("../out/d", "in/d") || unlink("in/d") || rename("in/real", "in/d"))
			return context;
	}
	return NULL;
}

START_TEST(never_outside_while_links_are_exchanged)
{
	atomic_bool over = false;
	long inside = 0, outside = 0;
	pthread_t other;
	void *failed;

	ck_assert_int_eq(pthread_create(&other, NULL, exchange, &over), 0);
	for (long n = 0; n < OPENINGS || (n < 100 * OPENINGS && (!inside || !outside)); n++) {
		char byte = first_byte("in", "in/d/f");

		ck_assert_int_ne(byte, 'o');
		inside += byte == 'i';
		outside += byte == '!';
	}
	over = true;
	pthread_join(other, &failed);
	ck_assert_ptr_null(failed);
	/* Otherwise nothing was tested. */
	ck_assert_int_gt(inside, 0);
	ck_assert_int_gt(outside, 0);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("path_sandbox");

	tcase_add_unchecked_fixture(tests, set_up, tear_down);
	tcase_add_test(tests, only_what_is_inside);
	tcase_add_test(tests, never_outside_while_links_are_exchanged);
	return run_suite("path_sandbox", tests);
}
