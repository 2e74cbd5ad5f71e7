#include "check/measure/path_record.h"

#include "geom/tolerance.h"

#include <math.h>
#include <string.h>

struct record {
	long line;
	int tool;
	axis_values end;
};

bool path_record_init(struct path_record *path)
{
	*path = (struct path_record){.file = tmpfile()};
	return path->file != NULL;
}

void path_record_release(struct path_record *path)
{
	if (path->file)
		fclose(path->file);
	*path = (struct path_record){0};
}

static void restart(struct path_record *path, bool compares)
{
	path->compares = compares;
	path->same = true;
	path->farthest = 0;
	memset(path->digests, 0, sizeof(path->digests));
	if (fseek(path->file, 0, SEEK_SET))
		path->failed = true;
}

void path_record_start(struct path_record *path)
{
	restart(path, false);
}

void path_record_compare(struct path_record *path)
{
	restart(path, true);
}

void path_record_step(struct path_record *path, const struct motion_step *step)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		uint64_t bits;

		/* The hash of Fowler, Noll and Vo (FNV-1a), one number at a time. */
		memcpy(&bits, &step->span.q1.v[slot], sizeof(bits));
		path->digests[slot] = (path->digests[slot] ^ bits) * UINT64_C(0x100000001b3) + 1;
	}
}

static void compare_record(struct path_record *path, const struct record *now)
{
	struct record then;
	double sum = 0;

	if (fread(&then, sizeof(then), 1, path->file) != 1) {
		path->same = false;
		path->failed |= ferror(path->file) != 0;
		return;
	}
	if (now->line != then.line || now->tool != then.tool)
		path->same = false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double off = fabs(now->end.v[slot] - then.end.v[slot]);

		if (!slot_is_rotary(slot))
			sum += off * off;
		else if (off > SAME_POINT)
			path->same = false;
	}
	path->farthest = fmax(path->farthest, sqrt(sum));
}

void path_record_block(struct path_record *path, long line, int tool, const axis_values *end)
{
	struct record record;

	memset(&record, 0, sizeof(record));
	record.line = line;
	record.tool = tool;
	record.end = *end;
	if (path->compares)
		compare_record(path, &record);
	else if (fwrite(&record, sizeof(record), 1, path->file) != 1)
		path->failed = true;
}

void path_record_end(struct path_record *path)
{
	struct record more;

	if (fread(&more, sizeof(more), 1, path->file) == 1)
		path->same = false;
}
