#include "report/picture/axis_picture.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "machine/chain.h"
#include "report/format/html_text.h"
#include "report/picture/contours.h"
#include "report/picture/stage_camera.h"
#include "report/picture/svg_areas.h"

enum { WIDTH = 960, HEIGHT = 640, ARC_STEPS = 24 };

/* mm: the assumed size of a machine without bodies. */
#define LEAST_SIZE 400

#define TURN (30 * 3.14159265358979323846 / 180)

/* ------------------------------------------------------------------- camera */

/* Bounds in the camera's directions: right, up, toward. */
struct bounds {
	vec3 least, greatest;
};

static void extend(struct bounds *bounds, const struct camera *camera, vec3 p)
{
	const vec3 seen = {vec3_dot(p, camera->right), vec3_dot(p, camera->up), vec3_dot(p, camera->toward)};

	bounds->least = vec3_min(bounds->least, seen);
	bounds->greatest = vec3_max(bounds->greatest, seen);
}

/* A point of the link's geometry at the positions of the axes. */
static vec3 place(const struct machine *machine, int link, const axis_values *axes, vec3 p)
{
	const xform pose = machine_pose(machine, link, axes);

	return xform_apply(&pose, p);
}

static void extend_by_all(struct bounds *bounds, const struct axis_pictures *pictures, const axis_values *axes)
{
	const struct machine *machine = pictures->scene->machine;

	for (size_t i = 0; i < pictures->scene->body_count; i++) {
		const struct scene_body *it = &pictures->scene->bodies[i];
		const xform link = machine_pose(machine, it->body->link, axes);
		const xform pose = xform_mul(&link, &it->body->placement);

		for (size_t t = 0; it->bvh && t < it->bvh->mesh.count; t++)
			for (int k = 0; k < 3; k++)
				extend(bounds, &pictures->camera,
				       xform_apply(&pose, mesh_corner(&it->bvh->mesh.triangles[t], k)));
	}
	if (machine->spindle.present)
		extend(bounds, &pictures->camera,
		       place(machine, machine->spindle.link, axes, machine->spindle.location));
	if (machine->workholding.present)
		extend(bounds, &pictures->camera,
		       place(machine, machine->workholding.link, axes, machine->workholding.frame.translation));
}

/* The largest of 1, 2, 5, 10, 20 and so on that is not above the length, which is 1 or more. */
static double round_down(double length)
{
	double decade = 1;

	while (10 * decade <= length)
		decade *= 10;
	return decade * (5 * decade <= length ? 5 : 2 * decade <= length ? 2 : 1);
}

/* The motion begins at 0 if the travel permits it. */
static struct axis_motion motion_of(const struct axis *axis, double length)
{
	const double least = axis->limit_min, most = axis->limit_max, amount = fmin(length, most - least);
	double from = fmin(fmax(0, least), most);

	if (from + amount > most)
		from = most - amount;
	return (struct axis_motion){from, from + amount};
}

static axis_values only(const struct axis *axis, double value)
{
	axis_values axes = {{0}};

	axes.v[axis->slot] = value;
	return axes;
}

void axis_pictures_init(struct axis_pictures *pictures, const struct scene *scene)
{
	const vec3 far = {INFINITY, INFINITY, INFINITY};
	const axis_values zero = {{0}};
	struct bounds bounds = {far, vec3_scale(-1, far)};
	struct camera *camera = &pictures->camera;
	vec3 middle;

	*pictures = (struct axis_pictures){.scene = scene, .camera = camera_usual()};
	extend(&bounds, camera, (vec3){0, 0, 0});
	extend_by_all(&bounds, pictures, &zero);
	pictures->size = fmax(LEAST_SIZE, fmax(bounds.greatest.x - bounds.least.x, bounds.greatest.y - bounds.least.y));
	for (size_t i = 0; i < scene->machine->axis_count; i++) {
		const struct axis *axis = &scene->machine->axes[i];
		struct axis_motion *motion = &pictures->motions[i];
		axis_values ends[2];

		*motion = motion_of(axis, axis->rotary ? TURN : round_down(0.2 * pictures->size));
		ends[0] = only(axis, motion->from);
		ends[1] = only(axis, motion->to);
		extend_by_all(&bounds, pictures, &ends[0]);
		extend_by_all(&bounds, pictures, &ends[1]);
	}
	middle = vec3_lerp(bounds.least, bounds.greatest, 0.5);
	camera->centre = vec3_add(vec3_add(vec3_scale(middle.x, camera->right), vec3_scale(middle.y, camera->up)),
				  vec3_scale(middle.z, camera->toward));
	/* Marks and arrows need some space beside the bodies. */
	camera->scale = 1 / (1.25 * fmax(LEAST_SIZE, fmax(bounds.greatest.x - bounds.least.x,
							  (bounds.greatest.y - bounds.least.y) * WIDTH / HEIGHT)));
}

/* -------------------------------------------------------------------- arrows */

struct sketch {
	struct strbuf *out;
	const struct axis_pictures *pictures;
	const char *colour;
};

