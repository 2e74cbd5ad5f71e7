#define _DEFAULT_SOURCE
#include "job.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "query.h"
#include "request.h"
#include "safe_path.h"
#include "time_limit.h"

#define DEFAULT_PROGRAM "/usr/bin/fivecheck"

enum { OUTPUT_MB = 32, MEMORY_MB = 2048 };

static void limit(int what, long most)
{
	const struct rlimit both = {(rlim_t)most, (rlim_t)most};

	if (setrlimit(what, &both))
		_exit(127);
}

static void limit_child(long seconds)
{
	limit(RLIMIT_CPU, seconds);
	limit(RLIMIT_AS, (long)MEMORY_MB << 20);
	limit(RLIMIT_FSIZE, (long)OUTPUT_MB << 20);
	limit(RLIMIT_NOFILE, 256);
	/* No further process or thread: the user of the server has more already. */
	limit(RLIMIT_NPROC, 1);
	limit(RLIMIT_CORE, 0);
}

static void run_child(const struct query *query, long seconds, int output)
{
	char locale[] = "LC_ALL=C", path[] = "PATH=/usr/bin:/bin";
	char *const environment[] = {locale, path, NULL};
	const char *program = getenv("FIVECHECK") ? getenv("FIVECHECK") : DEFAULT_PROGRAM;
	char setup[PATH_LENGTH + 16], clearance[64], dialect[64];
	const char *argv[PROGRAMS_MAX + 16];
	int count = 0, nothing = open("/dev/null", O_RDONLY);

	argv[count++] = "fivecheck";
	argv[count++] = "--input-root=.";
	argv[count++] = "--progress=none";
	argv[count++] = "-j1";
	argv[count++] = query->ndjson ? "--format=ndjson" : "--format=text";
	if (query->all)
		argv[count++] = "--all";
	if (query->setup && snprintf(setup, sizeof(setup), "--setup=%s", query->setup) > 0)
		argv[count++] = setup;
	if (query->clearance && snprintf(clearance, sizeof(clearance), "--clearance=%s", query->clearance) > 0)
		argv[count++] = clearance;
	if (query->dialect && snprintf(dialect, sizeof(dialect), "--dialect=%s", query->dialect) > 0)
		argv[count++] = dialect;
	argv[count++] = "--";
	argv[count++] = query->machine;
	for (int i = 0; i < query->program_count; i++)
		argv[count++] = query->programs[i];
	argv[count] = NULL;
	setpgid(0, 0);
	limit_child(seconds);
	if (nothing < 0 || dup2(nothing, 0) < 0 || dup2(output, 1) < 0 || dup2(output, 2) < 0)
		_exit(127);
	execve(program, (char *const *)argv, environment);
	_exit(127);
}

int job_run(const struct query *query, long seconds, int output, struct request *request)
{
	int status;
	pid_t pid = fork();

	if (pid < 0)
		request_refuse(request, "503 Service Unavailable", "no process could be started; try again");
	if (pid == 0)
		run_child(query, seconds, output);
	setpgid(pid, pid);
	time_limit_kills(pid);
	/* A job that waits for something it will not get uses no processor time. */
	time_limit_set((unsigned)(2 * seconds));
	while (waitpid(pid, &status, 0) < 0) {
		if (errno != EINTR)
			request_refuse(request, "500 Internal Server Error", "the checker was lost");
	}
	time_limit_kills(0);
	time_limit_set(0);
	return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
