#include "report/picture/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "report/format/html_text.h"
#include "report/picture/inset.h"
#include "report/picture/png.h"
#include "report/picture/silhouettes.h"
#include "report/picture/stage_camera.h"
#include "report/picture/svg_areas.h"

enum { WIDTH = 960, HEIGHT = 640, RING = 34, LINE = 2 };

/* Pixels at the lower edge for the title; the normal and the smallest size of its letters. */
enum { TITLE = 40, FONT_SIZE = 17, FONT_SIZE_MIN = 9 };
/* The average width of letters in a sentence, as a share of their size. */
#define LETTER_WIDTH 0.52

/* ------------------------------------------------------------------- SVG */

/* Pixels of a quick picture per pixel of its raster, in both directions: its outlines are a little coarser. */
#define QUICK_PIXEL (4.0 / 3)

static void add_ring(struct strbuf *out, double x, double y)
{
	strbuf_addf(out,
		    "<g fill=\"none\"><circle cx=\"%.0f\" cy=\"%.0f\" r=\"%d\" stroke=\"#fff\" stroke-width=\"9\"/>"
		    "<circle cx=\"%.0f\" cy=\"%.0f\" r=\"%d\" stroke=\"#7a00c8\" stroke-width=\"4\"/></g>\n",
		    x, y, RING, x, y, RING);
}

static unsigned label_colour(enum paint_class class)
{
	return (unsigned)paint_colour((uint8_t)(class * PAINT_LEVELS + PAINT_LEVELS - 3));
}

/* A small square in the body's colour and its name, on a background that keeps them readable. */
static void add_label(struct strbuf *out, const struct stage *stage, int body, enum paint_class class, int row)
{
	const char *name = stage->scene->bodies[body].body->name;
	const double width = fmin(46 + LETTER_WIDTH * FONT_SIZE * (double)strlen(name), WIDTH);
	const int y = 22 + 24 * row;

	strbuf_addf(out, "<rect y=\"%d\" width=\"%.0f\" height=\"24\" fill=\"#fff\" fill-opacity=\"0.8\"/>", y - 17,
		    width);
	strbuf_addf(out, "<rect x=\"14\" y=\"%d\" width=\"16\" height=\"16\" fill=\"#%06x\" stroke=\"none\"/>"
			 "<text x=\"38\" y=\"%d\">",
		    y - 13, label_colour(class), y + 1);
	html_text_add(out, name);
	strbuf_addf(out, "</text>\n");
}

/* The size of letters with which the title fits between the edges. */
static double title_size(const char *title)
{
	const double size = (WIDTH - 28) / (LETTER_WIDTH * (double)(strlen(title) + 1));

	return fmin(FONT_SIZE, fmax(size, FONT_SIZE_MIN));
}

static bool has_pair(const struct stage *stage)
{
	return stage->a >= 0 && stage->b >= 0;
}

/* The texts in the picture. */
static void add_words(struct strbuf *out, const struct stage *stage, const char *title)
{
	strbuf_addf(out, "<g font-family=\"sans-serif\" font-size=\"%d\" fill=\"#16202b\">\n", FONT_SIZE);
	if (has_pair(stage)) {
		add_label(out, stage, stage->a, stage_class_a(stage), 0);
		add_label(out, stage, stage->b, stage_class_b(stage), 1);
	}
	strbuf_addf(out, "<rect y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#fff\" fill-opacity=\"0.8\"/>"
			 "<text x=\"14\" y=\"%d\"", HEIGHT - TITLE, WIDTH, TITLE, HEIGHT - 14);
	if (title_size(title) < FONT_SIZE)
		strbuf_addf(out, " font-size=\"%.3g\"", title_size(title));
	strbuf_addf(out, ">");
	html_text_add(out, title);
	strbuf_addf(out, "</text></g>\n");
}

void picture_add_svg(struct strbuf *out, const struct stage *stage, const char *title, bool fine)
{
	const struct camera camera = stage_camera(stage);
	const double pixel = fine ? 1 : QUICK_PIXEL;
	struct inset inset = {0};
	struct raster raster;
	vec3 at;

	raster_init(&raster, (int)lround(WIDTH / pixel), (int)lround(HEIGHT / pixel));
	stage_draw(stage, &camera, &raster);
	if (fine)
		silhouettes_add(&raster, LINE, SILHOUETTE_JUMP / camera.scale);
	if (fine && stage->has_point)
		inset = inset_add(&raster, stage, &camera, LINE, TITLE);
	strbuf_addf(out,
		    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
		    "role=\"img\">\n<title>",
		    WIDTH, HEIGHT, WIDTH, HEIGHT);
	html_text_add(out, title);
	strbuf_addf(out,
		    "</title>\n<rect width=\"%d\" height=\"%d\" fill=\"#%06x\"/>\n<g fill-rule=\"evenodd\" "
		    "stroke-width=\"%g\" stroke-linejoin=\"round\"",
		    WIDTH, HEIGHT, (unsigned)paint_colour(0), 1 / pixel);
	if (!fine)
		strbuf_addf(out, " transform=\"scale(%.6g)\"", pixel);
	strbuf_addf(out, ">\n");
	svg_areas_add(out, &raster, fine ? 0.9 : 1.1, fine ? 10 : 14);
	strbuf_addf(out, "</g>\n");
	at = camera_project(&camera, &(struct raster){.width = WIDTH, .height = HEIGHT}, stage->point);
	if (stage->has_point)
		add_ring(out, at.x, at.y);
	if (inset.width)
		add_ring(out, inset.x + 0.5 * inset.width, inset.y + 0.5 * inset.height);
	if (fine)
		add_words(out, stage, title);
	strbuf_addf(out, "</svg>\n");
	raster_release(&raster);
}

