#include "machine/library/setup_library.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/mem.h"
#include "base/path_sandbox.h"
#include "geom/tolerance.h"
#include "machine/library/library_file.h"
#include "machine/tool_build.h"

/* ---------------------------------------------------------------- numbers */

/* A whole number, 1 or more, at *at, which moves past it; 0: there is none. */
static long read_number(const char **at)
{
	long number = 0;

	for (; **at >= '0' && **at <= '9' && number <= TOOL_NUMBER_MAX; ++*at)
		number = 10 * number + (**at - '0');
	return number <= TOOL_NUMBER_MAX ? number : 0;
}

/* Appends "7" or "10-20" at *at to the wanted numbers. */
static bool read_range(struct tool_library *tools, size_t *capacity, const char **at)
{
	struct number_range range = {.first = read_number(at)};

	range.last = range.first;
	if (**at == '-') {
		++*at;
		range.last = read_number(at);
	}
	if (range.first < 1 || range.last < range.first || (**at && **at != ' '))
		return false;
	tools->wanted = mem_grow(tools->wanted, capacity, tools->wanted_count + 1, sizeof(range));
	tools->wanted[tools->wanted_count++] = range;
	*at += strspn(*at, " ");
	return true;
}

static bool read_numbers(struct setup_description *described, const struct library_description *library,
			 struct tool_library *tools)
{
	const char *at = library->numbers;
	size_t capacity = 0;

	if (!at)
		return true;
	at += strspn(at, " ");
	while (*at && read_range(tools, &capacity, &at))
		;
	if (!*at && tools->wanted_count)
		return true;
	description_fault(&described->file, library->at, "numbers",
			  "numbers=\"%s\" of <tools> must be tool numbers and ranges of them, such as \"1 3 10-20\"",
			  description_quote(&described->file, library->at, "numbers").text);
	return false;
}

/* A number that is not in the library was a mistake. */
static void check_used(struct setup_description *described, const struct library_description *library,
		       const struct tool_library *tools)
{
	for (size_t i = 0; i < tools->wanted_count; i++) {
		const struct number_range *range = &tools->wanted[i];

		if (!range->used)
			description_fault(
			    &described->file, library->at, "numbers",
			    "%s has no usable tool %ld%s; 'fivecheck import' lists its tools",
			    library->path, range->first,
			    range->last > range->first ? " or any other tool of the range" : "");
	}
}

/* ------------------------------------------------------------------ values */

static double cutter_diameter(const struct tool_description *tool)
{
	const struct piece_description *cutter = &tool->pieces[PIECE_CUTTER];
	double largest = tool->diameter.value;

	for (size_t i = 0; i < cutter->section_count; i++)
		largest = fmax(largest, fmax(cutter->sections[i].diameter, cutter->sections[i].diameter_end.value));
	return largest;
}

/* Sets the control's values for a tool. Its diameter follows from its shape; the control may have another one. */
static void set_values(struct setup_description *described, struct tool_description *tool,
		       const struct length_offset_description *values, struct diag *diag)
{
	struct description_file *file = &described->file;
	double diameter = cutter_diameter(tool), other = 2 * values->radius.value;

	if (tool->length_offset.given && fabs(tool->length_offset.value - values->length.value) > TOOL_SUM_TOLERANCE)
		description_fault(file, values->at, "href",
				  "the table has the length %.9g mm for tool %ld, but its length_offset is %.9g mm",
				  values->length.value, tool->number, tool->length_offset.value);
	tool->length_offset = values->length;
	if (other > 0 && diameter > 0 && fabs(other - diameter) > TOOL_SUM_TOLERANCE)
		diag_warning(diag, description_place(file, values->at),
			     "the table has the diameter %.9g mm for tool %ld, but its cutter has %.9g mm; cutter "
			     "compensation uses the cutter's",
			     other, tool->number, diameter);
}

static struct tool_description *find_tool(struct setup_description *described, long number)
{
	for (size_t i = 0; i < described->tool_count; i++)
		if (described->tools[i].number == number)
			return &described->tools[i];
	return NULL;
}

/* Both arrays, one after the other, in the arena. */
static void *join(struct arena *arena, const void *first, size_t first_count, const void *second, size_t second_count,
		  size_t size)
{
	char *both = arena_alloc(arena, (first_count + second_count) * size);

	if (first_count)
		memcpy(both, first, first_count * size);
	if (second_count)
		memcpy(both + first_count * size, second, second_count * size);
	return both;
}

/* mm: radii of the table and the cutter that differ by more are not explained by wear. */
#define WEAR_MAX 0.25

/* The number of the largest difference of lengths, and how many there are. */
struct length_differences {
	size_t count;
	long number;
	double shape, table;
	const void *at;
};

static bool has_key(const struct tool_description *tool, const struct tool_values_description *row)
{
	return row->key ? tool->name && ascii_same(tool->name, row->key) : tool->number == row->number;
}

