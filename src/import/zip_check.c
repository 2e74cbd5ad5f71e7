#include "import/zip_check.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/file_bytes.h"

/* Sizes of the records that list the files of an archive (APPNOTE.TXT of PKWARE, 4.3.12 and 4.3.16), without names. */
enum { ENTRY_SIZE = 46, END_SIZE = 22 };

static uint32_t number_at(const char *bytes, int count)
{
	uint32_t number = 0;

	while (count-- > 0)
		number = number << 8 | (unsigned char)bytes[count];
	return number;
}

/* The last record of the archive; NULL: there is none. Only a comment may follow it. */
static const char *find_end(const struct file_bytes *file)
{
	for (size_t back = END_SIZE; back <= file->count && back <= END_SIZE + UINT16_MAX; back++)
		if (!memcmp(file->bytes + file->count - back, "PK\005\006", 4))
			return file->bytes + file->count - back;
	return NULL;
}

/* The sum of the sizes of the files, in bytes. False: the list of files is faulty. */
static bool add_up(const struct file_bytes *file, const char *end, uint64_t *total)
{
	const uint32_t count = number_at(end + 10, 2), offset = number_at(end + 16, 4);
	const char *at = file->bytes + offset;

	*total = 0;
	if (offset > (size_t)(end - file->bytes))
		return false;
	for (uint32_t i = 0; i < count; i++) {
		uint32_t more;

		if (end - at < ENTRY_SIZE || memcmp(at, "PK\001\002", 4) != 0)
			return false;
		*total += number_at(at + 24, 4);
		more = number_at(at + 28, 2) + number_at(at + 30, 2) + number_at(at + 32, 2);
		if (end - at - ENTRY_SIZE < (ptrdiff_t)more)
			return false;
		at += ENTRY_SIZE + more;
	}
	return true;
}

bool zip_check(const char *path, struct diag *diag)
{
	struct file_bytes file;
	const char *end;
	uint64_t total = 0;
	bool whole;

	if (!file_bytes_read(&file, path, diag))
		return false;
	end = find_end(&file);
	whole = end && add_up(&file, end, &total);
	file_bytes_release(&file);
	if (!whole)
		diag_error(diag, (struct srcloc){.file = path},
			   "this is not a complete zip archive, which a 3MF file must be");
	else if (total > FILE_BYTES_MAX)
		diag_error(diag, (struct srcloc){.file = path}, "the files in it are larger than %zu MiB together",
			   FILE_BYTES_MAX / 1024 / 1024);
	return whole && total <= FILE_BYTES_MAX;
}
