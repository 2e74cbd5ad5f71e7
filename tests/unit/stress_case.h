/* stress_case.h - an encounter of two bodies whose first contact is known, its disguises, and ways of asking for it. */
#ifndef FIVECHECK_TESTS_STRESS_CASE_H
#define FIVECHECK_TESTS_STRESS_CASE_H

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "check/check.h"
#include "first_contact.h"
#include "scene/coherence.h"

#define NEVER (-1.0)

/* Two bodies on a chain and one straight move. The case owns the meshes. */
struct stress_case {
	struct chain chain;	/* of axes with letters that suit their kind */
	struct mesh a, b;
	xform place_a, place_b;
	struct chord chord;
	double clearance, tolerance;
	double first;	/* the instant of first contact, or NEVER */
	double slack;	/* how far from it an answer may be */
};

static inline struct stress_case stress_case(double tolerance)
{
	return (struct stress_case){.place_a = xform_identity(), .place_b = xform_identity(), .tolerance = tolerance,
				    .first = NEVER, .slack = 1e-9};
}

static inline void stress_release(struct stress_case *c)
{
	mesh_release(&c->a);
	mesh_release(&c->b);
}

static inline struct mesh stress_copy(const struct mesh *mesh)
{
	struct mesh copy = {mem_alloc(mesh->count * sizeof(*mesh->triangles)), mesh->count, mesh->rounding};

	memcpy(copy.triangles, mesh->triangles, mesh->count * sizeof(*mesh->triangles));
	return copy;
}

/* -------------------------------------------------------------- disguises */

/* Another order of the triangles and of their corners, faces turned inside out at random. */
static inline void stress_shuffle(struct mesh *mesh, struct random *random)
{
	for (size_t i = 0; i < mesh->count; i++) {
		size_t j = (size_t)random_below(random, (int)i + 1);
		mesh_triangle t = mesh->triangles[i], u = t;
		int by = random_below(random, 3), flip = random_below(random, 2);

		for (int k = 0; k < 3; k++)
			memcpy(u.v[k], t.v[(by + (flip ? 3 - k : k)) % 3], sizeof(u.v[k]));
		mesh->triangles[i] = mesh->triangles[j];
		mesh->triangles[j] = u;
	}
}

/* Every triangle twice more, one of them inside out: non-manifold, and the same set of points. */
static inline void stress_triple(struct mesh *mesh)
{
	size_t count = mesh->count;

	for (size_t i = 0; i < count; i++) {
		vec3 p = mesh_corner(&mesh->triangles[i], 0), q = mesh_corner(&mesh->triangles[i], 1);
		vec3 r = mesh_corner(&mesh->triangles[i], 2);

		solid_add(mesh, p, q, r);
		solid_add(mesh, r, q, p);
	}
}

/* A power of two changes no digit. */
static inline void stress_scale(struct stress_case *c, double factor)
{
	struct mesh *meshes[2] = {&c->a, &c->b};

	for (int k = 0; k < 2; k++) {
		for (size_t i = 0; i < 9 * meshes[k]->count; i++) {
			float *coordinate = &meshes[k]->triangles[i / 9].v[i / 3 % 3][i % 3];

			*coordinate = (float)(*coordinate * factor);
		}
	}
	c->place_a.translation = vec3_scale(factor, c->place_a.translation);
	c->place_b.translation = vec3_scale(factor, c->place_b.translation);
	for (size_t i = 0; i < c->chain.count; i++) {
		struct joint *joint = &c->chain.joints[i];

		joint->location = vec3_scale(factor, joint->location);
		c->chord.q0.v[joint->slot] *= joint->rotary ? 1 : factor;
		c->chord.q1.v[joint->slot] *= joint->rotary ? 1 : factor;
	}
	c->clearance *= factor;
	c->tolerance *= factor;
}

