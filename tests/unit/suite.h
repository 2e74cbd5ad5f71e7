/* suite.h - libcheck, and how the main function of a unit test runs its one suite. */
#ifndef SUITE_H
#define SUITE_H

#include <check.h>
#include <stdlib.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

/* Runs the tests of one case, which is freed with the suite. Returns the exit status of the test program. */
static inline int run_suite(const char *name, TCase *tcase)
{
	Suite *suite = suite_create(name);
	SRunner *runner = srunner_create(suite);
	int failed;

	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* The same of an array of tests that run once each. */
#define RUN_TESTS(name, tests) run_tests(name, tests, COUNT(tests))

static inline int run_tests(const char *name, const TTest *const tests[], int count)
{
	TCase *tcase = tcase_create(name);

	for (int i = 0; i < count; i++)
		tcase_add_test(tcase, tests[i]);
	return run_suite(name, tcase);
}

#endif
