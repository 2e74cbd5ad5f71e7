/* test_report_mesh.c - the meshes and the text of a report, read back according to the descriptions in src/report. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "geom/mesh.h"
#include "report/format/seven_bit.h"
#include "report/html/pack_mesh.h"

#include "random.h"
#include "solids.h"
#include "suite.h"

/* -------------------------------------------------------------------- text */

static const unsigned char reserved[8] = {0, 13, 14, 15, 26, 27, 60, 127};

/* Reads the text back. The result is the number of bytes. */
static size_t read_text(const struct strbuf *text, unsigned char *bytes)
{
	size_t bits = 0;

	memset(bytes, 0, text->length + 1);
	for (size_t i = 0; i < text->length; i++) {
		unsigned c = (unsigned char)text->text[i], groups[2], count = 1;

		ck_assert(c >= 128 || !memchr(reserved, (int)c, sizeof(reserved)));
		groups[0] = c;
		if (c >= 128) {
			c = (c & 31) << 6 | ((unsigned char)text->text[++i] & 63);
			count = c < 0x500 ? 2 : 1;
			groups[0] = reserved[c < 0x500 ? (c - 0x100) / 128 : c - 0x500];
			groups[1] = c & 127;
		}
		for (unsigned g = 0; g < count; g++) {
			for (int bit = 6; bit >= 0; bit--, bits++)
				bytes[bits / 8] |= (unsigned char)((groups[g] >> bit & 1) << (7 - bits % 8));
		}
	}
	return bits / 8;
}

START_TEST(bytes_come_back_from_text)
{
	enum { MOST = 300 };
	struct random random = random_case(11, (unsigned)_i);
	unsigned char bytes[MOST], back[2 * MOST + 2];
	const size_t count = (size_t)_i;
	struct strbuf text = {0};

	/* Many of the reserved groups, at all places. */
	for (size_t i = 0; i < count; i++)
		bytes[i] = _i % 3 == 0 ? 0 : _i % 3 == 1 ? 255 : (unsigned char)random_bits(&random);
	seven_bit_add(&text, bytes, count);
	/* Seven bytes are eight characters; a reserved group at the end may need one more. */
	ck_assert_uint_ge(text.length, (8 * count + 6) / 7);
	ck_assert_uint_le(text.length, (8 * count + 6) / 7 + 1);
	ck_assert_uint_eq(read_text(&text, back), count);
	ck_assert(!memcmp(bytes, back, count));
	strbuf_release(&text);
}
END_TEST

/* ------------------------------------------------------------------ reader */

struct model {
	uint32_t p;
	int seen;
};

struct numbers {
	struct model length[40], top[40][3];
};

/* The state of reading a mesh, as report_data.h describes it. Edges are looked up in a square table. */
struct reader {
	const unsigned char *bytes;
	size_t count, at;
	uint64_t code, range;
	size_t most;	/* vertices */
	bool *open;	/* [from * most + to] */
	long *before, *after;
	int (*points)[3];
	size_t seen;
	size_t (*corners)[3];
	size_t triangles;
	size_t gates[1 << 14][3], depth;
	int history;
	struct {
		int step[3], run;
	} memory[1 << 14];
	uint32_t hashes[2];
	int values[3][1 << 12];
	int value_counts[3];
	struct model begins[3], beyond[5][2][2][125], again[8], equal[3][3][4][3], known[3][4];
	struct numbers back, back_at_start, rank[3], residual[3];
};

static bool read_bit(struct reader *r, struct model *model)
{
	const uint64_t p = model->p ? model->p : 32768, bound = (r->range >> 16) * p;
	const bool bit = r->code < bound;
	int shift = 1;

	while (shift < 5 && (model->seen + 1) >> shift)
		shift++;
	r->code -= bit ? 0 : bound;
	r->range = bit ? bound : r->range - bound;
	model->p = (uint32_t)(bit ? p + ((65536 - p) >> shift) : p - (p >> shift));
	model->p = model->p < 32 ? 32 : model->p > 65504 ? 65504 : model->p;
	model->seen++;
	for (; r->range < 1 << 24; r->range <<= 8, r->at++)
		r->code = r->code << 8 | (r->at < r->count ? r->bytes[r->at] : 0);
	return bit;
}

