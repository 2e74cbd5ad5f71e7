/* without_timeout.c - a unit test may take as long as a busy computer lets it: libcheck's limit of 4 s is switched off. */
#include <stdlib.h>

/* libcheck asks for the variable when a test case is created, which is after this. Who sets a limit keeps it. */
__attribute__((constructor)) static void switch_timeout_off(void)
{
	setenv("CK_DEFAULT_TIMEOUT", "0", 0);
}
