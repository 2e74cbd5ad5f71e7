#include "gcode/dialect/sinumerik/values/sinumerik_variables.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* Limits of the variables of one program; controls have less. */
#define VARIABLES_MAX 10000
#define ELEMENTS_MAX 1000000
#define TEXTS_MAX 20000

int sinumerik_variables_find_own(const struct sinumerik *sinumerik, const char *name)
{
	for (size_t i = sinumerik->variables.count; i-- > 0;) {
		if (sinumerik->variables.items[i].level < sinumerik->calls.level)
			return -1;
		if (!strcmp(sinumerik->variables.items[i].name, name))
			return (int)i;
	}
	return -1;
}

/* Variables of the control are the first ones. */
static int find_of_control(const struct sinumerik *sinumerik, const char *name)
{
	for (size_t i = 0; i < sinumerik->variables.count; i++) {
		if (sinumerik->variables.items[i].level != SINUMERIK_LEVEL_OF_CONTROL)
			return -1;
		if (!strcmp(sinumerik->variables.items[i].name, name))
			return (int)i;
	}
	return -1;
}

int sinumerik_variables_find(const struct sinumerik *sinumerik, const char *name)
{
	int found = sinumerik_variables_find_own(sinumerik, name);

	if (found < 0)
		found = find_of_control(sinumerik, name);
	while (found >= 0 && sinumerik->variables.items[found].refers_to >= 0)
		found = sinumerik->variables.items[found].refers_to;
	return found;
}

struct sinumerik_variable *sinumerik_variables_add(struct interp *interp, const struct sinumerik_variable *made,
						   int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const bool text = made->type == SINUMERIK_STRING;
	struct sinumerik_variable *variable;
	size_t count = 1;

	for (int i = 0; i < made->dimensions; i++) {
		if (made->size[i] < 1 || (size_t)made->size[i] > ELEMENTS_MAX / count) {
			fault_report(&interp->at, column, "an array of this size cannot be made");
			return NULL;
		}
		count *= (size_t)made->size[i];
	}
	if (sinumerik->variables.count >= VARIABLES_MAX || sinumerik->variables.elements + count > ELEMENTS_MAX ||
	    (text && count > TEXTS_MAX)) {
		fault_report(&interp->at, column, "the variables of the program take more room than there is");
		return NULL;
	}
	sinumerik->variables.items = mem_grow(sinumerik->variables.items, &sinumerik->variables.capacity,
					sinumerik->variables.count + 1, sizeof(*sinumerik->variables.items));
	variable = &sinumerik->variables.items[sinumerik->variables.count++];
	*variable = *made;
	variable->count = count;
	variable->level = sinumerik->calls.level;
	variable->numbers = text ? NULL : mem_zalloc(count, sizeof(*variable->numbers));
	variable->texts = text ? mem_zalloc(count, sizeof(*variable->texts)) : NULL;
	sinumerik->variables.elements += count;
	return variable;
}

void sinumerik_variables_leave(struct sinumerik *sinumerik, int level)
{
	while (sinumerik->variables.count > 0) {
		struct sinumerik_variable *last = &sinumerik->variables.items[sinumerik->variables.count - 1];

		if (last->level <= level)
			return;
		sinumerik->variables.elements -= last->count;
		free(last->numbers);
		free(last->texts);
		free(last->given);
		sinumerik->variables.count--;
	}
}

/*
 * 840D sl, job planning, "Type conversions": from REAL to INT, 0.5 and more is rounded up; to BOOL, every value
 * except 0 is TRUE.
 */
bool sinumerik_variables_set(struct interp *interp, struct sinumerik_variable *variable, size_t element, double value,
			     int column)
{
	if (variable->type == SINUMERIK_BOOL)
		value = fpclassify(value) == FP_ZERO ? 0 : 1;
	if (variable->type == SINUMERIK_INT || variable->type == SINUMERIK_CHAR)
		value = floor(value + 0.5);
	if ((variable->type == SINUMERIK_INT && fabs(value) > 2147483647.0) ||
	    (variable->type == SINUMERIK_CHAR && (value < 0 || value > 255)))
		return fault(&interp->at, column, "%.15g does not fit into %s", value, variable->name);
	variable->numbers[element] = value;
	sinumerik_variables_mark(variable, element);
	return true;
}

void sinumerik_variables_mark(struct sinumerik_variable *variable, size_t element)
{
	if (variable->given)
		variable->given[element] = true;
}

/* The element as a program writes it: "NAME[2,0]". */
static void write_name(const struct sinumerik_variable *variable, size_t element, char *name, size_t size)
{
	int index[SINUMERIK_DIMENSIONS] = {0}, length = snprintf(name, size, "%s", variable->name);

	for (int i = variable->dimensions; i-- > 0;) {
		index[i] = (int)(element % (size_t)variable->size[i]);
		element /= (size_t)variable->size[i];
	}
	for (int i = 0; i < variable->dimensions; i++)
		length += snprintf(name + length, size - (size_t)length, "%c%d", i > 0 ? ',' : '[', index[i]);
	if (variable->dimensions > 0)
		snprintf(name + length, size - (size_t)length, "]");
}

bool sinumerik_variables_check(const struct line_place *at, const struct sinumerik_variable *variable, size_t element,
			       int column)
{
	char name[SINUMERIK_NAME + 8 * SINUMERIK_DIMENSIONS];

	if (!variable->given || variable->given[element])
		return true;
	/* Reported once. */
	variable->given[element] = true;
	write_name(variable, element, name, sizeof(name));
	return fault(at, column,
		     "%s keeps its value from one program to the next, and this program has not set it: set "
		     "<variable name=\"%s\" value=\"\"/> in the machine file's <controller>",
		     name, name);
}