static long read_number(struct reader *r, struct numbers *model)
{
	long value = 1;
	int length = 1;

	while (read_bit(r, &model->length[length]))
		ck_assert_int_lt(++length, 34);
	for (int i = 1; i < length; i++) {
		struct model even = {0};

		value = 2 * value + read_bit(r, i == 1 ? &model->top[length][0] : i == 2 ? &model->top[length][1 + value % 2] : &even);
	}
	return value - 1;
}

static int unzigzag(long z)
{
	return (int)(z % 2 ? -(z + 1) / 2 : z / 2);
}

static bool *edge(struct reader *r, size_t from, size_t to)
{
	return &r->open[from * r->most + to];
}

static void take(struct reader *r, size_t a, size_t b, size_t c)
{
	const size_t edges[3][2] = {{a, b}, {b, c}, {c, a}}, gates[3][3] = {{b, a, c}, {a, c, b}, {c, b, a}};

	memcpy(r->corners[r->triangles++], (size_t[3]){a, b, c}, sizeof(*r->corners));
	for (int i = 0; i < 3; i++) {
		const size_t u = edges[i][0], v = edges[i][1];

		if (*edge(r, u, v)) {
			*edge(r, u, v) = false;
		} else {
			*edge(r, v, u) = true;
			r->after[v] = (long)u;
			r->before[u] = (long)v;
		}
	}
	memcpy(r->gates[r->depth], gates, sizeof(gates));
	r->depth += 3;
}

static int read_value(struct reader *r, int corner, int k, int e, int guess)
{
	int *values = r->values[k], *count = &r->value_counts[k], i = 0, value;

	if (read_bit(r, &r->known[k][e])) {
		while (i < *count && values[i] < guess)
			i++;
		return values[i + unzigzag(read_number(r, &r->rank[corner]))];
	}
	value = guess + unzigzag(read_number(r, &r->residual[corner]));
	for (i = (*count)++; i > 0 && values[i - 1] > value; i--)
		values[i] = values[i - 1];
	values[i] = value;
	return value;
}

static size_t read_vertex(struct reader *r, int corner, int near[3][3], int near_count)
{
	const uint32_t place = (31 * r->hashes[0] + r->hashes[1]) * 0x9e3779b1U >> 18;
	int *q = r->points[r->seen], *run = &r->memory[place].run, *step = r->memory[place].step, e = 0;

	if (read_bit(r, &r->again[*run])) {
		for (int k = 0; k < 3; k++)
			q[k] = near[0][k] + step[k];
		*run = *run < 7 ? *run + 1 : 7;
	} else {
		*run = 1;
		for (int k = 0; k < 3; k++) {
			bool found = false;

			for (int i = 0; i < near_count && !found; i++) {
				bool before = false;

				for (int other = 0; other < i; other++)
					before = before || near[other][k] == near[i][k];
				found = !before && read_bit(r, &r->equal[corner][k][e][i]);
				q[k] = near[i][k];
			}
			if (!found)
				q[k] = read_value(r, corner, k, e, near_count < 3 ? near[0][k] : near[0][k] + near[1][k] - near[2][k]);
			e = (2 * e + found) % 4;
		}
	}
	for (int k = 0; k < 3; k++)
		step[k] = q[k] - near[0][k];
	r->hashes[1] = r->hashes[0];
	r->hashes[0] = (uint32_t)step[0] * 73856093U ^ (uint32_t)step[1] * 19349663U ^ (uint32_t)step[2] * 83492791U;
	return r->seen++;
}

