#include "shapes.h"

#include <cstring>
#include <fstream>
#include <stdexcept>

static const double PI = 3.14159265358979323846;

static void add_quad(Surface &surface, vec a, vec b, vec c, vec d)
{
	surface.push_back({{a, b, c}});
	surface.push_back({{a, c, d}});
}

/* Divides each face into n x n squares. */
static Surface box(const double half[3], int n)
{
	Surface surface;

	for (int face = 0; face < 6; face++) {
		int k = face / 2, i = (k + 1) % 3, j = (k + 2) % 3;
		bool upper = face % 2;
		auto at = [&](int u, int v) {
			double p[3];

			p[k] = upper ? half[k] : -half[k];
			p[i] = half[i] * (2.0 * u / n - 1);
			p[j] = half[j] * (2.0 * v / n - 1);
			return vec_of(p[0], p[1], p[2]);
		};

		for (int u = 0; u < n; u++) {
			for (int v = 0; v < n; v++) {
				vec a = at(u, v), b = at(u + 1, v), c = at(u + 1, v + 1), d = at(u, v + 1);

				upper ? add_quad(surface, a, b, c, d) : add_quad(surface, a, d, c, b);
			}
		}
	}
	return surface;
}

Surface revolved(std::vector<Ring> profile, int sides)
{
	Surface surface;

	if (profile.front().radius > 0)
		profile.insert(profile.begin(), {0, profile.front().height});
	if (profile.back().radius > 0)
		profile.push_back({0, profile.back().height});
	auto at = [&](size_t i, int side) {
		double angle = 2 * PI * (side % sides) / sides, r = profile[i].radius;

		return vec_of(r * std::cos(angle), r * std::sin(angle), profile[i].height);
	};
	for (size_t i = 0; i + 1 < profile.size(); i++) {
		for (int k = 0; k < sides; k++) {
			if (profile[i].radius > 0)
				surface.push_back({{at(i, k), at(i, k + 1), at(i + 1, k + 1)}});
			if (profile[i + 1].radius > 0)
				surface.push_back({{at(i, k), at(i + 1, k + 1), at(i + 1, k)}});
		}
	}
	return surface;
}

static Surface torus(double large, double small, int around, int across)
{
	Surface surface;
	auto at = [&](int i, int j) {
		double a = 2 * PI * (i % around) / around, b = 2 * PI * (j % across) / across;
		double r = large + small * std::cos(b);

		return vec_of(r * std::cos(a), r * std::sin(a), small * std::sin(b));
	};

	for (int i = 0; i < around; i++)
		for (int j = 0; j < across; j++)
			add_quad(surface, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
	return surface;
}

/* An L with two arms. */
static Surface angle(double a, double b, double arm_a, double arm_b, double half)
{
	const double outline[6][2] = {{0, 0}, {a, 0}, {a, arm_b}, {arm_a, arm_b}, {arm_a, b}, {0, b}};
	const int faces[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
	Surface surface;
	auto at = [&](int i, double z) { return vec_of(outline[i % 6][0] - a / 2, outline[i % 6][1] - b / 2, z); };

	for (const int *f : faces) {
		surface.push_back({{at(f[0], half), at(f[1], half), at(f[2], half)}});
		surface.push_back({{at(f[0], -half), at(f[2], -half), at(f[1], -half)}});
	}
	for (int i = 0; i < 6; i++)
		add_quad(surface, at(i, -half), at(i + 1, -half), at(i + 1, half), at(i, half));
	return surface;
}

static Surface ball(double radius, int rings, int sides)
{
	std::vector<Ring> profile;

	for (int i = 0; i <= rings; i++)
		profile.push_back({i % rings ? radius * std::sin(PI * i / rings) : 0,
				   -radius * std::cos(PI * i / rings)});
	return revolved(profile, sides);
}

Surface random_shape(Random &random, double size)
{
	/* The numbers are drawn one by one, because compilers evaluate arguments in different orders. */
	double half[3], inner[3], share = random.in(0.5, 0.95), top = random.in(-0.8, 0.8);
	double r = size * random.in(0.1, 1), h = size * random.in(0.1, 1), arms[4];
	Surface surface, cavity;
	int kind = random.below(20), sides = 3 + random.below(60), rings = 3 + random.below(10);

	for (double &x : half)
		x = size * random.in(0.2, 1);
	for (int k = 0; k < 4; k++)
		arms[k] = size * (k < 2 ? random.in(0.5, 2) : random.in(0.05, 0.4));
	if (kind < 5)
		return box(half, random.chance(0.7) ? 1 : 2 + random.below(8));
	if (kind < 8)
		return revolved({{r, -h}, {r, h}}, sides);
	if (kind < 10)
		return revolved({{r, -h}, {r * std::fmax(top, 0), h}}, sides);
	if (kind < 12)
		return ball(r, rings, 3 + sides / 2);
	if (kind < 14)
		return angle(arms[0], arms[1], arms[2], arms[3], h);
	if (kind < 15)
		return torus(half[0], 0.4 * std::fmin(r, half[0]), 3 + sides / 2, rings);
	if (kind < 17) {
		surface = box(half, 1);
		for (int k = 0; k < 3; k++)
			inner[k] = share * half[k];
		cavity = box(inner, 1);
		for (triangle &t : cavity) {
			std::swap(t.p[1], t.p[2]);
			surface.push_back(t);
		}
		return surface;
	}
	half[random.below(3)] = 0.005;
	return box(half, 1 + random.below(3));
}

void write_stl(const std::string &path, const Surface &surface)
{
	std::ofstream file(path, std::ios::binary);
	const char header[80] = "campaign";
	auto count = (uint32_t)surface.size();

	file.write(header, 80);
	file.write((const char *)&count, 4);
	for (const triangle &t : surface) {
		float numbers[12] = {0};
		char record[50] = {0};

		for (int k = 0; k < 3; k++) {
			numbers[3 + 3 * k] = (float)t.p[k].x;
			numbers[4 + 3 * k] = (float)t.p[k].y;
			numbers[5 + 3 * k] = (float)t.p[k].z;
		}
		std::memcpy(record, numbers, 48);
		file.write(record, 50);
	}
	if (!file.flush())
		throw std::runtime_error(path + ": cannot be written");
}

bool encloses(const solid &body, vec point)
{
	double sum = 0;

	for (size_t i = 0; i < body.count; i++) {
		vec a = sub(body.triangles[i].p[0], point), b = sub(body.triangles[i].p[1], point);
		vec c = sub(body.triangles[i].p[2], point);
		double x = norm(a), y = norm(b), z = norm(c);

		/* Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983. */
		sum += 2 * std::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
	}
	return std::fabs(sum) > 2 * PI;
}
