/*
 * without_timeout.c - a unit test may take as long as it needs on a busy computer: libcheck's limit of 4 s is switched
 * off.
 */
#include <stdlib.h>

/* libcheck reads the variable when a test case is created, which is later. A limit that the user has set stays. */
__attribute__((constructor)) static void switch_timeout_off(void)
{
	setenv("CK_DEFAULT_TIMEOUT", "0", 0);
}
