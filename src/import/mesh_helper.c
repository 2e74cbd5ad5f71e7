#include "import/mesh_helper.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifndef __wasi__
#include <sys/resource.h>
#include <sys/wait.h>
#endif

#include "base/mem.h"
#include "base/strbuf.h"

static const char program[] = "fivecheck-mesh";

void mesh_parts_release(struct mesh_parts *parts)
{
	for (size_t i = 0; i < parts->count; i++)
		mesh_build_discard(&parts->items[i].build);
	free(parts->items);
	*parts = (struct mesh_parts){0};
}

static bool fault(struct diag *diag, const char *path, const char *what)
{
	diag_error(diag, (struct srcloc){.file = path}, "%s", what);
	return false;
}

/* ------------------------------------------------------------- triangles */

/* What is not finite, or too far away, is refused by mesh_build. */
static bool read_triangle(FILE *in, bool y_up, vec3 corners[3])
{
	unsigned char bytes[36];
	float v[9];

	if (fread(bytes, 1, sizeof(bytes), in) != sizeof(bytes))
		return false;
	for (int i = 0; i < 9; i++) {
		uint32_t bits = 0;

		for (int k = 0; k < 4; k++)
			bits |= (uint32_t)bytes[4 * i + k] << (8 * k);
		memcpy(&v[i], &bits, sizeof(bits));
	}
	for (int i = 0; i < 3; i++) {
		const float *p = &v[3 * i];

		corners[i] = y_up ? (vec3){p[0], -(double)p[2], p[1]} : (vec3){p[0], p[1], p[2]};
	}
	return true;
}

static bool read_part(struct mesh_parts *parts, const char *line, FILE *in, double scale, bool y_up)
{
	struct mesh_part part = {.build = {.scale = scale}};
	char *rest;
	unsigned long count = strtoul(line, &rest, 10);
	vec3 corners[3];
	bool good = true;

	rest += *rest == ' ';
	snprintf(part.name, sizeof(part.name), "%.*s", (int)strcspn(rest, "\n"), rest);
	for (unsigned long i = 0; good && i < count; i++)
		good = read_triangle(in, y_up, corners) && mesh_build_add(&part.build, corners);
	if (!good) {
		mesh_build_discard(&part.build);
		return false;
	}
	parts->items = mem_grow(parts->items, &parts->capacity, parts->count + 1, sizeof(part));
	parts->items[parts->count++] = part;
	return true;
}

/* What the program prints (src/mesh/main.c). */
static bool read_output(struct mesh_parts *parts, const char *path, FILE *in, double scale, bool y_up,
			struct diag *diag)
{
	char line[512];

	while (fgets(line, sizeof(line), in)) {
		line[strcspn(line, "\n")] = '\0';
		if (!strcmp(line, "end"))
			return parts->count > 0 || fault(diag, path, "the file has no triangles");
		if (!strncmp(line, "fault ", 6)) {
			diag_error(diag, (struct srcloc){.file = path}, "the file cannot be read: %s", line + 6);
			return false;
		}
		if (strncmp(line, "mesh ", 5) != 0 || !read_part(parts, line + 5, in, scale, y_up))
			return fault(diag, path, "a triangle is missing, not finite, or beyond 10 km");
	}
	return fault(diag, path,
		     "the meshes cannot be read: fivecheck-mesh is not installed (it is built where libassimp is), or "
		     "it gave up on a broken or very large file; convert the file to STL with another program");
}

#ifdef __wasi__
bool mesh_helper_read(struct mesh_parts *parts, const char *path, double scale, bool y_up, struct diag *diag)
{
	(void)parts;
	(void)scale;
	(void)y_up;
	(void)read_output;
	return fault(diag, path, "meshes of this format cannot be read here: convert the file to STL");
}
#else
/* ---------------------------------------------------------------- process */

#ifndef __has_feature
#define __has_feature(name) 0
#endif

/*
 * Bytes of memory, and seconds of processor time: more than any model of a machine takes. Sanitizers reserve terabytes
 * of addresses, of which they use little.
 */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_feature(address_sanitizer)
#define MEMORY_MAX RLIM_INFINITY
#else
#define MEMORY_MAX ((rlim_t)4 << 30)
#endif
enum { SECONDS_MAX = 60 };

/* The program stands beside this one (in a build), in libexec beside its folder, or is found as commands are. */
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

/* In the child; it writes into the pipe and nowhere else. */
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

/* The end of a pipe that the program writes to, or NULL. */
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

bool mesh_helper_read(struct mesh_parts *parts, const char *path, double scale, bool y_up, struct diag *diag)
{
	struct strbuf name = {0};
	pid_t child = -1;
	FILE *in;
	bool good = false;

	find_program(&name);
	in = start(strbuf_text(&name), path, &child);
	if (in)
		good = read_output(parts, path, in, scale, y_up, diag);
	else
		fault(diag, path, "cannot start fivecheck-mesh");
	/* A closed pipe ends a program that still writes. */
	if (in)
		fclose(in);
	while (child > 0 && waitpid(child, NULL, 0) < 0 && errno == EINTR)
		;
	strbuf_release(&name);
	return good;
}
#endif
