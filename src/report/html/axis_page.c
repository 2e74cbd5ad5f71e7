#include "report/html/axis_page.h"

#include "report/axis_words.h"
#include "report/format/format_units.h"
#include "report/format/html_text.h"
#include "report/html/plain_html.h"
#include "report/output.h"
#include "report/picture/axis_picture.h"

static void add_picture(struct strbuf *out, const struct axis_pictures *pictures, int axis, const char *title,
			const char *words)
{
	strbuf_addf(out, "<h2>");
	html_text_add(out, title);
	strbuf_addf(out, "</h2>\n<p>");
	html_text_add(out, words);
	strbuf_addf(out, "</p>\n");
	axis_pictures_add(out, pictures, axis, title);
}

static void add_zero(struct strbuf *out, const struct axis_pictures *pictures)
{
	add_picture(out, pictures, -1, "Every axis at 0",
		    "The machine must stand like this where the control shows 0 for every axis in machine "
		    "coordinates.");
}

/* "X from 0 to 90 mm", and the description that --check-machine prints. */
static void add_axis(struct strbuf *out, const struct axis_pictures *pictures, int index)
{
	const struct machine *machine = pictures->scene->machine;
	const struct axis *axis = &machine->axes[index];
	const struct axis_motion *motion = &pictures->motions[index];
	struct strbuf title = {0}, words = {0};

	strbuf_addf(&title, "%s from %.4g to %.4g %s", axis->name, format_units_value(axis->slot, motion->from),
		    format_units_value(axis->slot, motion->to), format_units_unit(axis->slot));
	strbuf_addf(&words, "%s+10: ", axis->name);
	axis_words_add_axis(&words, machine, axis);
	add_picture(out, pictures, index, strbuf_text(&title), strbuf_text(&words));
	strbuf_release(&title);
	strbuf_release(&words);
}

/*
 * The page: the machine with every axis at 0, and each axis moved alone, with the description that --check-machine
 * prints.
 */
static void add_page(struct strbuf *out, struct scene *scene)
{
	const struct machine *machine = scene->machine;
	const char *name = *machine->name ? machine->name : machine->path;
	struct axis_pictures pictures;

	for (size_t i = 0; i < scene->body_count; i++)
		scene_body_bvh(scene, (int)i);
	axis_pictures_init(&pictures, scene);
	plain_html_add_head(out, name, false);
	strbuf_addf(out, "<main id=\"plain\">\n<h1>");
	html_text_add(out, name);
	strbuf_addf(out,
		    "</h1>\n<p>Compare each picture with the machine: jog the axis by a small step in the positive "
		    "direction, and look. What moves is blue, and its outline shows where it came from. All other "
		    "axes stand at 0. The letters in the lower left corner are the directions of the drawing.</p>\n");
	add_zero(out, &pictures);
	for (size_t i = 0; i < machine->axis_count; i++)
		add_axis(out, &pictures, (int)i);
	strbuf_addf(out, "</main>\n</body>\n</html>\n");
}

bool axis_page_write(const char *path, struct scene *scene, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	bool good = output_open(&out, path, diag);

	if (good) {
		add_page(&text, scene);
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}
