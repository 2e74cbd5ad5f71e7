#include "oracle_job.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static FILE *create(const char *folder, const char *name)
{
	char path[4096];
	FILE *out;

	snprintf(path, sizeof(path), "%s/%s", folder, name);
	out = fopen(path, "w");
	if (!out) {
		perror(path);
		exit(2);
	}
	return out;
}

static void write_machine(const struct job *job, const char *folder)
{
	FILE *out = create(folder, "m.xml");
	char tolerance[64] = "";

	if (job->tolerance > 0)
		snprintf(tolerance, sizeof(tolerance), " path_tolerance=\"%.3f\"", job->tolerance);
	fprintf(out, "<machine version=\"1\" name=\"oracle\" units=\"mm\"><controller dialect=\"linuxcnc\" "
		"rapid=\"linear\"%s/><base>\n", tolerance);
	for (int i = 0; i < 3; i++)
		fprintf(out, "<axis name=\"%c\" type=\"linear\" direction=\"%d %d %d\" limit_min=\"-500\" "
			"limit_max=\"500\" rate_max=\"6000\"%s>", "XYZ"[i], i == 0, i == 1, i == 2,
			i == 2 ? " home=\"80\"" : "");
	fprintf(out, "<spindle location=\"0 0 100\" direction=\"0 0 -1\"/></axis></axis></axis>\n<axis name=\"B\" "
		"type=\"rotary\" direction=\"0 1 0\" location=\"0 0 0\" limit_min=\"-180\" limit_max=\"180\" "
		"rate_max=\"3600\"><workholding location=\"0 0 0\"/></axis></base></machine>\n");
	fclose(out);
}

static void write_setup(const struct job *job, const char *folder, const char *name, bool second)
{
	const struct tool *tool = &job->tools[0];
	const double feeler = job->tools[1].radius[CUTTER], foot[3] = {0, 0, -0.5 * job->size[2]};
	FILE *out = create(folder, name);
	char blank[4096];
	double at[3];

	job_from_blank(job, foot, at);
	/* How exactly the second blank is known does not matter: excess makes all its findings possible only. */
	if (second)
		snprintf(blank, sizeof(blank), "mesh=\"rest.stl\" excess=\"5\"");
	else
		snprintf(blank, sizeof(blank), "box=\"%.3f %.3f %.3f\"", job->size[0], job->size[1], job->size[2]);
	fprintf(out, "<setup version=\"1\" units=\"mm\" initial_tool=\"1\">\n<work_offset name=\"G54\" Z=\"-100\"/>\n"
		"<stock %s location=\"%.9f %.9f %.9f\" rotation=\"%.3f %.3f %.3f\" rapid_allowance=\"%.3f\"/>\n",
		blank, at[0], at[1], at[2], job->angles[0], job->angles[1], job->angles[2], job->allowance);
	fprintf(out, "<tool number=\"1\" length=\"100\"><holder><section length=\"%.6f\" diameter=\"%.6f\"/></holder>"
		"<shank><section length=\"%.6f\" diameter=\"%.6f\"/></shank>", tool->length[HOLDER],
		2 * tool->radius[HOLDER], tool->length[SHANK], 2 * tool->radius[SHANK]);
	tool_write_cutter(tool, out);
	fprintf(out, "</tool>\n<tool number=\"2\" length=\"100\" kind=\"probe\"><cutter tip=\"ball\">"
		"<section length=\"%.6f\" diameter=\"0.15\"/><section length=\"%.6f\" diameter=\"%.6f\"/></cutter>"
		"</tool></setup>\n", 100 - 2 * feeler, 2 * feeler, 2 * feeler);
	fclose(out);
}

/* X, Y and Z are those of the workpiece at rotary zero where the tip is guided. */
static void write_move(const struct job *job, const struct move *m, const double from[4], FILE *out)
{
	double at[3];

	memcpy(at, m->to, sizeof(at));
	if (job->guided)
		job_to_work(m->to, m->to[3], at);
	if (m->bounded)
		fprintf(out, "G38.3 X%.3f Y%.3f Z%.3f ", at[0], at[1], at[2]);
	else if (m->way == ARC)
		fprintf(out, "G%d X%.3f Y%.3f Z%.3f I%.3f J%.3f ", m->sweep > 0 ? 3 : 2, at[0], at[1], at[2],
			m->centre[0] - from[0], m->centre[1] - from[1]);
	else
		fprintf(out, "G%d X%.3f Y%.3f Z%.3f B%.3f ", !m->rapid, at[0], at[1], at[2], m->to[3]);
	fprintf(out, "%s\n", m->turning ? "M3" : "M5");
}

static void write_program(struct job *job, const char *folder, const char *name, int first, int end)
{
	const char *length = job->guided ? "G43.4" : "G43";
	FILE *out = create(folder, name);
	int line = 3;

	fprintf(out, "G21 G90 G94 %s F600 S1000 M3\n%s H1\n", job->tolerance > 0 ? "G64" : "G61", length);
	for (int i = first; i < end; i++) {
		struct move *m = &job->moves[i];
		double from[4];

		if (m->tool && !m[-1].tool) {
			fprintf(out, "G49\nT2 M6\n%s H2\n", length);
			line += 3;
		}
		job_start(job, i, from);
		write_move(job, m, from, out);
		m->line = line++;
	}
	fclose(out);
}

void job_write(struct job *job, const char *folder)
{
	char path[4096];

	write_machine(job, folder);
	write_setup(job, folder, "s.xml", false);
	write_program(job, folder, "p.nc", 0, job->split ? job->split : job->count);
	if (!job->split)
		return;
	snprintf(path, sizeof(path), "%s/rest.stl", folder);
	remove(path);
	write_setup(job, folder, "s2.xml", true);
	write_program(job, folder, "p2.nc", job->split, job->count);
}
