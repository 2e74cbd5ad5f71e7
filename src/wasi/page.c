/*
 * page.c - the functions that the host of the WebAssembly calls (src/web/app/fivecheck.js): the program itself, or a
 * machine that stays loaded. The words of each call come from the host, like those of main.
 *
 * This file replaces the start files of wasi-libc. With them every exported function would start and end the C library
 * again.
 */
#include <stdio.h>
#include <stdlib.h>
#include <wasi/api.h>

#include "cli/session.h"

#define EXPORT(name) __attribute__((export_name(name)))

/* One block contains the pointers and the texts; NULL: the host gave none. */
static char **words_of_host(int *count)
{
	size_t words, bytes;
	char **argv;

	if (__wasi_args_sizes_get(&words, &bytes))
		return NULL;
	argv = malloc((words + 1) * sizeof(*argv) + bytes);
	if (!argv)
		return NULL;
	if (__wasi_args_get((uint8_t **)argv, (uint8_t *)(argv + words + 1))) {
		free(argv);
		return NULL;
	}
	argv[words] = NULL;
	*count = (int)words;
	return argv;
}

/* Functions of wasi-libc and the linker. */
void __wasm_call_ctors(void);
int __main_void(void);

static int call(struct session *session, enum run_status (*carry_out)(struct session *, int, char **))
{
	enum run_status status = RUN_INTERNAL;
	int argc;
	char **argv = words_of_host(&argc);

	if (argv)
		status = carry_out(session, argc, argv);
	free(argv);
	fflush(NULL);
	return (int)status;
}

_Noreturn void _start(void);
EXPORT("session_new") struct session *page_session_new(void);
EXPORT("session_check") int page_session_check(struct session *session);
EXPORT("session_pose") int page_session_pose(struct session *session);

void _start(void)
{
	__wasm_call_ctors();
	exit(__main_void());
}

/* Call it once for each instance, before anything else. */
struct session *page_session_new(void)
{
	__wasm_call_ctors();
	return session_new();
}

int page_session_check(struct session *session)
{
	return call(session, session_check);
}

int page_session_pose(struct session *session)
{
	return call(session, session_pose);
}
