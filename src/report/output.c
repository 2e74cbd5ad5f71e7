/* For realpath and O_TMPFILE. */
#define _GNU_SOURCE

#include "report/output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/mem.h"

/* Bytes. Measured: a table of 34 MB needs a quarter of the system time that it needs with pieces of 4096 bytes. */
enum { BUFFER_SIZE = 1 << 18 };

/*
 * Opens a file without a name in the folder of `target`, so that an interrupted run leaves nothing behind. -1: the
 * system or the file system does not support this.
 */
static int open_nameless(const char *target, mode_t mode)
{
#ifdef O_TMPFILE
	const char *slash = strrchr(target, '/');
	struct strbuf folder = {0};
	int fd;

	if (slash)
		strbuf_add(&folder, target, (size_t)(slash - target) + 1);
	else
		strbuf_add(&folder, ".", 1);
	fd = open(folder.text, O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
	strbuf_release(&folder);
	return fd;
#else
	(void)target;
	(void)mode;
	return -1;
#endif
}

/* Gives the nameless file `fd` a name, or creates a file of that name if fd is -1. -1: see errno. */
static int make_named(const char *name, int fd, mode_t mode)
{
	char link[32];

	if (fd < 0)
		return open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
	snprintf(link, sizeof(link), "/proc/self/fd/%d", fd);
	return linkat(AT_FDCWD, link, AT_FDCWD, name, AT_SYMLINK_FOLLOW);
}

/* As make_named, with an unused name beside the target, which becomes out->temporary. */
static int name_beside(struct output *out, int fd, mode_t mode)
{
	struct strbuf name = {0};
	int result = -1;

	for (int attempt = 0; result < 0 && attempt < 100; attempt++) {
		strbuf_clear(&name);
		strbuf_addf(&name, "%s.new-%ld-%d", out->target, (long)getpid(), attempt);
		result = make_named(name.text, fd, mode);
		if (result < 0 && errno != EEXIST)
			break;
	}
	if (result >= 0)
		out->temporary = name.text;
	else
		strbuf_release(&name);
	return result;
}

/* Opens a new file beside the target, with the permissions of the target. */
static FILE *open_beside(struct output *out, mode_t mode)
{
	/* A nameless file gets its name through /proc. */
	int fd = access("/proc/self/fd", X_OK) ? -1 : open_nameless(out->target, mode);

	if (fd < 0)
		fd = name_beside(out, -1, mode);
	return fd < 0 ? NULL : fdopen(fd, "wb");
}

static bool open_file(struct output *out, const char *path)
{
	struct stat status;

	if (stat(path, &status)) {
		/* A dangling symbolic link: the file is created where the link points. */
		if (errno != ENOENT || !lstat(path, &status)) {
			out->file = fopen(path, "wb");
			return out->file != NULL;
		}
		out->target = strdup(path);
		status.st_mode = 0666;
	} else if (!S_ISREG(status.st_mode)) {
		out->file = fopen(path, "wb");
		return out->file != NULL;
	} else {
		if (access(path, W_OK))
			return false;
		out->target = realpath(path, NULL);
	}
	if (!out->target)
		return false;
	out->file = open_beside(out, status.st_mode & 0666);
	if (out->file) {
		out->buffer = mem_alloc(BUFFER_SIZE);
		setvbuf(out->file, out->buffer, _IOFBF, BUFFER_SIZE);
	}
	return out->file != NULL;
}

bool output_open(struct output *out, const char *path, struct diag *diag)
{
	*out = (struct output){.name = path ? path : "standard output"};
	if (!path) {
		out->file = stdout;
		return true;
	}
	if (open_file(out, path))
		return true;
	diag_error(diag, (struct srcloc){0}, "cannot write %s: %s", path, strerror(errno));
	free(out->target);
	*out = (struct output){0};
	return false;
}

static bool succeeded(struct output *out, bool good)
{
	if (!good && !out->error)
		out->error = errno ? errno : EIO;
	return !out->error;
}

bool output_write(struct output *out, const char *bytes, size_t count)
{
	errno = 0;
	return succeeded(out, fwrite(bytes, 1, count, out->file) == count);
}

bool output_text(struct output *out, struct strbuf *text)
{
	bool good = output_write(out, strbuf_text(text), text->length);

	strbuf_clear(text);
	return good;
}

bool output_flush(struct output *out)
{
	errno = 0;
	return succeeded(out, fflush(out->file) == 0);
}

static void release(struct output *out)
{
	free(out->target);
	free(out->temporary);
	free(out->buffer);
	*out = (struct output){0};
}

/* Standard output stays open for later output; closing a copy shows errors that only closing shows. */
static bool close_file(FILE *file)
{
	int copy;

	if (file != stdout)
		return fclose(file) == 0;
	copy = dup(STDOUT_FILENO);
	return copy >= 0 && close(copy) == 0;
}

bool output_commit(struct output *out, struct diag *diag)
{
	bool good = output_flush(out);

	errno = 0;
	if (out->target && !out->temporary && good)
		good = succeeded(out, name_beside(out, fileno(out->file), 0) >= 0);
	good = succeeded(out, close_file(out->file)) && good;
	if (out->temporary && good)
		good = succeeded(out, rename(out->temporary, out->target) == 0);
	if (out->temporary && !good)
		unlink(out->temporary);
	if (!good && out->error != EPIPE)
		diag_error(diag, (struct srcloc){0}, "cannot write %s: %s", out->name, strerror(out->error));
	release(out);
	return good;
}

void output_discard(struct output *out)
{
	if (!out->file)
		return;
	/* Standard output stays open: the caller owns it. */
	if (out->file == stdout)
		fflush(stdout);
	else
		fclose(out->file);
	if (out->temporary)
		unlink(out->temporary);
	release(out);
}

bool output_print(struct strbuf *text, struct diag *diag)
{
	struct output out;
	bool good = output_open(&out, NULL, diag);

	output_text(&out, text);
	good = output_commit(&out, diag) && good;
	strbuf_release(text);
	return good;
}
