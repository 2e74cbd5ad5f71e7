/* gcode_reach.h - what the moves of gcode_case.h reach, for moves that only together say where a tool may be. */
#ifndef GCODE_REACH_H
#define GCODE_REACH_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/strbuf.h"

/* What moves of one kind in a row reach, their spread included: "feed X -1..1 Y 0..2 Z 3..3". */
struct reach {
	char kind[8];
	double low[3], high[3], last[3];
};

/* A spread of almost nothing only says that a move is one of a set. */
static inline double no_hair(double place)
{
	return fabs(place) < 1e-6 ? 0 : place;
}

static inline void add_reach(struct strbuf *out, struct reach *reach)
{
	if (reach->kind[0])
		strbuf_addf(out, "%s X %.6g..%.6g Y %.6g..%.6g Z %.6g..%.6g\n", reach->kind,
			    no_hair(reach->low[0]), no_hair(reach->high[0]), no_hair(reach->low[1]),
			    no_hair(reach->high[1]), no_hair(reach->low[2]), no_hair(reach->high[2]));
	reach->kind[0] = '\0';
}

static inline void add_move(struct strbuf *out, struct reach *reach, const char *line)
{
	const char *spread = strstr(line, "spread");
	double at[3], beside[3] = {0};
	char kind[8];

	if (sscanf(line, "%7s %lf %lf %lf", kind, &at[0], &at[1], &at[2]) != 4) {
		add_reach(out, reach);
		strbuf_addf(out, "%s\n", line);
		return;
	}
	if (spread)
		sscanf(spread, "spread %lf %lf %lf", &beside[0], &beside[1], &beside[2]);
	if (strcmp(kind, reach->kind) != 0)
		add_reach(out, reach);
	for (int i = 0; i < 3; i++) {
		const double from = reach->kind[0] ? reach->last[i] : at[i];

		reach->low[i] = fmin(reach->kind[0] ? reach->low[i] : at[i], fmin(from, at[i]) - beside[i]);
		reach->high[i] = fmax(reach->kind[0] ? reach->high[i] : at[i], fmax(from, at[i]) + beside[i]);
		reach->last[i] = at[i];
	}
	strcpy(reach->kind, kind);
}

/* The moves of a case, `lines`, which it breaks up. */
static inline void summarise(struct strbuf *out, char *lines)
{
	struct reach reach = {.kind = ""};

	for (char *line = strtok(lines, "\n"); line; line = strtok(NULL, "\n"))
		add_move(out, &reach, line);
	add_reach(out, &reach);
}

#endif
