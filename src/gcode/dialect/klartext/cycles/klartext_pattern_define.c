#include "gcode/dialect/klartext/cycles/klartext_pattern_define.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/cycles/klartext_points.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

enum point_word {
	WORD_X,
	WORD_Y,
	WORD_Z,
	WORD_D,
	WORD_DX,
	WORD_DY,
	WORD_NUM,
	WORD_NUMX,
	WORD_NUMY,
	WORD_ROT,
	WORD_ROTX,
	WORD_ROTY,
	WORD_START,
	WORD_STEP,
	WORD_COUNT
};

struct item {
	bool given[WORD_COUNT];
	bool increment[2]; /* IX, IY */
	double value[WORD_COUNT];
	int column;
};

/* "(X+25 Y+33.5 Z+0)" */
static bool read_item(struct lexer *lexer, struct item *item)
{
	static const char *const names[] = {"X",    "Y",    "Z",   "D",	   "DX",   "DY",    "NUM",
					    "NUMX", "NUMY", "ROT", "ROTX", "ROTY", "START", "STEP"};
	const struct interp *interp = lexer->context;

	*item = (struct item){.column = lexer_next_column(lexer)};
	while (ascii_is_digit(lexer_peek(lexer)))
		lexer_take(lexer);
	if (lexer_peek(lexer) != '(')
		return fault(lexer->at, lexer_next_column(lexer), "'(' is needed here");
	lexer_take(lexer);
	while (lexer_peek(lexer) != ')') {
		const int column = lexer_next_column(lexer);
		char name[KLARTEXT_WORD];
		int word = 0;

		klartext_word(lexer, name);
		if (!strcmp(name, "IX") || !strcmp(name, "IY"))
			item->increment[name[1] - 'X'] = true;
		while (word < WORD_COUNT && strcmp(names[word], name + (name[0] == 'I')) != 0)
			word++;
		if (word == WORD_COUNT || (name[0] == 'I' && word > WORD_Y))
			return fault(lexer->at, column, "this is no word of a pattern");
		if (!klartext_value(lexer, &item->value[word]))
			return false;
		item->given[word] = true;
		if (word <= WORD_DY)
			item->value[word] *= interp->state.scale;
	}
	lexer_take(lexer);
	return true;
}

static bool has(struct lexer *lexer, const struct item *item, const int *words, int count)
{
	for (int i = 0; i < count; i++) {
		if (!item->given[words[i]])
			return fault(lexer->at, item->column, "a word of this pattern is missing");
	}
	return true;
}

static bool find_count(struct lexer *lexer, const struct item *item, int word, int *count)
{
	const double value = item->value[word];

	if (!(value >= 1 && value <= KLARTEXT_POINTS_MAX) || !same_double(floor(value), value))
		return fault(lexer->at, item->column, "a number of points is a whole number from 1 to %d",
			     KLARTEXT_POINTS_MAX);
	*count = (int)value;
	return true;
}

/*
 * A pattern of rows, or only its edge (FRAME). ROT turns the whole about its start, ROTX only the rows, and ROTY the
 * direction from row to row. The manual does not say in which order the points of a frame come.
 */
static bool add_rows(struct lexer *lexer, const struct item *item, bool frame)
{
	static const int needed[] = {WORD_X, WORD_Y, WORD_DX, WORD_DY, WORD_NUMX, WORD_NUMY};
	struct interp *interp = lexer->context;
	const double *v = item->value;
	struct klartext_grid grid = {.start = {v[WORD_X], v[WORD_Y], v[WORD_Z]},
			    .spacing = {v[WORD_DX], v[WORD_DY]},
			    .angle = {v[WORD_ROT] + v[WORD_ROTX], v[WORD_ROT] + v[WORD_ROTY] + 90},
			    .zigzag = !frame,
			    .frame = frame};

	klartext_of(interp)->points.any_order |= frame;
	return has(lexer, item, needed, 6) && find_count(lexer, item, WORD_NUMX, &grid.count[0]) &&
	       find_count(lexer, item, WORD_NUMY, &grid.count[1]) &&
	       klartext_points_add_grid(interp, item->column, &grid);
}