static inline void stress_move(struct stress_case *c, vec3 by)
{
	c->place_a.translation = vec3_add(c->place_a.translation, by);
	c->place_b.translation = vec3_add(c->place_b.translation, by);
	for (size_t i = 0; i < c->chain.count; i++)
		c->chain.joints[i].location = vec3_add(c->chain.joints[i].location, by);
}

/* What stood still moves, and the other way round. */
static inline void stress_swap(struct stress_case *c)
{
	struct stress_case old = *c;

	c->a = old.b;
	c->b = old.a;
	c->place_a = old.place_b;
	c->place_b = old.place_a;
	for (size_t i = 0; i < c->chain.count; i++) {
		c->chain.joints[i] = old.chain.joints[c->chain.count - 1 - i];
		c->chain.joints[i].direction = vec3_scale(-1, c->chain.joints[i].direction);
	}
}

/* ---------------------------------------------------------------- answers */

static inline void stress_judge(const struct stress_case *c, const char *name, const char *how, bool contact, double s,
				double distance)
{
	require(contact == (c->first >= 0), "%s, %s: %s, at %.12g", name, how, contact ? "a false alarm" : "missed", s);
	if (!contact)
		return;
	require(fabs(s - c->first) <= c->slack, "%s, %s: at %.12g, not at %.12g", name, how, s, c->first);
	require(distance <= c->clearance + c->tolerance * (1 + 1e-9), "%s, %s: %.12g apart", name, how, distance);
}

/* By a sweep over both meshes, with fresh storage, and with what a first sweep remembered. */
static inline void stress_sweep(const struct stress_case *c, const char *name, const char *how)
{
	struct mesh a = stress_copy(&c->a), b = stress_copy(&c->b);
	struct sweep sweep = {0};
	struct coherence coherence = {0};
	struct contact contact = {0};
	struct duo duo;

	duo_init(&duo, &c->chain, &a, &b, &c->place_a, &c->place_b);
	for (int k = 0; k < 2; k++) {
		enum sweep_answer answer =
		    sweep_chord(&sweep, &duo.pair, &c->chord, c->clearance, c->tolerance, &contact);

		require(answer != SWEEP_UNDECIDED, "%s, %s: undecided", name, how);
		stress_judge(c, name, how, answer == SWEEP_CONTACT, contact.s, contact.distance);
		duo.pair.coherence = &coherence;
	}
	sweep_release(&sweep);
	duo_release(&duo);
}

/* ---------------------------------------------------- through files, whole */

static char stress_folder[sizeof("/tmp/fivecheck-stress-XXXXXX")];

/*
 * Fixtures of a test case: every test runs in a folder of its own, with the four files below at most. Without forks one
 * process enters a folder for each of its tests.
 */
static inline void stress_enter(void)
{
	strcpy(stress_folder, "/tmp/fivecheck-stress-XXXXXX");
	require(mkdtemp(stress_folder) && !chdir(stress_folder), "cannot make a folder");
}

static inline void stress_leave(void)
{
	static const char *const names[] = {"a.stl", "b.stl", "m.xml", "p.nc"};

	for (int k = 0; k < 4; k++)
		unlink(names[k]);
	require(!rmdir(stress_folder), "files are left in %s", stress_folder);
}

static inline void stress_write_stl(const char *path, const struct mesh *mesh)
{
	FILE *file = fopen(path, "wb");
	uint32_t count = (uint32_t)mesh->count;
	const char header[80] = "stress";

	require(file && fwrite(header, 1, 80, file) == 80 && fwrite(&count, 4, 1, file) == 1, "%s", path);
	for (size_t i = 0; i < mesh->count; i++) {
		char record[50] = {0};

		memcpy(record + 12, mesh->triangles[i].v, 36);
		require(fwrite(record, 1, 50, file) == 50, "%s", path);
	}
	require(!fclose(file), "%s", path);
}

static inline void stress_write_body(FILE *file, char name, vec3 at)
{
	fprintf(file, "<body name='%c' mesh='%c.stl' location='%.17g %.17g %.17g'/>\n", name, name, at.x, at.y, at.z);
}