static void read_begin(struct reader *r)
{
	size_t v[3];

	for (int k = 0; k < 3; k++) {
		int near[3][3] = {{0}};

		if (!read_bit(r, &r->begins[k])) {
			v[k] = r->seen - 1 - (size_t)read_number(r, &r->back_at_start);
			continue;
		}
		if (k || r->seen)
			memcpy(near[0], r->points[k ? v[k - 1] : r->seen - 1], sizeof(near[0]));
		if (k)
			memcpy(near[1], r->points[v[0]], sizeof(near[1]));
		v[k] = read_vertex(r, k, near, k == 2 ? 2 : 1);
	}
	take(r, v[0], v[1], v[2]);
}

static void read_beyond(struct reader *r, size_t a, size_t b, size_t o)
{
	const long x = r->before[a], y = r->after[b];
	const bool has_x = x >= 0 && (size_t)x != b && *edge(r, (size_t)x, a), has_y = y >= 0 && (size_t)y != a && *edge(r, b, (size_t)y);
	static const int asked[] = {1, 2, 3, 0};
	int answer = 4, near[3][3];
	size_t c;

	for (int i = 0; i < 4 && answer == 4; i++) {
		if ((asked[i] == 2 && !has_x) || (asked[i] == 3 && !has_y))
			continue;
		if (read_bit(r, &r->beyond[asked[i]][has_x][has_y][r->history]))
			answer = asked[i];
	}
	r->history = (5 * r->history + answer) % 125;
	*edge(r, a, b) = answer != 0;
	if (!answer)
		return;
	memcpy(near[0], r->points[b], sizeof(near[0]));
	memcpy(near[1], r->points[a], sizeof(near[1]));
	memcpy(near[2], r->points[o], sizeof(near[2]));
	c = answer == 1 ? read_vertex(r, 2, near, 3) : answer == 2 ? (size_t)x : answer == 3 ? (size_t)y
	    : r->seen - 1 - (size_t)read_number(r, &r->back);
	take(r, a, b, c);
}

/* The corners of all triangles, in mm. */
static vec3 *read_mesh(const struct strbuf *bytes, const struct packed_mesh *packed)
{
	struct reader *r = mem_zalloc(1, sizeof(*r));
	vec3 *out = mem_alloc(3 * packed->triangles * sizeof(*out));

	r->bytes = (const unsigned char *)bytes->text;
	r->count = bytes->length;
	r->range = UINT32_MAX;
	for (r->at = 1; r->at < 5; r->at++)
		r->code = r->code << 8 | r->bytes[r->at];
	r->most = packed->vertices;
	r->open = mem_zalloc(r->most * r->most, sizeof(*r->open));
	r->before = mem_alloc(r->most * sizeof(*r->before));
	r->after = mem_alloc(r->most * sizeof(*r->after));
	for (size_t i = 0; i < r->most; i++)
		r->before[i] = r->after[i] = -1;
	r->points = mem_zalloc(r->most + 1, sizeof(*r->points));
	r->corners = mem_alloc(packed->triangles * sizeof(*r->corners));
	while (r->triangles < packed->triangles) {
		for (read_begin(r); r->depth;) {
			const size_t *gate = r->gates[--r->depth];

			if (*edge(r, gate[0], gate[1]))
				read_beyond(r, gate[0], gate[1], gate[2]);
		}
	}
	ck_assert_uint_eq(r->triangles, packed->triangles);
	ck_assert_uint_eq(r->seen, packed->vertices);
	for (size_t i = 0; i < 3 * packed->triangles; i++) {
		const int *q = r->points[r->corners[i / 3][i % 3]];

		out[i] = vec3_add(packed->origin, vec3_scale(packed->step, (vec3){q[0], q[1], q[2]}));
	}
	free(r->open);
	free(r->before);
	free(r->after);
	free(r->points);
	free(r->corners);
	free(r);
	return out;
}

/* ------------------------------------------------------------------ meshes */