static vec3 project(const struct sketch *sketch, vec3 p)
{
	return camera_project(&sketch->pictures->camera, &(struct raster){.width = WIDTH, .height = HEIGHT}, p);
}

/* A line through the points with a head at its end; a white border makes it visible on every background. */
static void add_arrow(const struct sketch *sketch, const vec3 *points, size_t count)
{
	const vec3 end = project(sketch, points[count - 1]), before = project(sketch, points[count - 2]);
	const double length = math_hypot(end.x - before.x, end.y - before.y);
	const vec3 ahead = length > 0 ? vec3_scale(1 / length, (vec3){end.x - before.x, end.y - before.y, 0})
				      : (vec3){0, 0, 0};

	for (int pass = 0; pass < 2; pass++) {
		strbuf_addf(sketch->out, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%d\" d=\"M",
			    pass ? sketch->colour : "#fff", pass ? 4 : 8);
		for (size_t i = 0; i < count; i++) {
			const vec3 at = project(sketch, points[i]);

			strbuf_addf(sketch->out, "%s%.1f %.1f", i ? "L" : "", at.x, at.y);
		}
		strbuf_addf(sketch->out, "\"/>");
	}
	strbuf_addf(sketch->out, "<path fill=\"%s\" stroke=\"#fff\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\"/>\n",
		    sketch->colour, end.x + 12 * ahead.x, end.y + 12 * ahead.y, end.x - 6 * ahead.x - 8 * ahead.y,
		    end.y - 6 * ahead.y + 8 * ahead.x, end.x - 6 * ahead.x + 8 * ahead.y,
		    end.y - 6 * ahead.y - 8 * ahead.x);
}

static void add_word(const struct sketch *sketch, vec3 p, const char *word)
{
	const vec3 at = project(sketch, p);

	strbuf_addf(sketch->out,
		    "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" stroke=\"#fff\" stroke-width=\"4\" "
		    "paint-order=\"stroke\">%s</text>\n",
		    at.x + 8, at.y - 8, sketch->colour, word);
}

static void add_vector(const struct sketch *sketch, vec3 from, vec3 v, const char *word)
{
	const vec3 points[2] = {from, vec3_add(from, v)};

	add_arrow(sketch, points, 2);
	add_word(sketch, points[1], word);
}

/* A third of a turn about a line, in the positive direction. */
static void add_turn(const struct sketch *sketch, vec3 centre, vec3 direction, double radius, const char *word)
{
	const vec3 helper = fabs(direction.z) < 0.9 ? (vec3){0, 0, 1} : (vec3){1, 0, 0};
	const vec3 across = vec3_cross(direction, helper), u = vec3_scale(radius / vec3_norm(across), across);
	const vec3 v = vec3_cross(direction, u);
	vec3 points[ARC_STEPS + 1];

	for (int i = 0; i <= ARC_STEPS; i++) {
		const double angle = 4 * TURN * i / ARC_STEPS;

		points[i] = vec3_add(centre, vec3_add(vec3_scale(math_cos(angle), u), vec3_scale(math_sin(angle), v)));
	}
	add_arrow(sketch, points, ARC_STEPS + 1);
	add_word(sketch, points[ARC_STEPS], word);
}

/* --------------------------------------------------------------------- marks */

static void add_mounts(struct sketch *sketch, const axis_values *axes)
{
	const struct machine *machine = sketch->pictures->scene->machine;
	const double length = 0.08 * sketch->pictures->size;

	if (machine->spindle.present) {
		const xform pose = machine_pose(machine, machine->spindle.link, axes);

		sketch->colour = "#7a00c8";
		add_vector(sketch, xform_apply(&pose, machine->spindle.location),
			   vec3_scale(length, mat3_apply(&pose.rotation, machine->spindle.direction)), "tool");
	}
	if (machine->workholding.present) {
		const xform link = machine_pose(machine, machine->workholding.link, axes);
		const xform pose = xform_mul(&link, &machine->workholding.frame);

		sketch->colour = "#8a5a00";
		add_vector(sketch, pose.translation, vec3_scale(length, pose.rotation.x), "work x");
		add_vector(sketch, pose.translation, vec3_scale(length, pose.rotation.y), "y");
		add_vector(sketch, pose.translation, vec3_scale(length, pose.rotation.z), "z");
	}
}

/* The directions of the drawing, in the lower left corner. */
static void add_directions(struct sketch *sketch)
{
	const struct camera *camera = &sketch->pictures->camera;
	const double width = 1 / camera->scale, length = 0.06 * width;
	const vec3 corner = vec3_add(camera->centre, vec3_add(vec3_scale(-0.42 * width, camera->right),
							      vec3_scale(-0.26 * width, camera->up)));

	sketch->colour = "#16202b";
	add_vector(sketch, corner, (vec3){length, 0, 0}, "X");
	add_vector(sketch, corner, (vec3){0, length, 0}, "Y");
	add_vector(sketch, corner, (vec3){0, 0, length}, "Z");
}

