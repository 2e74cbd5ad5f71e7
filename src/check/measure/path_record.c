#include "check/course.h"

#include <math.h>
#include <string.h>

/* radians: rounding of what does not depend on work offsets, but may be computed along with what does. */
#define SAME_ANGLE 1e-9

struct record {
	long line;
	int tool;
	axis_values end;
};

bool course_init(struct course *course)
{
	*course = (struct course){.file = tmpfile()};
	return course->file != NULL;
}

void course_release(struct course *course)
{
	if (course->file)
		fclose(course->file);
	*course = (struct course){0};
}

static void restart(struct course *course, bool compares)
{
	course->compares = compares;
	course->same = true;
	course->way = 0;
	memset(course->ways, 0, sizeof(course->ways));
	if (fseek(course->file, 0, SEEK_SET))
		course->lost = true;
}

void course_record(struct course *course)
{
	restart(course, false);
}

void course_compare(struct course *course)
{
	restart(course, true);
}

void course_step(struct course *course, const struct motion_step *step)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		uint64_t bits;

		/* Fowler, Noll and Vo's hash (FNV-1a), a number at a time. */
		memcpy(&bits, &step->span.q1.v[slot], sizeof(bits));
		course->ways[slot] = (course->ways[slot] ^ bits) * UINT64_C(0x100000001b3) + 1;
	}
}

static void compare(struct course *course, const struct record *now)
{
	struct record then;
	double way = 0;

	if (fread(&then, sizeof(then), 1, course->file) != 1) {
		course->same = false;
		course->lost |= ferror(course->file) != 0;
		return;
	}
	if (now->line != then.line || now->tool != then.tool)
		course->same = false;
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double off = fabs(now->end.v[slot] - then.end.v[slot]);

		if (!slot_is_rotary(slot))
			way += off * off;
		else if (off > SAME_ANGLE)
			course->same = false;
	}
	course->way = fmax(course->way, sqrt(way));
}

void course_block(struct course *course, long line, int tool, const axis_values *end)
{
	struct record record;

	memset(&record, 0, sizeof(record));
	record.line = line;
	record.tool = tool;
	record.end = *end;
	if (course->compares)
		compare(course, &record);
	else if (fwrite(&record, sizeof(record), 1, course->file) != 1)
		course->lost = true;
}

void course_end(struct course *course)
{
	struct record more;

	if (fread(&more, sizeof(more), 1, course->file) == 1)
		course->same = false;
}
