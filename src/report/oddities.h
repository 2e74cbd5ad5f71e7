/* oddities.h - conspicuous properties of meshes, the home position, and the model as a whole (--check-machine). */
#ifndef FIVECHECK_REPORT_ODDITIES_H
#define FIVECHECK_REPORT_ODDITIES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "scene/scene.h"

enum oddity_kind {
	ODDITY_DRAWN_TWICE,
	ODDITY_OPEN_MESH,
	ODDITY_INVERTED,
	ODDITY_NESTED,
	ODDITY_FLIPPED,
	ODDITY_DEGENERATE,
	ODDITY_OVERLAP,	/* at home */
	ODDITY_DOUBT	/* see machine/doubt.h */
};

struct oddity {
	enum oddity_kind kind;
	struct strbuf text;	/* one line without its end */
};

/* Owns its items. All zero is an empty list. */
struct oddities {
	struct oddity *items;
	size_t count, capacity;
};

/*
 * Appends meshes that are open, face both ways or have degenerate triangles, bodies that overlap at home, and the
 * doubts of the scene, which model_check has filled. False, reported: two bodies are too far from the origin to be
 * decided.
 */
bool oddities_find(struct oddities *oddities, struct scene *scene, struct diag *diag);
void oddities_release(struct oddities *oddities);

/* "open-mesh" and the like. */
const char *oddity_kind_name(enum oddity_kind kind);

#endif