/* Two files, or a file and the setup, contradict each other. */
static void check_agreement(struct setup_description *described, const struct tool_description *tool,
			    const struct tool_values_description *row)
{
	if (tool->length_offset.given && fabs(tool->length_offset.value - row->length) > TOOL_SUM_TOLERANCE)
		description_fault(&described->file, row->at, "href",
				  "the table has the length %.9g mm for tool %ld, but its length_offset is %.9g mm",
				  row->length, tool->number, tool->length_offset.value);
	if (tool->radius_offset.given && fabs(tool->radius_offset.value - row->radius) > TOOL_SUM_TOLERANCE)
		description_fault(&described->file, row->at, "href",
				  "the table has the radius %.9g mm for tool %ld, but its radius_offset is %.9g mm",
				  row->radius, tool->number, tool->radius_offset.value);
}

/* An edge that the setup has already must agree. */
static void set_edge(struct setup_description *described, const struct tool_description *tool,
		     const struct tool_values_description *row)
{
	const struct edge_description edge = {
		.at = row->at,
		.tool = tool->number,
		.number = row->edge,
		.length = row->length,
		.diameter = {row->radius > 0, 2 * row->radius},
		.no_radius = !(row->radius > 0),
	};

	for (size_t i = 0; i < described->edge_count; i++) {
		struct edge_description *other = &described->edges[i];

		if (other->tool != edge.tool || other->number != edge.number)
			continue;
		if (other->diameter.given && fabs(other->diameter.value - 2 * row->radius) > TOOL_SUM_TOLERANCE)
			description_fault(&described->file, row->at, "href",
					  "the table has the radius %.9g mm for D%ld of tool %ld, but its <edge> has "
					  "the diameter %.9g mm",
					  row->radius, edge.number, edge.tool, other->diameter.value);
		other->diameter = edge.diameter;
		other->no_radius = edge.no_radius;
		if (fabs(other->length - edge.length) > TOOL_SUM_TOLERANCE)
			description_fault(&described->file, row->at, "href",
					  "the table has the length %.9g mm for D%ld of tool %ld, but its <edge> has "
					  "%.9g mm",
					  edge.length, edge.number, edge.tool, other->length);
		return;
	}
	described->edges = join(&described->arena, described->edges, described->edge_count, &edge, 1, sizeof(edge));
	described->edge_count++;
}

static void warn_of_edge(const struct setup_description *described, const struct tool_values_description *row,
			 long tool, const char *what, double table, double shape, struct diag *diag)
{
	diag_warning(diag, description_place(&described->file, row->at),
		     "the table has the %s %.9g mm for D%ld of tool %ld, but its shape has %.9g mm: what is outside of "
		     "the shape is not checked; describe it",
		     what, table, row->edge, tool, shape);
}

/* A shape has to enclose all edges of its tool. Other edges than the first may be higher, or thinner. */
static void check_edge(const struct setup_description *described, const struct tool_description *tool,
		       const struct tool_values_description *row, struct diag *diag)
{
	const double radius = cutter_diameter(tool) / 2;

	if (!row->part && row->length > tool->length + TOOL_SUM_TOLERANCE)
		warn_of_edge(described, row, tool->number, "length", row->length, tool->length, diag);
	if (radius > 0 && row->radius > radius + WEAR_MAX)
		warn_of_edge(described, row, tool->number, "radius", row->radius, radius, diag);
}

/* The control finds the tool by the name in its table. */
static void set_row(struct setup_description *described, struct tool_description *tool,
		    const struct tool_values_description *row, struct length_differences *differences,
		    struct diag *diag)
{
	const double radius = cutter_diameter(tool) / 2, error = fabs(tool->length - row->length);

	if (row->edge > 1) {
		set_edge(described, tool, row);
		check_edge(described, tool, row, diag);
		return;
	}
	check_agreement(described, tool, row);
	tool->length_offset = (struct optional_number){true, row->length};
	tool->radius_offset = (struct optional_number){true, row->radius};
	tool->deltas = row->deltas;
	if (row->name)
		tool->name = row->name;
	/* Another point of the tool has another length. */
	if (error > TOOL_SUM_TOLERANCE && !(row->length < 0) && !row->part) {
		if (!differences->count++ || error > fabs(differences->shape - differences->table)) {
			differences->number = tool->number;
			differences->shape = tool->length;
			differences->table = row->length;
		}
		differences->at = row->at;
	}
	if (row->radius > 0 && radius > 0 && fabs(row->radius - radius) > WEAR_MAX)
		diag_warning(diag, description_place(&described->file, row->at),
			     "the table has the radius %.9g mm for tool %ld, but its cutter has %.9g mm: is this the "
			     "same tool? The shape is checked, and the control compensates with the table's",
			     row->radius, tool->number, radius);
}