/* A grid of squares on a wavy surface, as separate triangles. */
static struct mesh wavy(size_t n)
{
	struct mesh mesh = {.triangles = mem_alloc(2 * n * n * sizeof(mesh_triangle)), .count = 2 * n * n};

	for (size_t i = 0; i < 2 * n * n; i++) {
		static const int corners[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};

		for (int k = 0; k < 3; k++) {
			const double x = (double)(i / 2 % n) + corners[i % 2][k][0], y = (double)(i / 2 / n) + corners[i % 2][k][1];

			mesh.triangles[i].v[k][0] = (float)(3 * x);
			mesh.triangles[i].v[k][1] = (float)(2 * y);
			mesh.triangles[i].v[k][2] = (float)(5 * sin(x) * cos(y));
		}
	}
	return mesh;
}

/*
 * The distance of this triangle from the nearest packed triangle, at the worst corner; the first corner may be any of
 * the three.
 */
static double nearest(const vec3 *corners, size_t triangles, const vec3 p[3])
{
	double best = INFINITY;

	for (size_t t = 0; t < triangles; t++) {
		for (size_t turn = 0; turn < 3; turn++) {
			double worst = 0;

			for (size_t k = 0; k < 3; k++)
				worst = fmax(worst, vec3_norm(vec3_sub(corners[3 * t + (k + turn) % 3], p[k])));
			best = fmin(best, worst);
		}
	}
	return best;
}

START_TEST(every_triangle_of_a_mesh_is_packed_with_its_sense)
{
	const xform place = xform_turn((vec3){1, 2, 3}, (vec3){0, 0.6, 0.8}, 0.7);
	struct mesh mesh = wavy(12);
	struct packed_mesh packed;
	struct strbuf bytes = {0};
	vec3 *corners;

	pack_mesh_add(&bytes, &mesh, &place, &packed);
	ck_assert_uint_eq(packed.triangles, mesh.count);
	ck_assert_uint_eq(packed.vertices, 13 * 13);
	corners = read_mesh(&bytes, &packed);
	for (size_t i = 0; i < mesh.count; i++) {
		vec3 p[3];

		for (int k = 0; k < 3; k++)
			p[k] = xform_apply(&place, mesh_corner(&mesh.triangles[i], k));
		ck_assert_double_le(nearest(corners, packed.triangles, p), PACK_MESH_ERROR * packed.step);
	}
	free(corners);
	strbuf_release(&bytes);
	mesh_release(&mesh);
}
END_TEST

/*
 * A point of a sphere of 100 mm about the origin. `uneven` shifts it, at most by this share of the distance to the next
 * point.
 */
static vec3 on_sphere(size_t rings, size_t ring, size_t place, double uneven)
{
	const size_t k = ring % rings ? place % (2 * rings) : 0;
	const double by = uneven * sin(1000 * (double)(7 * ring + 3 * k)), step = PI / (double)rings;
	const double tilt = step * ((double)ring + (ring % rings ? by : 0)), turn = step * ((double)k - by);

	return (vec3){100 * sin(tilt) * cos(turn), 100 * sin(tilt) * sin(turn), 100 * cos(tilt)};
}

static struct mesh sphere(size_t rings, double uneven)
{
	struct mesh mesh = {0};

	for (size_t ring = 0; ring < rings; ring++) {
		for (size_t k = 0; k < 2 * rings; k++) {
			const vec3 a = on_sphere(rings, ring, k, uneven), b = on_sphere(rings, ring + 1, k, uneven);
			const vec3 c = on_sphere(rings, ring + 1, k + 1, uneven), d = on_sphere(rings, ring, k + 1, uneven);

			if (ring + 1 < rings)
				solid_add(&mesh, a, b, c);
			if (ring)
				solid_add(&mesh, a, c, d);
		}
	}
	return mesh;
}

