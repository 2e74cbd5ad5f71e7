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

/* A file that is to be written, and the option that says so. */
struct written {
	const char *option, *path;
};

enum { WRITTEN_MAX = FORMAT_COUNT + 5 };

static size_t list_written(struct written *list, const struct options *options)
{
	size_t count = 0;

	if (options->output)
		list[count++] = (struct written){"output", options->output};
	for (int i = 0; i < FORMAT_COUNT; i++) {
		if (options->formats[i].path)
			list[count++] =
			    (struct written){i == FORMAT_RECORD ? "record" : "format", options->formats[i].path};
	}
	if (options->depfile)
		list[count++] = (struct written){"depfile", options->depfile};
	if (options->clearance_report)
		list[count++] = (struct written){"clearance-report", options->clearance_report};
	if (options->timing)
		list[count++] = (struct written){"timing", options->timing};
	if (options->pose)
		list[count++] = (struct written){"pose", options->pose};
	return count;
}

static bool is_free(const struct written *written, const char *other, struct diag *diag)
{
	if (!other || !is_same(written->path, other))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s would overwrite %s", written->option, other);
	return false;
}

bool files_differ(const struct options *options, struct diag *diag)
{
	struct written list[WRITTEN_MAX];
	size_t count = list_written(list, options);

	for (size_t i = 0; i < count; i++) {
		if (!is_free(&list[i], options->machine, diag) || !is_free(&list[i], options->setup, diag) ||
		    !is_free(&list[i], options->baseline, diag))
			return false;
		for (size_t k = 0; k < options->program_count; k++) {
			if (!is_free(&list[i], options->programs[k], diag))
				return false;
		}
		for (size_t k = 0; k < i; k++) {
			if (!is_free(&list[i], list[k].path, diag))
				return false;
		}
	}
	return true;
}

static bool spares(const struct options *options, const struct body *bodies, size_t count, struct diag *diag)
{
	struct written list[WRITTEN_MAX];
	size_t listed = list_written(list, options);

	for (size_t i = 0; i < count; i++) {
		for (size_t k = 0; k < listed; k++) {
			if (!is_free(&list[k], bodies[i].mesh_path, diag))
				return false;
		}
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