/* "POS2 (X+15 IY+6.5 Z+0)": IX and IY count from the POS before this one. */
static bool add_single(struct lexer *lexer, const struct item *item)
{
	struct interp *interp = lexer->context;
	struct klartext_points *points = &klartext_of(interp)->points;
	vec3 point = {item->value[WORD_X], item->value[WORD_Y], item->value[WORD_Z]};

	if ((item->increment[0] || item->increment[1]) && !points->single)
		return fault(lexer->at, item->column, "IX and IY need another POS right before them");
	point.x += item->increment[0] ? points->items[points->count - 1].x : 0;
	point.y += item->increment[1] ? points->items[points->count - 1].y : 0;
	points->single = true;
	return klartext_points_add(interp, item->column, point);
}

/* TNC 640 user's manual, "PATTERN DEF": single points, a row, a pattern of rows, a circle, a part of a circle. */
static bool add_item(struct lexer *lexer, const char *kind, const struct item *item)
{
	struct interp *interp = lexer->context;
	const double *v = item->value;
	const vec3 start = {v[WORD_X], v[WORD_Y], v[WORD_Z]};
	const int base[] = {WORD_X, WORD_Y, WORD_D, WORD_NUM};
	int count[2] = {1, 1};

	if (!strcmp(kind, "POS"))
		return has(lexer, item, base, 2) && add_single(lexer, item);
	klartext_of(interp)->points.single = false;
	if (item->increment[0] || item->increment[1])
		return fault(lexer->at, item->column, "IX and IY belong to POS alone");
	if (!strcmp(kind, "ROW")) {
		struct klartext_grid row = {
		    .start = start, .spacing = {v[WORD_D], 0}, .angle = {v[WORD_ROT], 0}, .count = {1, 1}};

		return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &row.count[0]) &&
		       klartext_points_add_grid(interp, item->column, &row);
	}
	if (!strcmp(kind, "PAT") || !strcmp(kind, "FRAME"))
		return add_rows(lexer, item, !strcmp(kind, "FRAME"));
	if (!strcmp(kind, "CIRC"))
		return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &count[0]) &&
		       klartext_points_add_circle(interp, item->column, start, v[WORD_D], v[WORD_START],
						  360.0 / count[0], count[0]);
	return has(lexer, item, base, 4) && find_count(lexer, item, WORD_NUM, &count[0]) &&
	       klartext_points_add_circle(interp, item->column, start, v[WORD_D], v[WORD_START], v[WORD_STEP],
					  count[0]);
}

static bool read_items(struct lexer *lexer)
{
	while (!klartext_ends(lexer)) {
		const int column = lexer_next_column(lexer);
		char kind[KLARTEXT_WORD];
		struct item item;

		klartext_word(lexer, kind);
		if (strcmp(kind, "POS") != 0 && strcmp(kind, "ROW") != 0 && strcmp(kind, "PAT") != 0 &&
		    strcmp(kind, "FRAME") != 0 && strcmp(kind, "CIRC") != 0 && strcmp(kind, "PITCHCIRC") != 0)
			return fault(lexer->at, column, "PATTERN DEF reads POS, ROW, PAT, FRAME, CIRC and PITCHCIRC");
		if (!read_item(lexer, &item) || !add_item(lexer, kind, &item))
			return false;
	}
	return true;
}

bool klartext_pattern_define_read(struct lexer *lexer)
{
	struct interp *interp = lexer->context;

	if (!klartext_take(lexer, "DEF"))
		return fault(lexer->at, lexer_next_column(lexer), "PATTERN needs DEF");
	klartext_points_begin(interp);
	klartext_of(interp)->points.line = lexer->at->line;
	return read_items(lexer);
}

bool klartext_pattern_define_go_on(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	struct klartext_points *points = &klartext_of(interp)->points;

	if (points->line == 0 || lexer->at->line != points->line + 1)
		return fault(lexer->at, 1, "points of a pattern belong behind PATTERN DEF");
	points->line = lexer->at->line;
	return read_items(lexer);
}
