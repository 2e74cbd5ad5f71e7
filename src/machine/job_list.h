/* job_list.h - the file that lists several checks: each has a machine, a setup and programs. */
#ifndef FIVECHECK_MACHINE_JOB_LIST_H
#define FIVECHECK_MACHINE_JOB_LIST_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"

/* Paths can be opened as they are. */
struct job_item {
	const char *name;	/* letters, digits and "._-"; unique */
	const char *machine;
	const char *setup;	/* or NULL */
	const char *waivers;	/* or NULL */
	const char **programs;
	size_t program_count;	/* at least 1 */
	long line;
};

struct job_list {
	struct arena arena;	/* owns everything below */
	const char *path;	/* borrowed */
	struct job_item *items;
	size_t count;	/* at least 1 */
};

/* Is the root element of the file <jobs>? False for a file that cannot be read, too. */
bool job_list_is(const char *path);

/* Every fault is reported with its place; false if there was one. */
bool job_list_load(struct job_list *list, const char *path, struct diag *diag);
void job_list_release(struct job_list *list);

#endif