/* In a page each byte has seven bits of the packed mesh (seven_bit.h). */
static double bytes_for_a_triangle(const struct mesh *mesh)
{
	const xform place = xform_identity();
	struct packed_mesh packed;
	struct strbuf bytes = {0};
	double result;

	pack_mesh_add(&bytes, mesh, &place, &packed);
	ck_assert_uint_eq(packed.triangles, mesh->count);
	result = 8.0 / 7 * (double)bytes.length / (double)mesh->count;
	strbuf_release(&bytes);
	return result;
}

/* A mesh in a report needs at most 2 bytes per triangle, even a body of 50,000 triangles that are all different. */
START_TEST(a_sphere_needs_at_most_two_bytes_for_a_triangle)
{
	static const struct {
		size_t rings;
		double uneven, most;
	} cases[] = {{16, 0, 1}, {50, 0, 1}, {112, 0, 1}, {112, 0.2, 2}};
	struct mesh mesh = sphere(cases[_i].rings, cases[_i].uneven);

	ck_assert_uint_eq(mesh.count, 4 * cases[_i].rings * (cases[_i].rings - 1));
	ck_assert_double_le(bytes_for_a_triangle(&mesh), cases[_i].most);
	mesh_release(&mesh);
}
END_TEST

START_TEST(a_mesh_needs_at_most_a_byte_and_a_quarter_for_a_triangle)
{
	struct mesh mesh = wavy(60);

	ck_assert_double_le(7.0 / 8 * bytes_for_a_triangle(&mesh), 1.25);
	mesh_release(&mesh);
}
END_TEST

/*
 * Triangles between few points: edges with one, two or many triangles, and triangles that occur twice, in either
 * direction.
 */
START_TEST(a_heap_of_triangles_comes_back)
{
	enum { MOST = 200 };
	struct random random = random_case(12, _i);
	const xform place = xform_identity();
	struct mesh mesh = {.triangles = mem_alloc(MOST * sizeof(mesh_triangle)), .count = (size_t)(1 + random_below(&random, MOST))};
	float points[24][3];
	struct packed_mesh packed;
	struct strbuf bytes = {0};
	vec3 *corners;

	for (int i = 0; i < 24; i++) {
		for (int k = 0; k < 3; k++)
			points[i][k] = (float)random_below(&random, _i % 2 ? 4 : 60000);
	}
	for (size_t i = 0; i < mesh.count; i++) {
		const int first = random_below(&random, 24), by = 1 + random_below(&random, 7);

		for (int k = 0; k < 3; k++)
			memcpy(mesh.triangles[i].v[k], points[(first + k * by) % 24], sizeof(points[0]));
	}
	pack_mesh_add(&bytes, &mesh, &place, &packed);
	corners = read_mesh(&bytes, &packed);
	for (size_t i = 0; i < mesh.count; i++) {
		vec3 p[3];

		for (int k = 0; k < 3; k++)
			p[k] = mesh_corner(&mesh.triangles[i], k);
		if (vec3_norm(vec3_sub(p[0], p[1])) > 0 && vec3_norm(vec3_sub(p[1], p[2])) > 0 && vec3_norm(vec3_sub(p[2], p[0])) > 0)
			ck_assert_double_le(nearest(corners, packed.triangles, p), PACK_MESH_ERROR * packed.step);
	}
	free(corners);
	strbuf_release(&bytes);
	mesh_release(&mesh);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("report_mesh");

	tcase_add_loop_test(tcase, bytes_come_back_from_text, 0, 40);
	tcase_add_test(tcase, every_triangle_of_a_mesh_is_packed_with_its_sense);
	tcase_add_test(tcase, a_mesh_needs_at_most_a_byte_and_a_quarter_for_a_triangle);
	tcase_add_loop_test(tcase, a_sphere_needs_at_most_two_bytes_for_a_triangle, 0, 4);
	tcase_add_loop_test(tcase, a_heap_of_triangles_comes_back, 0, 60);
	return run_suite("report_mesh", tcase);
}