static void tell_differences(const struct setup_description *described, const struct length_differences *differences,
			     struct diag *diag)
{
	if (differences->count)
		diag_warning(diag, description_place(&described->file, differences->at),
			     "tools whose length in the table is not that of their shape: %zu; the largest difference "
			     "is that of tool %ld, %.9g mm in the table and %.9g mm in its shape: the control "
			     "compensates with the table's, and the shape is checked; make them agree",
			     differences->count, differences->number, differences->table, differences->shape);
}

/* Only the rows with a key, or only those without. */
static void spread_some(struct setup_description *described, bool keys, struct length_differences *differences,
			struct diag *diag)
{
	for (size_t i = 0; i < described->value_count; i++)
		for (size_t k = 0; keys == (described->values[i].key != NULL) && k < described->tool_count; k++)
			if (has_key(&described->tools[k], &described->values[i]))
				set_row(described, &described->tools[k], &described->values[i], differences, diag);
}

/* Puts the rows of a control's tool table into the tools, also into those of other libraries. */
static void spread_rows(struct setup_description *described, struct diag *diag)
{
	struct length_differences differences = {0};

	/* First those with a key: the others may change names. */
	spread_some(described, true, &differences, diag);
	spread_some(described, false, &differences, diag);
	tell_differences(described, &differences, diag);
}

/* Sets the values of tools, also of those from other libraries; the remaining values stay offsets. */
static void spread_values(struct setup_description *described, struct diag *diag)
{
	size_t kept = 0;

	for (size_t i = 0; i < described->length_count; i++) {
		const struct length_offset_description offset = described->lengths[i];
		struct tool_description *tool = offset.of_tool ? find_tool(described, offset.number) : NULL;

		if (tool)
			set_values(described, tool, &offset, diag);
		else
			described->lengths[kept++] = offset;
	}
	described->length_count = kept;
}


/* ------------------------------------------------------------------ joining */

/* The place of everything in a library is the <tools> that names it. */
static void set_places(struct setup_description *from, const void *at)
{
	for (size_t i = 0; i < from->tool_count; i++) {
		from->tools[i].at = at;
		for (int k = 0; k < TOOL_PIECES; k++) {
			struct piece_description *piece = &from->tools[i].pieces[k];

			piece->at = piece->at ? at : NULL;
			for (size_t s = 0; s < piece->section_count; s++)
				piece->sections[s].at = at;
		}
	}
	for (size_t i = 0; i < from->length_count; i++)
		from->lengths[i].at = at;
	for (size_t i = 0; i < from->offset_count; i++)
		from->offsets[i].at = at;
	for (size_t i = 0; i < from->value_count; i++)
		from->values[i].at = at;
}

static void take_over(struct setup_description *to, struct setup_description *from, const void *at)
{
	set_places(from, at);
	to->tools = join(&to->arena, to->tools, to->tool_count, from->tools, from->tool_count, sizeof(*to->tools));
	to->tool_count += from->tool_count;
	to->lengths = join(&to->arena, to->lengths, to->length_count, from->lengths, from->length_count,
			   sizeof(*to->lengths));
	to->length_count += from->length_count;
	to->offsets = join(&to->arena, to->offsets, to->offset_count, from->offsets, from->offset_count,
			   sizeof(*to->offsets));
	to->offset_count += from->offset_count;
	to->values = join(&to->arena, to->values, to->value_count, from->values, from->value_count,
			  sizeof(*to->values));
	to->value_count += from->value_count;
}

static bool read_library(struct setup_description *described, const struct library_description *library,
			 struct tool_library *tools, struct diag *diag)
{
	const struct library_options options = {.unit = library->unit};
	bool good;

	/* What the library allocates must live as long as the setup. */
	tools->setup.arena = described->arena;
	good = library_file_read(tools, library->path, &options, diag);
	described->arena = tools->setup.arena;
	tools->setup.arena = (struct arena){0};
	if (!good)
		description_fault(&described->file, library->at, "href", "the tools of %s cannot be read",
				  library->path);
	return good;
}

static bool is_within(struct setup_description *described, const struct library_description *library,
		      const char *root)
{
	if (path_sandbox_holds(root, library->path))
		return true;
	description_fault(&described->file, library->at, "href",
			  "the tools of %s are outside the input root %s, or a symbolic link leads outside",
			  library->path, root);
	return false;
}

static void add_library(struct setup_description *described, const struct library_description *library,
			const char *root, struct diag *diag)
{
	struct tool_library tools = {.counts_left_out = true};

	if (is_within(described, library, root) && read_numbers(described, library, &tools) &&
	    read_library(described, library, &tools, diag)) {
		take_over(described, &tools.setup, library->at);
		check_used(described, library, &tools);
	}
	free(tools.wanted);
	tool_library_release(&tools);
}

void setup_library_add(struct setup_description *described, const char *root, struct diag *diag)
{
	for (size_t i = 0; i < described->library_count; i++)
		add_library(described, &described->libraries[i], root, diag);
	if (!described->library_count)
		return;
	spread_values(described, diag);
	spread_rows(described, diag);
}
