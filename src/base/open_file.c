#include "base/open_file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

FILE *open_file(const char *path, struct diag *diag)
{
	const struct srcloc place = {path, 0, 0};
	FILE *file = fopen(path, "rb");
	struct stat status;

	if (!file) {
		diag_error(diag, place, "cannot open: %s", strerror(errno));
		return NULL;
	}
	if (fstat(fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
		diag_error(diag, place, "is a directory, not a file");
		fclose(file);
		return NULL;
	}
	return file;
}
