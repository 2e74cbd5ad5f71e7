#include "machine/library/tool_library.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "geom/tolerance.h"
#include "machine/tool_build.h"
#include "machine/tool_solid.h"

/* mm: heights that differ by less are the same. */
#define SAME_HEIGHT TOOL_SECTION_MIN
enum { NAME_BYTES_MAX = 120 };

void tool_library_release(struct tool_library *tools)
{
	free(tools->setup.tools);
	free(tools->setup.lengths);
	free(tools->setup.offsets);
	free(tools->setup.values);
	free(tools->setup.edges);
	free(tools->tool_places);
	free(tools->length_places);
	arena_release(&tools->setup.arena);
	*tools = (struct tool_library){0};
}

static struct optional_number given_unless(double value, double usual)
{
	return (struct optional_number){fabs(value - usual) > TOOL_SUM_TOLERANCE, value};
}

void tool_outline_compensate(struct tool_outline *outline, double length, double radius)
{
	outline->length_offset = given_unless(length, outline->length);
	outline->radius_offset = given_unless(radius, outline->diameter / 2);
}

void tool_outline_release(struct tool_outline *outline)
{
	tool_profile_release(&outline->cutter);
	tool_profile_release(&outline->shank);
	tool_profile_release(&outline->holder);
}

bool tool_library_wants(struct tool_library *tools, long number)
{
	for (size_t i = 0; i < tools->wanted_count; i++) {
		struct number_range *range = &tools->wanted[i];

		if (number < range->first || number > range->last)
			continue;
		range->used = true;
		return true;
	}
	return !tools->wanted;
}

/* ------------------------------------------------------------------ outlines */

/* Is the number free? False, reported with both places. */
static bool is_free(const struct tool_library *tools, const struct tool_outline *outline, struct srcloc at,
		    struct diag *diag)
{
	const struct setup_description *setup = &tools->setup;
	size_t first = 0;

	while (first < setup->tool_count && setup->tools[first].number != outline->number)
		first++;
	if (first == setup->tool_count)
		return true;
	if (outline->entry)
		diag_error(diag, at,
			   "the tool number %ld is given twice, to the tools %zu (%.60s) and %zu (%.60s) of the list: "
			   "keep only the tool that is in the machine, or give one of them another number",
			   outline->number, tools->tool_places[first].entry,
			   setup->tools[first].name ? setup->tools[first].name : "", outline->entry,
			   outline->name ? outline->name : "");
	else
		diag_error(diag, at,
			   "the tool number %ld is given twice (also in line %ld): keep only the tool that is in the "
			   "machine, or give one of them another number",
			   outline->number, tools->tool_places[first].line);
	return false;
}

static void add_place(struct library_place **places, size_t *capacity, size_t count, long line, size_t entry)
{
	*places = mem_grow(*places, capacity, count + 1, sizeof(**places));
	(*places)[count] = (struct library_place){.line = line, .entry = entry};
}

/*
 * The piece between two heights, if there is room for it. Where the outline has a gap the piece is as thick as the
 * cutter.
 */
static void add_piece(struct tool_library *tools, struct piece_description *piece, const struct tool_profile *profile,
		      double low, double high, double gap)
{
	if (high - low < SAME_HEIGHT)
		return;
	tool_profile_sections(profile, low, high, gap, &tools->setup.arena, piece);
	/* Any pointer will do: it only shows that the piece exists. */
	piece->at = piece->sections;
}

static struct optional_number given_if(bool given, double value)
{
	return (struct optional_number){.given = given, .value = value};
}

/* The lowest height of an outline, at least 0; `top` if the outline is empty. */
static double bottom_of(const struct tool_profile *profile, double top)
{
	double low = top;

	for (size_t i = 0; i < profile->count; i++)
		low = fmin(low, fmax(profile->pieces[i].low, 0));
	return low;
}

/*
 * The pieces of a setup do not overlap; those of a library may: a cutter is inside its holder. A height belongs to the
 * lower piece as long as this hides the upper one. Above, everything belongs to the upper piece, which has stricter
 * rules. So no part of the tool is lost, and no part cuts that must not cut.
 */
