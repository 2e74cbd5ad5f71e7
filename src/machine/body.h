/* body.h - a named rigid body: a mesh on a link of the machine, with one of the roles that rules use. */
#ifndef FIVECHECK_MACHINE_BODY_H
#define FIVECHECK_MACHINE_BODY_H

#include <stdbool.h>

#include "base/diag.h"
#include "geom/mesh.h"
#include "geom/xform.h"

struct tool_solid;

enum body_role { ROLE_MACHINE, ROLE_FIXTURE, ROLE_PART, ROLE_STOCK, ROLE_HOLDER, ROLE_SHANK, ROLE_CUTTER };

struct body {
	const char *name;	/* unique among all bodies of machine and setup */
	enum body_role role;
	int link;
	int tool;	/* the tool's number for holder, shank and cutter; else 0 */
	const char *mesh_path;	/* a path that can be opened; NULL: the body has a `solid` or a `profile` */
	const char *mesh_root;	/* the folder that must contain the mesh, or NULL; must outlive the body */
	const struct mesh *solid;	/* the triangles of a stock given by its shape; NULL: none */
	const struct tool_solid *profile;	/* the sections of a tool's piece; NULL: a mesh, or no tool */
	double rapid_allowance;	/* mm, of a part or the stock: the permitted depth of a cutter that does not cut */
	double gouge;	/* mm, of a part: the permitted depth of a cutter that cuts; negative: any depth */
	double uncertainty;	/* mm, of the stock: by this much the true blank may be larger than its mesh */
	double excess;	/* mm, of the stock: by this much the true blank may be smaller than its mesh */
	const char *checked;	/* why the body is right although it looks wrong; or NULL */
	double scale;	/* mm per unit of the mesh file */
	xform placement;	/* mesh coordinates (after scale) -> machine coordinates at the zero pose */
	struct srcloc loc;	/* of the element that names it */
};

/* Is it one of the machine's own bodies on this link? */
static inline bool body_is_of_link(const struct body *body, int link)
{
	return body->role == ROLE_MACHINE && body->link == link;
}

/* The answer of a rule of <pairs> for two bodies, roles or links. */
enum rule_check { PAIR_DERIVED, PAIR_ALWAYS, PAIR_NEVER };

/* Is the name that of an axis or a role in a <pair>? Then no body may have it. */
bool body_name_is_reserved(const char *name);

/* The names of the roles in rules, in the order of enum body_role; "" for the machine's own bodies. */
extern const char *const body_roles[];

#endif