static void add_key(struct strbuf *out, const struct stage *stage, int body, enum paint_class class)
{
	strbuf_addf(out, "<svg viewBox=\"0 0 12 12\" width=\"12\" height=\"12\" aria-hidden=\"true\"><rect "
			 "width=\"12\" height=\"12\" fill=\"#%06x\"/></svg> ", label_colour(class));
	html_text_add(out, stage->scene->bodies[body].body->name);
	strbuf_addf(out, "<br>\n");
}

void picture_add_caption(struct strbuf *out, const struct stage *stage, const char *title)
{
	strbuf_addf(out, "<figcaption>");
	if (has_pair(stage)) {
		add_key(out, stage, stage->a, stage_class_a(stage));
		add_key(out, stage, stage->b, stage_class_b(stage));
	}
	html_text_add(out, title);
	strbuf_addf(out, "</figcaption>\n");
}

/* ------------------------------------------------------------------- PNG */

/* Pixels of the raster per pixel of the image, in both directions. */
enum { SUPERSAMPLES = 3 };

/* The covered share of a pixel at this distance from the ring's line. */
static double cover(double distance, double width)
{
	return fmin(fmax(width / 2 + 0.5 - fabs(distance), 0), 1);
}

static double blend(double below, double above, double share)
{
	return below + share * (above - below);
}

static void draw_ring(unsigned char *pixels, double x0, double y0)
{
	static const unsigned char violet[3] = {0x7a, 0x00, 0xc8};

	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			const double off = math_hypot(x + 0.5 - x0, y + 0.5 - y0) - RING;
			unsigned char *pixel = pixels + 3 * ((size_t)y * WIDTH + (size_t)x);

			for (int k = 0; k < 3; k++) {
				const double white = blend(pixel[k], 255, cover(off, 9));

				pixel[k] = (unsigned char)lround(blend(white, violet[k], cover(off, 4)));
			}
		}
	}
}

static void shrink(unsigned char *pixels, const struct raster *raster)
{
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			uint32_t sums[3] = {0};

			for (int i = 0; i < SUPERSAMPLES * SUPERSAMPLES; i++) {
				const int row = SUPERSAMPLES * y + i / SUPERSAMPLES,
					  column = SUPERSAMPLES * x + i % SUPERSAMPLES;
				const uint32_t colour = paint_colour(raster->paints[row * raster->width + column]);

				for (int k = 0; k < 3; k++)
					sums[k] += colour >> (16 - 8 * k) & 255;
			}
			for (int k = 0; k < 3; k++)
				*pixels++ = (unsigned char)(sums[k] / (SUPERSAMPLES * SUPERSAMPLES));
		}
	}
}

void picture_add_png(struct strbuf *out, const struct stage *stage)
{
	const struct camera camera = stage_camera(stage);
	unsigned char *pixels = mem_alloc(3 * WIDTH * HEIGHT);
	struct inset inset = {0};
	struct raster raster;

	raster_init(&raster, SUPERSAMPLES * WIDTH, SUPERSAMPLES * HEIGHT);
	stage_draw(stage, &camera, &raster);
	silhouettes_add(&raster, SUPERSAMPLES * LINE, SILHOUETTE_JUMP / camera.scale);
	if (stage->has_point)
		inset = inset_add(&raster, stage, &camera, SUPERSAMPLES * LINE, 0);
	shrink(pixels, &raster);
	if (stage->has_point) {
		const vec3 at = camera_project(&camera, &raster, stage->point);

		draw_ring(pixels, at.x / SUPERSAMPLES, at.y / SUPERSAMPLES);
		draw_ring(pixels, (inset.x + 0.5 * inset.width) / SUPERSAMPLES,
			  (inset.y + 0.5 * inset.height) / SUPERSAMPLES);
	}
	png_add(out, pixels, WIDTH, HEIGHT);
	free(pixels);
	raster_release(&raster);
}
