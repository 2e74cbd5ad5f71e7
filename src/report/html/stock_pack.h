/* stock_pack.h - the stock in the report of one program: what remains of it at the first finding, else at the end. */
#ifndef FIVECHECK_REPORT_HTML_STOCK_PACK_H
#define FIVECHECK_REPORT_HTML_STOCK_PACK_H

#include <jansson.h>

#include "base/strbuf.h"
#include "report/html/pack_mesh.h"
#include "report/html/page.h"
#include "report/html/recorder.h"

struct stock_pack {
	int body;	/* its index in the scene; -1: there is no stock */
	struct packed_mesh mesh;	/* without triangles: nothing is drawn */
	struct strbuf blob;	/* owned */
	bool left_out;	/* the mesh would need too many bytes */
	/* mm: material deeper than this below the drawn surface is certainly there; 0 for the blank */
	double excess;
	/* At the start: no cutter has been in the blank by then, and the blank is drawn. */
	enum stock_instant { STOCK_AT_START, STOCK_AT_FINDING, STOCK_AT_END } when;
};

/* A mesh that needs more than `most` bytes is left out. */
void stock_pack_init(struct stock_pack *pack, const struct recorder *recorder, size_t most);
void stock_pack_release(struct stock_pack *pack);

/* Writes the mesh to the page, and its description to the head. */
void stock_pack_write(const struct stock_pack *pack, struct page *page, json_t *head);

/* Appends a sentence with a space before it; nothing if there is no stock. */
void stock_pack_add_text(const struct stock_pack *pack, struct strbuf *out);

#endif
