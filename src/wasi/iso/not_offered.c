/*
 * not_offered.c - in place of what the page does not offer: formats that CI servers read, --glb, --explain, --jobs,
 * --sensitivity, and pictures of the axes.
 */
#include "check/measure/sensitivity.h"
#include "cli/explain.h"
#include "cli/jobs.h"
#include "report/glb/glb.h"
#include "report/picture/axis_picture.h"
#include "report/writers/writers.h"
#include "wasi/other_module.h"

static void begin(struct strbuf *out, const struct report_run *run)
{
	(void)out;
	(void)run;
	other_module();
}

const struct report_writer junit_writer = {.name = "junit", .begin = begin};
const struct report_writer sarif_writer = {.name = "sarif", .begin = begin};
const struct report_writer github_writer = {.name = "github", .begin = begin};

void glb_add(struct strbuf *out, const struct glb_scene *scene)
{
	(void)out;
	(void)scene;
	other_module();
}

bool explain_add(struct strbuf *out, const struct options *options, struct diag *diag)
{
	(void)out;
	(void)options;
	(void)diag;
	other_module();
}

enum run_status jobs_run(const struct options *options, struct stderr_ui *ui)
{
	(void)options;
	(void)ui;
	other_module();
}

size_t sensitivity_run(const struct sensitivity_study *study, const struct check_sink *sink, struct diag *diag,
		       struct sensitivity answers[2 * CHANGES])
{
	(void)study;
	(void)sink;
	(void)diag;
	(void)answers;
	other_module();
}

/* Not reached: no answers are made. */
void sensitivity_release(struct sensitivity *answers, size_t count)
{
	(void)answers;
	(void)count;
}

void axis_pictures_init(struct axis_pictures *pictures, const struct scene *scene)
{
	(void)pictures;
	(void)scene;
	other_module();
}

void axis_pictures_add(struct strbuf *out, const struct axis_pictures *pictures, int axis, const char *title)
{
	(void)out;
	(void)pictures;
	(void)axis;
	(void)title;
	other_module();
}
