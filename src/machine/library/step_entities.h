/* step_entities.h - the entities of a STEP file (ISO 10303-21), by their numbers, with their arguments as text. */
#ifndef FIVECHECK_MACHINE_LIBRARY_STEP_ENTITIES_H
#define FIVECHECK_MACHINE_LIBRARY_STEP_ENTITIES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "base/diag.h"

/* #12 = NAME (arguments); - pieces of the file's text. */
struct step_entity {
	long number, line;
	const char *name, *arguments, *end;	/* end: of the arguments, without the closing parenthesis */
	size_t name_length;
};

/* All zero is an empty list. */
struct step_entities {
	struct step_entity *items;
	size_t count, capacity;
};

void step_entities_release(struct step_entities *entities);

/*
 * Reads the data sections of the text, which must outlive the entities. An entity of several types has an empty name.
 * False, reported: the text is not a list of entities.
 */
bool step_entities_read(struct step_entities *entities, const char *text, const char *path, struct diag *diag);

/* The first entity of the number, or NULL. */
const struct step_entity *step_entities_find(const struct step_entities *entities, long number);

bool step_entity_is(const struct step_entity *entity, const char *name);

/* The text of the n-th argument, from 0, without quotes, in the arena; "" if there is none or it is $. */
const char *step_entity_argument(const struct step_entity *entity, int n, struct arena *arena);

/* The number of the entity that the n-th argument refers to; 0: it is not a reference. */
long step_entity_reference(const struct step_entity *entity, int n);

#endif