static void add_pieces(struct tool_library *tools, struct tool_description *tool, const struct tool_outline *outline)
{
	struct piece_description *pieces = tool->pieces;
	struct tool_profile whole = {0}, lower = {0};
	double length = outline->length, holder_low, shank_low;

	tool_profile_join(&lower, &outline->cutter);
	tool_profile_join(&lower, &outline->shank);
	holder_low = tool_profile_hides(&lower, &outline->holder, bottom_of(&outline->holder, length));
	holder_low = outline->holder.count ? fmin(holder_low, length) : length;
	shank_low = tool_profile_hides(&outline->cutter, &outline->shank, bottom_of(&outline->shank, holder_low));
	shank_low = outline->shank.count ? fmin(shank_low, holder_low) : holder_low;
	/* Slices too thin for a section belong to the piece above. */
	if (length - holder_low < SAME_HEIGHT)
		holder_low = length;
	if (holder_low - shank_low < SAME_HEIGHT)
		shank_low = holder_low;
	tool_profile_join(&whole, &lower);
	tool_profile_join(&whole, &outline->holder);
	add_piece(tools, &pieces[PIECE_HOLDER], &whole, holder_low, length, outline->diameter);
	add_piece(tools, &pieces[PIECE_SHANK], &lower, shank_low, holder_low, outline->diameter);
	add_piece(tools, &pieces[PIECE_CUTTER], &outline->cutter, 0, shank_low, outline->diameter);
	tool_profile_release(&whole);
	tool_profile_release(&lower);
}

static void add_tip(struct piece_description *cutter, const struct tool_outline *outline)
{
	double top = 0;

	for (size_t i = 0; i < cutter->section_count; i++)
		top += cutter->sections[i].length;
	cutter->has_tip = outline->has_tip;
	cutter->tip = outline->tip;
	cutter->corner = given_if(outline->has_tip && outline->tip == TIP_BULL, outline->corner);
	cutter->angle = given_if(outline->has_tip && outline->tip == TIP_CONE, outline->angle);
	cutter->flute_length = given_if(outline->flute_length > 0 && outline->flute_length < top - SAME_HEIGHT,
					outline->flute_length);
}

/* A name that a setup may have: without control characters, and shortened if it is too long. NULL: there is none. */
static const char *make_name(struct arena *arena, const char *text)
{
	char name[NAME_BYTES_MAX + 1];
	size_t length = 0;

	for (; text && text[length] && length < NAME_BYTES_MAX; length++)
		name[length] = (unsigned char)text[length] < 0x20 || text[length] == 0x7f ? ' ' : text[length];
	/* Do not divide a character of UTF-8. */
	while (length && text[length] && ((unsigned char)text[length] & 0xc0) == 0x80)
		length--;
	name[length] = '\0';
	return length ? arena_strdup(arena, name) : NULL;
}

/* Is a part of the outline thicker than any tool? */
static bool is_too_thick(const struct tool_profile *profile)
{
	for (size_t i = 0; i < profile->count; i++)
		if (!(profile->pieces[i].radius_low <= TOOL_SIZE_MAX / 2 &&
		      profile->pieces[i].radius_high <= TOOL_SIZE_MAX / 2))
			return true;
	return false;
}

bool tool_library_add(struct tool_library *tools, const struct tool_outline *outline, struct srcloc at,
		      struct diag *diag)
{
	struct setup_description *setup = &tools->setup;
	struct tool_description *tool;