/* degrees or mm, as files and programs have it */
static inline double stress_file_value(const struct joint *joint, double value)
{
	return joint->rotary ? degrees(value) : value;
}

/* m.xml and p.nc beside a.stl and b.stl */
static inline void stress_write(const struct stress_case *c)
{
	FILE *xml = fopen("m.xml", "w"), *nc = fopen("p.nc", "w");

	stress_write_stl("a.stl", &c->a);
	stress_write_stl("b.stl", &c->b);
	require(xml && nc, "cannot write here");
	fprintf(xml, "<machine version='1' units='mm'>\n<base>\n");
	stress_write_body(xml, 'a', c->place_a.translation);
	fprintf(nc, "G21 G90 G94 F1000\nG1");
	for (size_t i = 0; i < c->chain.count; i++) {
		const struct joint *joint = &c->chain.joints[i];
		double home = stress_file_value(joint, c->chord.q0.v[joint->slot]);
		char letter = AXIS_LETTERS[joint->slot];

		fprintf(xml, "<axis name='%c' type='%s' direction='%.17g %.17g %.17g' location='%.17g %.17g %.17g' ",
			letter, joint->rotary ? "rotary" : "linear", joint->direction.x, joint->direction.y,
			joint->direction.z, joint->location.x, joint->location.y, joint->location.z);
		fprintf(xml, "rate_max='1e9' home='%.17g'>\n", home);
		fprintf(nc, " %c%.20f", letter, stress_file_value(joint, c->chord.q1.v[joint->slot]));
	}
	stress_write_body(xml, 'b', c->place_b.translation);
	for (size_t i = 0; i < c->chain.count; i++)
		fprintf(xml, "</axis>");
	fprintf(xml, "\n</base>\n<pairs><pair a='a' b='b' check='always' clearance='%.17g'/></pairs>\n</machine>\n",
		c->clearance);
	fprintf(nc, "\nM2\n");
	require(!fclose(xml) && !fclose(nc), "cannot write here");
}

struct stress_found {
	long count;
	double s, distance;
};

static inline bool stress_keep(void *context, const struct finding *finding)
{
	struct stress_found *found = context;

	*found = (struct stress_found){found->count + 1, finding->fraction, finding->of.pair.clearance};
	return true;
}

static inline void stress_complain(void *context, const struct diag_entry *entry)
{
	(void)context;
	if (entry->severity == DIAG_ERROR)
		fprintf(stderr, "%s\n", entry->text);
}

/* Checks m.xml, with the setup in it, and p.nc as a user would. */
static inline struct stress_found stress_run(double tolerance, const char *name, const char *how)
{
	struct diag diag = {.handle = stress_complain};
	struct check_options options = {.tolerance = tolerance, .threads = 1};
	struct stress_found found = {0};
	const struct check_sink sink = {.context = &found, .finding = stress_keep};
	struct check_stats stats;
	enum check_result result;
	struct machine *machine;
	struct scene *scene;
	FILE *in;

	machine = machine_load("m.xml", &diag);
	require(machine, "%s, %s: the machine is refused", name, how);
	scene = scene_new(machine, machine->setup, 0, 1, &diag);
	require(scene, "%s, %s: the scene is refused", name, how);
	in = fopen("p.nc", "r");
	require(in, "p.nc");
	result = check_run(scene, &options, in, "p.nc", &sink, &diag, &stats, NULL);
	require(result != CHECK_INCOMPLETE, "%s, %s: incomplete", name, how);
	require((result == CHECK_FOUND) == (found.count > 0), "%s, %s: %ld findings", name, how, found.count);
	fclose(in);
	scene_free(scene);
	machine_free(machine);
	return found;
}

/* By reading files as a user would write them, and checking the program in them. */
static inline void stress_program(const struct stress_case *c, const char *name, const char *how)
{
	struct stress_found found;

	stress_write(c);
	found = stress_run(c->tolerance, name, how);
	stress_judge(c, name, how, found.count > 0, found.s, found.distance);
}

#endif
