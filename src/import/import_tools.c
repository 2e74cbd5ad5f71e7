#include "import/import_tools.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/xml_text.h"
#include "machine/tool_solid.h"

/* mm: heights that differ by less are one. */
#define SAME_HEIGHT TOOL_SECTION_MIN
enum { NAME_BYTES_MAX = 120 };

void import_tools_release(struct import_tools *tools)
{
	free(tools->setup.tools);
	arena_release(&tools->setup.arena);
	*tools = (struct import_tools){0};
}

void tool_outline_release(struct tool_outline *outline)
{
	tool_profile_release(&outline->cutter);
	tool_profile_release(&outline->shank);
	tool_profile_release(&outline->holder);
}

/* ------------------------------------------------------------------ outlines */

static bool is_known(const struct import_tools *tools, long number)
{
	for (size_t i = 0; i < tools->setup.tool_count; i++)
		if (tools->setup.tools[i].number == number)
			return true;
	return false;
}

/* The piece between two heights, if there is room for it. Where the outline has nothing the tool is as thick as its cutter. */
static void add_piece(struct import_tools *tools, struct piece_description *piece, const struct tool_profile *profile,
		      double low, double high, double gap)
{
	if (high - low < SAME_HEIGHT)
		return;
	tool_profile_sections(profile, low, high, gap, &tools->setup.arena, piece);
	/* Any place will do: it says that the piece is there. */
	piece->at = piece->sections;
}

static struct optional_number given_if(bool given, double value)
{
	return (struct optional_number){.given = given, .value = value};
}

/* The lowest height of an outline, but 0 at least; `top` if it is empty. */
static double bottom_of(const struct tool_profile *profile, double top)
{
	double low = top;

	for (size_t i = 0; i < profile->count; i++)
		low = fmin(low, fmax(profile->pieces[i].low, 0));
	return low;
}

/*
 * The pieces of a setup do not overlap, those of a library may: a cutter stands in its holder. A height belongs to the
 * lower piece as long as that hides the upper one; above, all that is there counts as the upper piece, which may touch
 * less. So nothing of the tool is lost, and nothing cuts that should not.
 */
static void add_pieces(struct import_tools *tools, struct tool_description *tool, const struct tool_outline *outline)
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
	/* Slivers that no section can have belong to the piece above. */
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

/* A name that a setup may have: without control characters, and cut where it is too long. NULL: there is none. */
static const char *make_name(struct arena *arena, const char *text)
{
	char name[NAME_BYTES_MAX + 1];
	size_t length = 0;

	for (; text && text[length] && length < NAME_BYTES_MAX; length++)
		name[length] = (unsigned char)text[length] < 0x20 || text[length] == 0x7f ? ' ' : text[length];
	/* Do not cut a character of UTF-8. */
	while (length && text[length] && ((unsigned char)text[length] & 0xc0) == 0x80)
		length--;
	name[length] = '\0';
	return length ? arena_strdup(arena, name) : NULL;
}

bool import_tools_add(struct import_tools *tools, const struct tool_outline *outline, struct srcloc at,
		      struct diag *diag)
{
	struct setup_description *setup = &tools->setup;
	struct tool_description *tool;

	if (is_known(tools, outline->number)) {
		diag_error(diag, at, "the tool number %ld is given twice", outline->number);
		return false;
	}
	if (!(outline->length >= SAME_HEIGHT && outline->length <= TOOL_SIZE_MAX)) {
		diag_error(diag, at, "tool %ld has the length %g mm from its gauge line to its tip; it must be between %g and %g",
			   outline->number, outline->length, SAME_HEIGHT, TOOL_SIZE_MAX);
		return false;
	}
	setup->tools = mem_grow(setup->tools, &tools->tool_capacity, setup->tool_count + 1, sizeof(*setup->tools));
	tool = &setup->tools[setup->tool_count++];
	*tool = (struct tool_description){
		.number = outline->number,
		.name = make_name(&setup->arena, outline->name),
		.length = outline->length,
		.kind = outline->kind,
	};
	add_pieces(tools, tool, outline);
	if (tool->pieces[PIECE_CUTTER].at)
		add_tip(&tool->pieces[PIECE_CUTTER], outline);
	return true;
}

/* ----------------------------------------------------------------------- XML */

/* Rounded to what a reader of the file can check, and so that the lengths of sections still add up. */
static double shown(double value)
{
	return nearbyint(value * 1e9) / 1e9;
}

static void add_number(struct strbuf *out, const char *attribute, double value)
{
	strbuf_addf(out, " %s=\"%.12g\"", attribute, shown(value));
}

static void write_section(struct strbuf *out, const struct section_description *section)
{
	strbuf_addf(out, "<section");
	add_number(out, "length", section->length);
	add_number(out, "diameter", section->diameter);
	if (fabs(section->diameter_end.value - section->diameter) > 1e-9)
		add_number(out, "diameter_end", section->diameter_end.value);
	strbuf_addf(out, "/>");
}

static void write_piece(struct strbuf *out, const char *name, const struct piece_description *piece)
{
	static const char *const tips[] = {
		[TIP_FLAT] = "flat", [TIP_BALL] = "ball", [TIP_CONE] = "cone", [TIP_BULL] = "bull"};

	if (!piece->at)
		return;
	strbuf_addf(out, "    <%s", name);
	if (piece->has_tip && piece->tip != TIP_FLAT)
		xml_text_attribute(out, "tip", tips[piece->tip]);
	if (piece->angle.given)
		add_number(out, "angle", piece->angle.value * 180 / math_acos(-1));
	if (piece->corner.given)
		add_number(out, "corner", piece->corner.value);
	if (piece->flute_length.given)
		add_number(out, "flute_length", piece->flute_length.value);
	strbuf_addf(out, ">\n");
	for (size_t i = 0; i < piece->section_count; i++) {
		strbuf_addf(out, "      ");
		write_section(out, &piece->sections[i]);
		strbuf_addf(out, "\n");
	}
	strbuf_addf(out, "    </%s>\n", name);
}

static void write_tool(struct strbuf *out, const struct tool_description *tool)
{
	static const char *const names[TOOL_PIECES] = {
		[PIECE_HOLDER] = "holder", [PIECE_SHANK] = "shank", [PIECE_CUTTER] = "cutter"};

	strbuf_addf(out, "  <tool number=\"%ld\"", tool->number);
	if (tool->name)
		xml_text_attribute(out, "name", tool->name);
	add_number(out, "length", tool->length);
	if (tool->kind == TOOL_STANDS)
		xml_text_attribute(out, "kind", "probe");
	strbuf_addf(out, ">\n");
	for (int i = 0; i < TOOL_PIECES; i++)
		write_piece(out, names[i], &tool->pieces[i]);
	strbuf_addf(out, "  </tool>\n");
}

void import_tools_write(struct strbuf *out, const struct import_tools *tools, const char *origin)
{
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
	xml_text_comment(out, origin);
	strbuf_addf(out, "<setup version=\"1\" units=\"mm\">\n"
			 "  <!-- TODO The work offsets, fixtures and the part of the job. -->\n");
	for (size_t i = 0; i < tools->setup.tool_count; i++)
		write_tool(out, &tools->setup.tools[i]);
	strbuf_addf(out, "</setup>\n");
}
