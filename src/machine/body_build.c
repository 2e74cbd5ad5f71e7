#include "machine/body_build.h"

#include <string.h>

#include "machine/tool_solid.h"

bool body_build(struct description_file *file, const struct body_description *described, const xform *mount,
		struct body *body)
{
	/* The stock has the name of its role unless the file gives another one. */
	if (body_name_is_reserved(described->name) &&
	    !(described->role == ROLE_STOCK && !strcmp(described->name, body_roles[ROLE_STOCK]))) {
		description_fault(
		    file, described->at, "name",
		    "a body cannot be named '%s': in a <pair> this word is an axis, the base or a role",
		    described->name);
		return false;
	}
	body->name = described->name;
	body->checked = described->checked;
	body->role = described->role;
	body->mesh_path = described->mesh_path;
	body->scale = described->scale;
	body->placement = xform_mul(mount, &described->frame);
	body->loc = description_place(file, described->at);
	return true;
}

void body_check_name(struct description_file *file, const void *at, const char *name, const struct body *bodies,
		     size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (strcmp(bodies[i].name, name) == 0) {
			description_fault(file, at, "name", "another body already has the name '%s' (%s:%ld)",
					  name, bodies[i].loc.file, bodies[i].loc.line);
			return;
		}
	}
}

double body_build_depth(struct description_file *file, const void *at, const char *element, const char *name,
			struct optional_number described, double fallback)
{
	if (!described.given)
		return fallback;
	if (described.value < 0 || described.value > TOOL_SIZE_MAX)
		description_fault(file, at, name, "%s=\"%s\" of <%s> is not between 0 and %g mm", name,
				  description_quote(file, at, name).text, element, TOOL_SIZE_MAX);
	return described.value;
}
