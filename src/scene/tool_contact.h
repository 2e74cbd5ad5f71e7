/*
 * tool_contact.h - finds quickly that a tool's piece given by sections can meet another body, without the tree of its
 * triangles: at some axis positions a corner of the body is inside the piece.
 */
#ifndef FIVECHECK_SCENE_TOOL_CONTACT_H
#define FIVECHECK_SCENE_TOOL_CONTACT_H

#include <stdbool.h>

#include "geom/bvh.h"
#include "machine/body.h"
#include "machine/chain.h"

/* The last contact of a body: pieces of other tools often meet it there. All zero is empty. */
struct tool_contact {
	bool known;
	axis_values at;
	vec3 corner;	/* of the body, in machine coordinates at the zero pose */
};

/*
 * True: at positions between low and high a corner of the body is inside the piece; *last is the place. The chain leads
 * from the body, whose tree is `tree`, to the piece. False: none was found, which proves nothing.
 */
bool tool_contact_finds(struct tool_contact *last, const struct body *body, const struct bvh *tree,
			const struct body *piece, const struct chain *chain, const axis_values *low,
			const axis_values *high);

#endif
