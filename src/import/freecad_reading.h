/* freecad_reading.h - what the readers of a FreeCAD machine share: their state, messages, and vectors. */
#ifndef FIVECHECK_IMPORT_FREECAD_READING_H
#define FIVECHECK_IMPORT_FREECAD_READING_H

#include <stdbool.h>

#include "base/axes.h"
#include "import/axis_chains.h"
#include "machine/library/json_file.h"

/* mm, or without a unit: FreeCAD ignores a shorter vector. */
#define FREECAD_SHORTEST 1e-6

enum freecad_side { SIDE_UNKNOWN, SIDE_TABLE, SIDE_HEAD };

/* An axis of the file. */
struct freecad_axis {
	struct axis_description axis;
	enum freecad_side side;
	char parent;	/* letter; 0: none */
	bool placed;
};

/* The state of reading a file. Borrows everything. */
struct freecad_reading {
	struct import_machine *machine;
	const struct import_options *options;
	struct diag *diag;
	const char *path;
	double unit;	/* mm */
	struct freecad_axis axes[SLOT_COUNT];
	struct axis_letters letters;	/* of all axes: linear ones, rotary ones, U, V and W */
};

/* The file, for messages. */
struct srcloc freecad_place(const struct freecad_reading *r);

/* Reports an error. The value is false. */
bool freecad_fault(const struct freecad_reading *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Notes a task for the user, and reports it at once. */
void freecad_warn(struct freecad_reading *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Three finite numbers. False: it is something else. */
bool freecad_read_vector(const json_t *array, vec3 *vector);

/* Is it 0 0 0? */
bool freecad_is_none(vec3 v);

#endif
