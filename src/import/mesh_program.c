#include "import/mesh_program.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/strbuf.h"

static const char program[] = "fivecheck-mesh";

#ifndef __has_feature
#define __has_feature(name) 0
#endif

/*
 * Bytes of memory, and seconds of processor time: more than any model of a machine needs. Sanitizers reserve terabytes
 * of addresses, most of which they do not use.
 */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_feature(address_sanitizer)
#define MEMORY_MAX RLIM_INFINITY
#else
#define MEMORY_MAX ((rlim_t)4 << 30)
#endif
enum { SECONDS_MAX = 60 };

/* The program is beside this one (in a build), in libexec beside its folder, or found like a command. */
static void find_program(struct strbuf *name)
{
	static const char *const folders[] = {"", "../libexec/fivecheck/"};
	char own[4096];
	ssize_t length = readlink("/proc/self/exe", own, sizeof(own) - 1);
	char *slash;

	own[length > 0 ? length : 0] = '\0';
	slash = strrchr(own, '/');
	for (size_t i = 0; slash && i < sizeof(folders) / sizeof(*folders); i++) {
		strbuf_addf(name, "%.*s/%s%s", (int)(slash - own), own, folders[i], program);
		if (access(strbuf_text(name), X_OK) == 0)
			return;
		strbuf_clear(name);
	}
	strbuf_addf(name, "%s", program);
}

static void limit(int resource, rlim_t most)
{
	const struct rlimit both = {most, most};

	setrlimit(resource, &both);
}

/* In the child process, which writes only into the pipe. */
static _Noreturn void run(const char *name, const char *path, int out)
{
	char *const arguments[] = {(char *)name, (char *)path, NULL};
	int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);

	limit(RLIMIT_AS, MEMORY_MAX);
	limit(RLIMIT_CPU, SECONDS_MAX);
	limit(RLIMIT_FSIZE, 0);
	limit(RLIMIT_CORE, 0);
	if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(nothing, STDERR_FILENO) >= 0 &&
	    dup2(out, STDOUT_FILENO) >= 0)
		execvp(name, arguments);
	_exit(127);
}

/* The read end of the pipe that the program writes to, or NULL. */
static FILE *start(const char *name, const char *path, pid_t *child)
{
	FILE *in = NULL;
	int ends[2];

	if (pipe(ends) != 0)
		return NULL;
	fcntl(ends[0], F_SETFD, FD_CLOEXEC);
	fcntl(ends[1], F_SETFD, FD_CLOEXEC);
	*child = fork();
	if (*child == 0)
		run(name, path, ends[1]);
	close(ends[1]);
	if (*child > 0)
		in = fdopen(ends[0], "rb");
	if (!in)
		close(ends[0]);
	return in;
}

/* A closed pipe ends a program that still writes. */
void mesh_program_end(struct mesh_program *running)
{
	if (running->out)
		fclose(running->out);
	while (running->child > 0 && waitpid((pid_t)running->child, NULL, 0) < 0 && errno == EINTR)
		;
	*running = (struct mesh_program){0};
}

bool mesh_program_start(struct mesh_program *running, const char *path)
{
	struct strbuf name = {0};
	pid_t child = -1;

	find_program(&name);
	*running = (struct mesh_program){.out = start(strbuf_text(&name), path, &child)};
	running->child = child;
	strbuf_release(&name);
	if (running->out)
		return true;
	mesh_program_end(running);
	return false;
}
