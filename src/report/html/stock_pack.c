#include "report/html/stock_pack.h"

#include <math.h>

#include "report/format/json.h"
#include "report/format/seven_bit.h"
#include "report/html/scene_pack.h"

static void pack(struct stock_pack *out, const struct scene_body *stock, const struct mesh *mesh, size_t most)
{
	struct strbuf bytes = {0};

	pack_mesh_add(&bytes, mesh, &stock->body->placement, &out->mesh);
	seven_bit_add(&out->blob, strbuf_text(&bytes), bytes.length);
	strbuf_release(&bytes);
	if (out->blob.length <= most)
		return;
	out->left_out = true;
	out->mesh.triangles = 0;
	strbuf_release(&out->blob);
}

void stock_pack_init(struct stock_pack *out, const struct recorder *recorder, size_t most)
{
	const struct stock_view *view = &recorder->stock;

	*out = (struct stock_pack){.body = scene_stock(recorder->scene), .when = STOCK_AT_START};
	if (out->body < 0)
		return;
	if (view->cut) {
		out->when = recorded_findings_first(&recorder->findings) ? STOCK_AT_FINDING : STOCK_AT_END;
		out->excess = view->excess;
	}
	/* An empty mesh cannot be packed. */
	if (!view->cut || view->mesh.count) {
		const struct scene_body *stock = &recorder->scene->bodies[out->body];

		pack(out, stock, view->cut ? &view->mesh : &stock->bvh->mesh, most);
		out->excess += view->cut ? scene_pack_accuracy(&out->mesh) : 0;
		/* Rounded up, because it is shown with one decimal. */
		out->excess = ceil(10 * out->excess) / 10;
	}
}

void stock_pack_release(struct stock_pack *pack)
{
	strbuf_release(&pack->blob);
}

void stock_pack_write(const struct stock_pack *pack, struct page *page, json_t *head)
{
	static const char *const instants[] = {
		[STOCK_AT_START] = "start", [STOCK_AT_FINDING] = "finding", [STOCK_AT_END] = "end",
	};
	json_t *object;

	if (pack->body < 0) {
		json_put(head, "stock", json_null());
		return;
	}
	object = json_object();
	if (pack->mesh.triangles)
		json_put(json_array_get(json_object_get(head, "bodies"), (size_t)pack->body), "mesh",
			 scene_pack_mesh(&pack->mesh, page_blob(page, &pack->blob)));
	json_put(object, "body", json_integer(pack->body));
	json_put(object, "when", json_string(instants[pack->when]));
	json_put(object, "excess", json_real(pack->excess));
	json_put(head, "stock", object);
}

void stock_pack_add_text(const struct stock_pack *pack, struct strbuf *out)
{
	if (pack->body < 0)
		return;
	if (pack->left_out)
		strbuf_addf(out, " The stock's mesh is too large for this report and is left out.");
	else if (pack->when == STOCK_AT_START)
		strbuf_addf(out, " The stock is drawn before the first cut.");
	else
		strbuf_addf(out, " The stock is drawn as it remains at %s: all that is left; what lies deeper than "
				 "%.2g mm below its surface is certainly there.",
			    pack->when == STOCK_AT_FINDING ? "the first finding" : "the end", pack->excess);
}
