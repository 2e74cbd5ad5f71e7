/* recorded_findings.h - the findings of a program, each with what a report needs to show and to draw it. */
#ifndef FIVECHECK_REPORT_HTML_RECORDED_FINDINGS_H
#define FIVECHECK_REPORT_HTML_RECORDED_FINDINGS_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "check/finding.h"
#include "report/report.h"
#include "scene/scene.h"
#include "scene/sweep.h"

struct recorded_finding {
	json_t *object;	/* as in NDJSON; owned */
	char *message;	/* owned */
	char *file, *text;	/* owned; the text of the block */
	enum finding_kind kind;
	enum finding_status status;
	long line, block;	/* number of the block, from 1; 0: not known */
	double time, fraction;
	double stock_time;	/* as in the finding */
	axis_values axes;
	int tool;
	int a, b;	/* bodies; -1 for a limit */
	int link;	/* of the axis that leaves its travel; 0: no limit */
	vec3 point;	/* machine coordinates; not of a limit */
	bool has_triangles;	/* false: a limit, or one of the bodies is the stock */
	vec3 triangles[2][3];	/* of a and of b, machine coordinates at the finding's pose */
};

/* All zero is empty. */
struct recorded_findings {
	struct recorded_finding *items;	/* the first FINDINGS_MAX (report_data.h) */
	size_t count, capacity;
	long left_out;
};

/* Adds a finding of the block with this number, from 1; 0: not known. `sweep` finds the triangles. */
void recorded_findings_add(struct recorded_findings *findings, struct scene *scene, struct sweep *sweep,
			   const struct finding *finding, struct finding_style style, long block);

/* The first finding that fails the run, else the first one; NULL: there is none. */
const struct recorded_finding *recorded_findings_first(const struct recorded_findings *findings);

void recorded_findings_release(struct recorded_findings *findings);

#endif