/* The middle of the bodies that the link carries; without bodies, of the mounts on it. */
static vec3 middle_of(const struct stage *stage, int link)
{
	const struct machine *machine = stage->scene->machine;
	vec3 least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};

	for (size_t i = 0; i < stage->scene->body_count; i++) {
		const struct scene_body *it = &stage->scene->bodies[i];
		vec3 p;

		if (!it->bvh || !machine_link_is_on(machine, it->body->link, link))
			continue;
		p = xform_apply(&it->body->placement, it->bvh->origin);
		p = place(machine, it->body->link, &stage->axes, p);
		least = vec3_min(least, p);
		greatest = vec3_max(greatest, p);
	}
	if (least.x <= greatest.x)
		return vec3_lerp(least, greatest, 0.5);
	if (machine->spindle.present && machine_link_is_on(machine, machine->spindle.link, link))
		return place(machine, machine->spindle.link, &stage->axes, machine->spindle.location);
	if (machine->workholding.present && machine_link_is_on(machine, machine->workholding.link, link))
		return place(machine, machine->workholding.link, &stage->axes,
			     machine->workholding.frame.translation);
	return (vec3){0, 0, 0};
}

static void add_motion(struct sketch *sketch, const struct stage *before, const struct axis *axis, double amount)
{
	const char name[] = {AXIS_LETTERS[axis->slot], '+', '\0'};
	const xform carrier = machine_pose(before->scene->machine, axis->parent, &before->axes);
	const vec3 direction = mat3_apply(&carrier.rotation, axis->direction);
	const vec3 location = xform_apply(&carrier, axis->location), middle = middle_of(before, before->moved);
	vec3 at;

	sketch->colour = "#c40018";
	if (!axis->rotary) {
		add_vector(sketch, middle, vec3_scale(amount, direction), name);
		return;
	}
	/* The point of the axis nearest to the rotating bodies. */
	at = vec3_add(location, vec3_scale(vec3_dot(vec3_sub(middle, location), direction), direction));
	add_vector(sketch, vec3_sub(at, vec3_scale(0.2 * sketch->pictures->size, direction)),
		   vec3_scale(0.4 * sketch->pictures->size, direction), "");
	add_turn(sketch, at, direction, 0.16 * sketch->pictures->size, name);
}

/* ------------------------------------------------------------------- picture */

/* The outline of the moving bodies at their start. */
static void add_ghost(struct strbuf *out, const struct axis_pictures *pictures, const struct stage *before)
{
	struct strbuf outlines = {0};
	struct raster raster;

	raster_init(&raster, WIDTH, HEIGHT);
	stage_draw(before, &pictures->camera, &raster);
	for (int i = 0; i < WIDTH * HEIGHT; i++)
		raster.paints[i] = raster.paints[i] != 0;
	contours_add(&outlines, &raster, 1, 0.9, 10);
	if (outlines.length)
		strbuf_addf(out,
			    "<path fill=\"none\" stroke=\"#1d4f86\" stroke-width=\"1.5\" stroke-dasharray=\"7 5\" "
			    "d=\"%s\"/>\n",
			    outlines.text);
	strbuf_release(&outlines);
	raster_release(&raster);
}

static void add_bodies(struct strbuf *out, const struct axis_pictures *pictures, const struct stage *stage)
{
	struct raster raster;

	raster_init(&raster, WIDTH, HEIGHT);
	stage_draw(stage, &pictures->camera, &raster);
	strbuf_addf(out, "<g fill-rule=\"evenodd\" stroke-width=\"1\" stroke-linejoin=\"round\">\n");
	svg_areas_add(out, &raster, 0.9, 10);
	strbuf_addf(out, "</g>\n");
	raster_release(&raster);
}

void axis_pictures_add(struct strbuf *out, const struct axis_pictures *pictures, int axis, const char *title)
{
	const struct machine *machine = pictures->scene->machine;
	const struct axis *it = axis >= 0 ? &machine->axes[axis] : NULL;
	struct stage stage = {.scene = pictures->scene, .a = -1, .b = -1, .moved = axis + 1};
	struct sketch sketch = {out, pictures, ""};

	if (it)
		stage.axes = only(it, pictures->motions[axis].to);
	strbuf_addf(out,
		    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" role=\"img\">\n<title>",
		    WIDTH, HEIGHT);
	html_text_add(out, title);
	strbuf_addf(out, "</title>\n<rect width=\"%d\" height=\"%d\" fill=\"#%06x\"/>\n", WIDTH, HEIGHT,
		    (unsigned)paint_colour(0));
	add_bodies(out, pictures, &stage);
	strbuf_addf(out, "<g font-family=\"sans-serif\" font-size=\"20\">\n");
	add_directions(&sketch);
	add_mounts(&sketch, &stage.axes);
	if (it) {
		stage.axes = only(it, pictures->motions[axis].from);
		stage.alone = true;
		add_ghost(out, pictures, &stage);
		add_motion(&sketch, &stage, it, pictures->motions[axis].to - pictures->motions[axis].from);
	}
	strbuf_addf(out, "</g>\n</svg>\n");
}
