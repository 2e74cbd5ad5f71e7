#include "machine/library/step_entities.h"

#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"

/* Entities with larger numbers are not read. */
#define NUMBER_MAX 999999999

struct scan {
	const char *at;
	long line;
	struct srcloc place;
	struct diag *diag;
};

void step_entities_release(struct step_entities *entities)
{
	free(entities->items);
	*entities = (struct step_entities){0};
}

static bool fault(struct scan *scan, const char *what)
{
	scan->place.line = scan->line;
	diag_error(scan->diag, scan->place, "%s", what);
	return false;
}

static void step(struct scan *scan)
{
	scan->line += *scan->at == '\n';
	scan->at++;
}

/* Skips white space and comments. */
static void skip_space(struct scan *scan)
{
	for (;;) {
		while (ascii_is_space(*scan->at))
			step(scan);
		if (strncmp(scan->at, "/*", 2) != 0)
			return;
		while (*scan->at && strncmp(scan->at, "*/", 2) != 0)
			step(scan);
		scan->at += *scan->at ? 2 : 0;
	}
}

/* Skips a string that begins here; a doubled quote is read as two adjacent strings. */
static void skip_string(struct scan *scan)
{
	step(scan);
	while (*scan->at && *scan->at != '\'')
		step(scan);
	scan->at += *scan->at == '\'';
}

/* Skips to one of the bytes of `stops` outside strings and parentheses that open here, or to the end. */
static void skip_to(struct scan *scan, const char *stops)
{
	long depth = 0;

	while (*scan->at && (depth > 0 || !strchr(stops, *scan->at))) {
		if (*scan->at == '\'') {
			skip_string(scan);
			continue;
		}
		depth += (*scan->at == '(') - (*scan->at == ')');
		step(scan);
	}
}

static long read_number(const char **at)
{
	long number = 0;

	for (; ascii_is_digit(**at) && number <= NUMBER_MAX; ++*at)
		number = 10 * number + (**at - '0');
	return number <= NUMBER_MAX ? number : 0;
}

static bool read_entity(struct scan *scan, struct step_entity *entity)
{
	scan->at++;
	*entity = (struct step_entity){.number = read_number(&scan->at), .line = scan->line};
	skip_space(scan);
	if (entity->number < 1 || *scan->at != '=')
		return fault(scan, "this is not an entity of a STEP file: #number = NAME (arguments);");
	scan->at++;
	skip_space(scan);
	entity->name = scan->at;
	while (ascii_is_alphanumeric(*scan->at) || *scan->at == '_')
		scan->at++;
	entity->name_length = (size_t)(scan->at - entity->name);
	skip_space(scan);
	if (*scan->at != '(')
		return fault(scan, "an entity of a STEP file needs its arguments in parentheses");
	entity->arguments = ++scan->at;
	skip_to(scan, ")");
	entity->end = scan->at;
	if (!*scan->at)
		return fault(scan, "the file ends inside an entity");
	scan->at++;
	skip_space(scan);
	if (*scan->at != ';')
		return fault(scan, "an entity of a STEP file ends with a semicolon");
	scan->at++;
	return true;
}

static int by_number(const void *a, const void *b)
{
	const struct step_entity *left = a, *right = b;

	if (left->number != right->number)
		return left->number < right->number ? -1 : 1;
	return (left->arguments > right->arguments) - (left->arguments < right->arguments);
}

bool step_entities_read(struct step_entities *entities, const char *text, const char *path, struct diag *diag)
{
	struct scan scan = {.at = text, .line = 1, .place = {.file = path}, .diag = diag};

	/* Other statements belong to the header or enclose the sections. */
	for (skip_space(&scan); *scan.at; skip_space(&scan)) {
		if (*scan.at != '#') {
			skip_to(&scan, ";");
			scan.at += *scan.at == ';';
			continue;
		}
		entities->items = mem_grow(entities->items, &entities->capacity, entities->count + 1,
					   sizeof(*entities->items));
		if (!read_entity(&scan, &entities->items[entities->count]))
			return false;
		entities->count++;
	}
	if (entities->count)
		qsort(entities->items, entities->count, sizeof(*entities->items), by_number);
	return true;
}

const struct step_entity *step_entities_find(const struct step_entities *entities, long number)
{
	size_t low = 0, high = entities->count;

	while (low < high) {
		const size_t middle = low + (high - low) / 2;

		if (entities->items[middle].number < number)
			low = middle + 1;
		else
			high = middle;
	}
	return low < entities->count && entities->items[low].number == number ? &entities->items[low] : NULL;
}

bool step_entity_is(const struct step_entity *entity, const char *name)
{
	return entity->name_length == strlen(name) && !strncmp(entity->name, name, entity->name_length);
}

/* The position of the n-th argument in the text, and its length. False: there is none. */
static bool find_argument(const struct step_entity *entity, int n, const char **start, size_t *length)
{
	struct scan scan = {.at = entity->arguments};

	for (int i = 0;; i++) {
		skip_space(&scan);
		*start = scan.at;
		skip_to(&scan, ",)");
		if (scan.at > entity->end)
			return false;
		if (i == n)
			break;
		if (*scan.at != ',')
			return false;
		scan.at++;
	}
	*length = (size_t)(scan.at - *start);
	while (*length && ascii_is_space((*start)[*length - 1]))
		--*length;
	return true;
}

const char *step_entity_argument(const struct step_entity *entity, int n, struct arena *arena)
{
	const char *start;
	size_t length;
	char *text;

	if (!find_argument(entity, n, &start, &length) || (length == 1 && *start == '$'))
		return "";
	if (length >= 2 && *start == '\'' && start[length - 1] == '\'') {
		start++;
		length -= 2;
	}
	text = arena_alloc(arena, length + 1);
	memcpy(text, start, length);
	text[length] = '\0';
	return text;
}

long step_entity_reference(const struct step_entity *entity, int n)
{
	const char *start;
	size_t length;

	if (!find_argument(entity, n, &start, &length) || *start != '#')
		return 0;
	start++;
	return read_number(&start);
}
