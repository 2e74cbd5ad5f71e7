#include "machine/library/json_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/file_bytes.h"
#include "base/mem.h"

json_t *json_file_read(const char *path, struct diag *diag)
{
	struct file_bytes file;
	json_error_t error;
	json_t *root;
	size_t mark;

	if (!file_bytes_read(&file, path, diag))
		return NULL;
	/* When memory runs out the program ends, as everywhere. */
	json_set_alloc_funcs(mem_alloc, free);
	/* The file may begin with a byte order mark. */
	mark = file.count >= 3 && !memcmp(file.bytes, "\xef\xbb\xbf", 3) ? 3 : 0;
	root = json_loadb(file.bytes + mark, file.count - mark, JSON_REJECT_DUPLICATES, &error);
	file_bytes_release(&file);
	if (!root)
		diag_error(diag, (struct srcloc){.file = path, .line = error.line, .column = error.column},
			   "this is not valid JSON: %s", error.text);
	return root;
}

bool json_file_number(const json_t *object, const char *name, double *value)
{
	const json_t *at = json_object_get(object, name);

	if (!at || json_is_null(at))
		return true;
	if (!json_is_number(at) || !isfinite(json_number_value(at)))
		return false;
	*value = json_number_value(at);
	return true;
}
