/*
 * plain_scene.h - a scene as plain.py writes it and a path as fivecheck --dump-path prints it, with kinematics of
 * their own: nothing here comes from src, so that truth and peer can contradict it. C and C++.
 *
 * Scene, one item a line, names last as they hold blanks; link 0 is the base, link k the k-th axis:
 *   axis LETTER linear|rotary PARENT DX DY DZ LX LY LZ HOME        unit direction; mm, degrees
 *   body LINK TOOL R00 R01 R02 R10 .. R22 TX TY TZ UNIT MESH       place of a binary STL; then, on a line of its own,
 *   name NAME                                                      that of the body
 *   pair A B CLEARANCE LOOKED                                      bodies from 0, mm; LOOKED: fivecheck follows it
 */
#ifndef BENCH_PLAIN_SCENE_H
#define BENCH_PLAIN_SCENE_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AXES_MAX = 9, LINE_MAX_BYTES = 4096 };

typedef struct vec {
	double x, y, z;
} vec;

/* p -> r p + t */
typedef struct pose {
	double r[3][3];
	vec t;
} pose;

struct triangle {
	vec p[3];
};

struct axis {
	char letter;
	int rotary, parent;
	vec direction, location;
	double home;
};

struct solid {
	int link, tool;	/* tool 0: always there */
	char name[LINE_MAX_BYTES];
	struct triangle *triangles;	/* at the zero pose, mm */
	size_t count;
	vec middle;	/* of the bounds */
	double radius;	/* about it */
};

struct solid_pair {
	int a, b;
	double clearance;
	int looked;
};

struct scene {
	struct axis axes[AXES_MAX];
	int axis_count;
	struct solid *solids;
	int solid_count;
	struct solid_pair *pairs;
	int pair_count;
};

/* Where the axes stand at the end of a row, mm and degrees, in the order of the scene's axes. */
struct row {
	long line;
	int tool;
	double q[AXES_MAX];
	double time;
};

struct track {
	struct row *rows;	/* rows[0] is home at time 0 */
	size_t count;
};

static inline void die(const char *what, const char *which)
{
	fprintf(stderr, "%s: %s\n", which, what);
	exit(2);
}

static inline vec vec_of(double x, double y, double z)
{
	vec v = {x, y, z};
	return v;
}