	if (outline->number < 1 || outline->number > TOOL_NUMBER_MAX) {
		diag_error(diag, at, "the tool number %ld is not between 1 and %d", outline->number, TOOL_NUMBER_MAX);
		return false;
	}
	if (!(outline->diameter <= TOOL_SIZE_MAX) || is_too_thick(&outline->cutter) || is_too_thick(&outline->shank) ||
	    is_too_thick(&outline->holder)) {
		diag_error(diag, at, "tool %ld is thicker than %g mm: check its units", outline->number, TOOL_SIZE_MAX);
		return false;
	}
	if (!is_free(tools, outline, at, diag))
		return false;
	if (!(outline->length >= SAME_HEIGHT && outline->length <= TOOL_SIZE_MAX)) {
		diag_error(diag, at,
			   "tool %ld has the length %g mm from gauge line to tip; it must be between %g and %g",
			   outline->number, outline->length, SAME_HEIGHT, TOOL_SIZE_MAX);
		return false;
	}
	add_place(&tools->tool_places, &tools->tool_place_capacity, setup->tool_count, at.line, outline->entry);
	setup->tools = mem_grow(setup->tools, &tools->tool_capacity, setup->tool_count + 1, sizeof(*setup->tools));
	tool = &setup->tools[setup->tool_count++];
	*tool = (struct tool_description){
		.number = outline->number,
		.name = make_name(&setup->arena, outline->name),
		.length = outline->length,
		.length_offset = outline->length_offset,
		.radius_offset = outline->radius_offset,
		.kind = outline->kind,
		.hand = outline->hand,
	};
	add_pieces(tools, tool, outline);
	if (tool->pieces[PIECE_CUTTER].at)
		add_tip(&tool->pieces[PIECE_CUTTER], outline);
	return true;
}

/* ------------------------------------------------------------------- offsets */

bool tool_library_add_offset(struct tool_library *tools, const struct length_offset_description *offset,
			     struct srcloc at, struct diag *diag)
{
	struct setup_description *setup = &tools->setup;

	if (offset->number < 1 || offset->number > TOOL_NUMBER_MAX) {
		diag_error(diag, at, "the offset number %ld is not between 1 and %d", offset->number,
			   TOOL_NUMBER_MAX);
		return false;
	}
	if (!tool_library_wants(tools, offset->number))
		return true;
	for (size_t i = 0; i < setup->length_count; i++) {
		if (setup->lengths[i].number == offset->number) {
			diag_error(diag, at, "the offset number %ld is given twice (also in line %ld)", offset->number,
				   tools->length_places[i].line);
			return false;
		}
	}
	add_place(&tools->length_places, &tools->length_place_capacity, setup->length_count, at.line, 0);
	setup->lengths = mem_grow(setup->lengths, &tools->length_capacity, setup->length_count + 1, sizeof(*offset));
	setup->lengths[setup->length_count++] = *offset;
	return true;
}

void tool_library_add_values(struct tool_library *tools, const struct tool_values_description *values)
{
	struct setup_description *setup = &tools->setup;
	struct tool_values_description *added;

	if (!tool_library_wants(tools, values->number))
		return;
	setup->values = mem_grow(setup->values, &tools->value_capacity, setup->value_count + 1, sizeof(*values));
	added = &setup->values[setup->value_count++];
	*added = *values;
	added->key = values->key ? arena_strdup(&setup->arena, values->key) : NULL;
	added->name = values->name ? make_name(&setup->arena, values->name) : NULL;
}

void tool_library_add_edge(struct tool_library *tools, const struct edge_description *edge)
{
	struct setup_description *setup = &tools->setup;

	setup->edges = mem_grow(setup->edges, &tools->edge_capacity, setup->edge_count + 1, sizeof(*edge));
	setup->edges[setup->edge_count++] = *edge;
}

struct work_offset_description *tool_library_work_offset(struct tool_library *tools, const char *name)
{
	struct setup_description *setup = &tools->setup;

	for (size_t i = 0; i < setup->offset_count; i++)
		if (!strcmp(setup->offsets[i].name, name))
			return &setup->offsets[i];
	setup->offsets =
		mem_grow(setup->offsets, &tools->offset_capacity, setup->offset_count + 1, sizeof(*setup->offsets));
	setup->offsets[setup->offset_count] =
		(struct work_offset_description){.name = arena_strdup(&setup->arena, name)};
	return &setup->offsets[setup->offset_count++];
}
