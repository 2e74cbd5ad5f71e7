#include "cli/files.h"

#include <string.h>
#include <sys/stat.h>

#include "base/confine.h"

/* The same regular file, under whatever names; or the same name, of a file that is yet to be made. */
static bool is_same(const char *a, const char *b)
{
	struct stat sa, sb;

	if (stat(a, &sa) || stat(b, &sb))
		return !strcmp(a, b);
	return S_ISREG(sa.st_mode) && sa.st_dev == sb.st_dev && sa.st_ino == sb.st_ino;
}

static bool is_free(const char *option, const char *path, const char *other, struct diag *diag)
{
	if (!path || !other || !is_same(path, other))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s would overwrite %s", option, other);
	return false;
}

bool files_differ(const struct options *options, struct diag *diag)
{
	const char *names[] = {"output", "pose"};
	const char *paths[] = {options->output, options->pose};

	for (int i = 0; i < 2; i++) {
		if (!is_free(names[i], paths[i], options->machine, diag) ||
		    !is_free(names[i], paths[i], options->setup, diag))
			return false;
		for (size_t k = 0; k < options->program_count; k++) {
			if (!is_free(names[i], paths[i], options->programs[k], diag))
				return false;
		}
	}
	return is_free("pose", options->pose, options->output, diag);
}

static bool spares(const struct options *options, const struct body *bodies, size_t count, struct diag *diag)
{
	for (size_t i = 0; i < count; i++) {
		if (!is_free("output", options->output, bodies[i].mesh_path, diag) ||
		    !is_free("pose", options->pose, bodies[i].mesh_path, diag))
			return false;
	}
	return true;
}

bool files_spare_meshes(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag)
{
	return spares(options, machine->bodies, machine->body_count, diag) &&
	       (!setup || spares(options, setup->bodies, setup->body_count, diag));
}

static bool holds(const char *root, const struct body *bodies, size_t count, struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < count; i++) {
		if (!bodies[i].mesh_path || confine_holds(root, bodies[i].mesh_path))
			continue;
		diag_error(diag, bodies[i].loc, "the mesh %s is outside of the input root %s, or a link leads there",
			   bodies[i].mesh_path, root);
		good = false;
	}
	return good;
}

bool files_confined(const struct options *options, const struct machine *machine, const struct setup *setup,
		    struct diag *diag)
{
	const char *root = options->check.input_root;
	struct stat status;

	if (root && (stat(root, &status) || !S_ISDIR(status.st_mode))) {
		diag_error(diag, (struct srcloc){0}, "--input-root %s is no folder", root);
		return false;
	}
	return holds(root, machine->bodies, machine->body_count, diag) &&
	       (!setup || holds(root, setup->bodies, setup->body_count, diag));
}