static inline vec add(vec a, vec b)
{
	return vec_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec sub(vec a, vec b)
{
	return vec_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec times(double s, vec a)
{
	return vec_of(s * a.x, s * a.y, s * a.z);
}

static inline double dot(vec a, vec b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec cross(vec a, vec b)
{
	return vec_of(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double norm(vec a)
{
	return sqrt(dot(a, a));
}

static inline vec turn(const pose *p, vec v)
{
	return vec_of(p->r[0][0] * v.x + p->r[0][1] * v.y + p->r[0][2] * v.z,
		      p->r[1][0] * v.x + p->r[1][1] * v.y + p->r[1][2] * v.z,
		      p->r[2][0] * v.x + p->r[2][1] * v.y + p->r[2][2] * v.z);
}

static inline vec apply(const pose *p, vec v)
{
	return add(turn(p, v), p->t);
}

static inline pose unmoved(void)
{
	pose p = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
	return p;
}

/* First b, then a. */
static inline pose after(const pose *a, const pose *b)
{
	pose p;

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			p.r[i][j] = a->r[i][0] * b->r[0][j] + a->r[i][1] * b->r[1][j] + a->r[i][2] * b->r[2][j];
	p.t = apply(a, b->t);
	return p;
}

static inline pose inverse(const pose *a)
{
	pose p;

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			p.r[i][j] = a->r[j][i];
	p.t = vec_of(0, 0, 0);
	p.t = times(-1, turn(&p, a->t));
	return p;
}

/* What an axis does to what it carries: a shift, or a turn by Rodrigues' formula. */
static inline pose axis_motion(const struct axis *axis, double q)
{
	pose p = unmoved();
	double c, s, angle = q * 3.14159265358979323846 / 180;
	double d[3] = {axis->direction.x, axis->direction.y, axis->direction.z};

	if (!axis->rotary) {
		p.t = times(q, axis->direction);
		return p;
	}
	c = cos(angle);
	s = sin(angle);
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			p.r[i][j] = (i == j ? c : 0) + (1 - c) * d[i] * d[j];
	p.r[0][1] -= s * d[2];
	p.r[0][2] += s * d[1];
	p.r[1][0] += s * d[2];
	p.r[1][2] -= s * d[0];
	p.r[2][0] -= s * d[1];
	p.r[2][1] += s * d[0];
	p.t = sub(axis->location, turn(&p, axis->location));
	return p;
}

/* The poses of all links, the base first. Parents come before their children. */
static inline void link_poses(const struct scene *scene, const double *q, pose poses[AXES_MAX + 1])
{
	poses[0] = unmoved();
	for (int i = 0; i < scene->axis_count; i++) {
		pose moved = axis_motion(&scene->axes[i], q[i]);

		poses[i + 1] = after(&poses[scene->axes[i].parent], &moved);
	}
}

static inline void *grown(void *old, size_t count, size_t size)
{
	/* Room in powers of two. */
	if (count && (count & (count - 1)))
		return old;
	old = realloc(old, (count ? 2 * count : 1) * size);
	if (!old)
		die("no memory left", "scene");
	return old;
}

static inline void read_mesh(struct solid *solid, const char *file, const pose *place, double unit)
{
	FILE *in = fopen(file, "rb");
	unsigned char header[84], record[50];
	uint32_t count;
	vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};

	if (!in || fread(header, 1, 84, in) != 84)
		die("cannot be read", file);
	memcpy(&count, header + 80, 4);
	solid->count = count;
	solid->triangles = (struct triangle *)malloc(count * sizeof(struct triangle));
	for (uint32_t i = 0; i < count; i++) {
		float f[9];

		if (fread(record, 1, 50, in) != 50)
			die("is cut short", file);
		memcpy(f, record + 12, 36);
		for (int k = 0; k < 3; k++) {
			vec p = apply(place, vec_of(unit * f[3 * k], unit * f[3 * k + 1], unit * f[3 * k + 2]));

			solid->triangles[i].p[k] = p;
			low = vec_of(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
			high = vec_of(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
		}
	}
	fclose(in);
	solid->middle = times(0.5, add(low, high));
	solid->radius = 0;
	for (size_t i = 0; i < solid->count; i++)
		for (int k = 0; k < 3; k++)
			solid->radius = fmax(solid->radius, norm(sub(solid->triangles[i].p[k], solid->middle)));
}

static inline void read_body(struct solid *solid, const char *text)
{
	pose place;
	double unit;
	int at = 0;
	char mesh[LINE_MAX_BYTES];

	if (sscanf(text, "%d %d %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %n", &solid->link, &solid->tool,
		   &place.r[0][0], &place.r[0][1], &place.r[0][2], &place.r[1][0], &place.r[1][1], &place.r[1][2],
		   &place.r[2][0], &place.r[2][1], &place.r[2][2], &place.t.x, &place.t.y, &place.t.z, &unit,
		   &at) != 15)
		die("is no body", text);
	snprintf(mesh, sizeof(mesh), "%s", text + at);
	mesh[strcspn(mesh, "\n")] = 0;
	read_mesh(solid, mesh, &place, unit);
}

static inline void read_item(struct scene *scene, const char *line)
{
	struct axis *axis = &scene->axes[scene->axis_count];
	struct solid_pair pair;
	char kind[8];

	if (!strncmp(line, "axis ", 5)) {
		if (scene->axis_count == AXES_MAX ||
		    sscanf(line + 5, "%c %7s %d %lf %lf %lf %lf %lf %lf %lf", &axis->letter, kind, &axis->parent,
			   &axis->direction.x, &axis->direction.y, &axis->direction.z, &axis->location.x,
			   &axis->location.y, &axis->location.z, &axis->home) != 10)
			die("is no axis", line);
		axis->rotary = !strcmp(kind, "rotary");
		scene->axis_count++;
	} else if (!strncmp(line, "body ", 5)) {
		scene->solids =
		    (struct solid *)grown(scene->solids, (size_t)scene->solid_count, sizeof(*scene->solids));
		read_body(&scene->solids[scene->solid_count++], line + 5);
	} else if (!strncmp(line, "name ", 5) && scene->solid_count) {
		struct solid *last = &scene->solids[scene->solid_count - 1];

		snprintf(last->name, sizeof(last->name), "%s", line + 5);
		last->name[strcspn(last->name, "\n")] = 0;
	} else if (sscanf(line, "pair %d %d %lf %d", &pair.a, &pair.b, &pair.clearance, &pair.looked) == 4) {
		scene->pairs =
		    (struct solid_pair *)grown(scene->pairs, (size_t)scene->pair_count, sizeof(*scene->pairs));
		scene->pairs[scene->pair_count++] = pair;
	} else {
		die("is no item of a scene", line);
	}
}

static inline struct scene *read_scene(const char *file)
{
	struct scene *scene = (struct scene *)calloc(1, sizeof(*scene));
	FILE *in = fopen(file, "r");
	char line[LINE_MAX_BYTES];

	if (!in)
		die("cannot be read", file);
	while (fgets(line, sizeof(line), in))
		read_item(scene, line);
	fclose(in);
	return scene;
}

/* columns: of each axis of the scene, its place among the tab separated fields; the time's comes after them. */
static inline void read_header(const struct scene *scene, char *header, int columns[AXES_MAX + 1])
{
	int at = 0;

	for (char *field = strtok(header, "\t\n"); field; field = strtok(NULL, "\t\n"), at++) {
		for (int i = 0; i < scene->axis_count; i++)
			if (field[0] == scene->axes[i].letter && !field[1])
				columns[i] = at;
		if (!strcmp(field, "time"))
			columns[scene->axis_count] = at;
	}
}

static inline struct track read_track(const struct scene *scene, const char *file)
{
	FILE *in = fopen(file, "r");
	char line[LINE_MAX_BYTES];
	int columns[AXES_MAX + 1] = {0};
	struct track track = {NULL, 0};

	if (!in || !fgets(line, sizeof(line), in))
		die("cannot be read", file);
	read_header(scene, line, columns);
	track.rows = (struct row *)grown(NULL, 0, sizeof(struct row));
	memset(&track.rows[0], 0, sizeof(struct row));
	for (int i = 0; i < scene->axis_count; i++)
		track.rows[0].q[i] = scene->axes[i].home;
	track.count = 1;
	while (fgets(line, sizeof(line), in)) {
		double fields[AXES_MAX + 5];
		int count = 0;
		struct row *row;

		for (char *at = line, *end; count < AXES_MAX + 5; at = end, count++) {
			fields[count] = strtod(at, &end);
			if (end == at)
				break;
		}
		track.rows = (struct row *)grown(track.rows, track.count, sizeof(struct row));
		row = &track.rows[track.count++];
		row->line = (long)fields[0];
		row->tool = (int)fields[2];
		for (int i = 0; i < scene->axis_count; i++)
			row->q[i] = fields[columns[i]];
		row->time = fields[columns[scene->axis_count]];
	}
	fclose(in);
	return track;
}

/* Where the axes stand at share s of the row that ends the span. */
static inline void between(const struct scene *scene, const struct track *track, size_t row, double s, double *q)
{
	for (int i = 0; i < scene->axis_count; i++)
		q[i] = (1 - s) * track->rows[row - 1].q[i] + s * track->rows[row].q[i];
}

static inline int is_there(const struct scene *scene, const struct solid_pair *pair, int tool)
{
	int a = scene->solids[pair->a].tool, b = scene->solids[pair->b].tool;

	return (!a || a == tool) && (!b || b == tool);
}

#endif
