/*
 * import.h - the contents of a file of another program, a machine and its setup, before they are written as fivecheck's
 * files.
 */
#ifndef FIVECHECK_IMPORT_IMPORT_H
#define FIVECHECK_IMPORT_IMPORT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"
#include "geom/mesh.h"
#include "import/mesh_sources.h"
#include "machine/description.h"

/* More tasks for the user than a reader notes. */
enum { IMPORT_TODO_MAX = 24 };

/*
 * A reader fills in the description as the reader of machine.xml would: lengths in mm, angles in radians, everything in
 * machine coordinates with every axis at 0. The paths of the bodies' meshes are the ones that the meshes will have
 * beside machine.xml; `meshes` has their triangles, in mm.
 */
struct import_machine {
	struct machine_description description;
	struct mesh *meshes;	/* the n-th belongs to the n-th body; owned */
	size_t mesh_capacity, body_capacity, pair_capacity;
	bool dialect_known, rapid_known;	/* else the file does not contain it */
	bool inch;	/* the control's own unit is the inch, so machine.xml is written in inches */
	const char *tool_name, *work_name;	/* of the components that carry tools and the work; or NULL */
	const struct import_machine *beside;	/* whose bodies must have other names; or NULL */
	const char *folder;	/* of the meshes, beside the file; NULL: stl */
	size_t left_out;	/* bodies whose meshes are missing */
	const char *todo[IMPORT_TODO_MAX];	/* tasks for the user, for comments of the machine file */
	size_t todo_count;
};

/* All zero is an empty machine. */
void import_machine_release(struct import_machine *machine);

/* The decisions of the user about a file. */
struct import_options {
	const char *meshes;	/* a folder in which meshes are searched first; or NULL */
	bool skip_missing;	/* leave out bodies whose meshes are missing, with a warning each */
	const char *table;	/* letters of the axes that carry the work, from the base on; or NULL: not given */
	const char *head;	/* of those that carry the tool; or NULL: not given */
	const char *device;	/* name, uuid or id of the device to use, if there are several; or NULL */
	struct mesh_sources *sources;	/* no decision: the meshes found so far; borrowed, or NULL */
};

/*
 * Adds a body whose mesh the machine takes over. Its name is made from `wanted`; if that name is taken or empty,
 * `otherwise` is put before it, and then a number after it. Returns the body; it is valid until the next one is added.
 */
struct body_description *import_machine_add_body(struct import_machine *machine, const char *wanted,
						 const char *otherwise, int link, const xform *frame,
						 struct mesh *mesh);

/* Adds a pair that is always checked; an existing pair keeps the larger clearance. */
void import_machine_add_pair(struct import_machine *machine, const char *a, const char *b, double clearance);

/* Notes a task for the user, like printf; notes beyond IMPORT_TODO_MAX are left out. */
void import_machine_todo(struct import_machine *machine, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
