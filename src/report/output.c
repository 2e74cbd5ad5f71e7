/* For realpath. */
#define _XOPEN_SOURCE 700

#include "report/output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A new file beside the target, with the permissions that a file written in place would have. */
static FILE *open_beside(struct output *out, mode_t mode)
{
	struct strbuf name = {0};
	FILE *file = NULL;
	int fd = -1;

	for (int attempt = 0; fd < 0 && attempt < 100; attempt++) {
		strbuf_clear(&name);
		strbuf_addf(&name, "%s.new-%ld-%d", out->target, (long)getpid(), attempt);
		fd = open(name.text, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
		if (fd < 0 && errno != EEXIST)
			break;
	}
	if (fd >= 0)
		file = fdopen(fd, "wb");
	if (file)
		out->temporary = name.text;
	else
		strbuf_release(&name);
	return file;
}

static bool open_file(struct output *out, const char *path)
{
	struct stat status;

	if (stat(path, &status)) {
		/* Through a link that leads nowhere the file is made where it leads to. */
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
	*out = (struct output){0};
}

bool output_commit(struct output *out, struct diag *diag)
{
	bool good = output_flush(out);

	errno = 0;
	good = succeeded(out, fclose(out->file) == 0) && good;
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
	/* Standard output stays open: it is not ours, and what was written may be read. */
	if (out->file == stdout)
		fflush(stdout);
	else
		fclose(out->file);
	if (out->temporary)
		unlink(out->temporary);
	release(out);
}
