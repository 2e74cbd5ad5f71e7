#include "gcode/dialect/sinumerik/builder/sinumerik_cycle_refused.h"

#include <stddef.h>
#include <string.h>

const char *sinumerik_cycle_refused(const char *name)
{
	/* The first row that matches is used. */
	static const struct {
		const char *start, *what;
	} refused[] = {
		{"CYCLE60", "engraving"},
		{"CYCLE62", "milling of a contour"},
		{"CYCLE63", "milling of a contour's pocket"},
		{"CYCLE64", "drilling before a contour's pocket is milled"},
		{"CYCLE72", "milling of a contour"},
		{"CYCLE76", "milling round a spigot, from how far outside is not published,"},
		{"CYCLE77", "milling round a spigot, from how far outside is not published,"},
		{"CYCLE78", "drilling and milling of a thread"},
		{"CYCLE79", "milling round a polygon, from how far outside is not published,"},
		{"CYCLE899", "milling of an open slot, from how far outside is not published,"},
		{"CYCLE8", "cycle of the control"},
		{"CYCLE9", "turning"},
		{"CYCLE4", "grinding"},
		{"CYCLE7", "cycle of the control"},
	};
	const size_t digits = !strncmp(name, "CYCLE", 5) ? strspn(name + 5, "0123456789") : 0;

	/* CYCLE_OWN, and CYCLE with other numbers, are ordinary subprograms. */
	for (size_t i = 0; i < sizeof(refused) / sizeof(refused[0]) && digits > 0 && !name[5 + digits]; i++) {
		if (!strncmp(name, refused[i].start, strlen(refused[i].start)))
			return refused[i].what;
	}
	return NULL;
}
