#include "cli/path_checks.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/path_sandbox.h"
#include "base/same_file.h"
#include "base/strbuf.h"

/* Do both paths lead to the same entry of the same folder? */
static bool is_same_entry(const char *a, const char *b)
{
	const char *names[2] = {a, b};
	struct stat folders[2];

	for (int i = 0; i < 2; i++) {
		const char *slash = strrchr(names[i], '/');
		struct strbuf folder = {0};
		bool good;

		if (slash)
			strbuf_add(&folder, names[i], (size_t)(slash - names[i]) + 1);
		good = !stat(slash ? strbuf_text(&folder) : ".", &folders[i]);
		strbuf_release(&folder);
		if (!good)
			return false;
		names[i] = slash ? slash + 1 : names[i];
	}
	return !strcmp(names[0], names[1]) && same_file(&folders[0], &folders[1]);
}

/* Are both the same regular file? Files that do not exist yet are compared by folder and name. */
static bool is_same(const char *a, const char *b)
{
	struct stat sa, sb;

	if (stat(a, &sa) || stat(b, &sb))
		return !strcmp(a, b) || is_same_entry(a, b);
	return S_ISREG(sa.st_mode) && same_file(&sa, &sb);
}

/* A file that will be written, and the option that names it. */
struct written {
	const char *option, *path;
};

static size_t list_written(struct written list[OUTPUT_OPTIONS], const struct options *options)
{
	struct options copy = *options;
	struct output_option all[OUTPUT_OPTIONS];
	size_t count = 0;

	options_list_outputs(&copy, all);
	for (int i = 0; i < OUTPUT_OPTIONS; i++) {
		if (*all[i].path)
			list[count++] = (struct written){all[i].option, *all[i].path};
	}
	return count;
}

static bool is_free(const struct written *written, const char *other, struct diag *diag)
{
	if (!other || !is_same(written->path, other))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s would overwrite %s", written->option, other);
	return false;
}

/* The shell may have redirected standard output, which gets the results, to the same file. */
static bool spares_results(const struct options *options, const struct written *written, struct diag *diag)
{
	struct stat results, status;
	bool has_results = false;

	for (int i = 0; i < FORMAT_COUNT && !options->output; i++)
		has_results = has_results || (options->formats[i].wanted && !options->formats[i].path);
	if (!has_results || fstat(STDOUT_FILENO, &results) || !S_ISREG(results.st_mode) ||
	    stat(written->path, &status) || !same_file(&status, &results))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s would overwrite %s, to which standard output is redirected",
		   written->option, written->path);
	return false;
}

bool path_checks_differ(const char *option, const char *path, const char *input, struct diag *diag)
{
	return !path || is_free(&(struct written){option, path}, input, diag);
}

/* Does an input of the command line come from standard input? */
static bool reads_standard_input(const struct options *options)
{
	bool reads = options->files_from && !strcmp(options->files_from, "-");

	for (size_t i = 0; i < options->program_count; i++)
		reads = reads || !strcmp(options->programs[i], "-");
	return reads;
}

/* The shell may have redirected standard input from the file. */
static bool spares_standard_input(const struct options *options, const struct written *written, struct diag *diag)
{
	struct stat input, status;

	if (!reads_standard_input(options) || fstat(STDIN_FILENO, &input) || !S_ISREG(input.st_mode) ||
	    stat(written->path, &status) || !same_file(&status, &input))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s would overwrite %s, which is standard input", written->option,
		   written->path);
	return false;
}

bool path_checks_outputs(const struct options *options, struct diag *diag)
{
	struct written list[OUTPUT_OPTIONS];
	size_t count = list_written(list, options);

	for (size_t i = 0; i < count; i++) {
		if (!is_free(&list[i], options->machine, diag) || !is_free(&list[i], options->setup, diag) ||
		    !is_free(&list[i], options->waivers, diag) ||
		    !is_free(&list[i], options->files_from, diag) || !spares_results(options, &list[i], diag) ||
		    !spares_standard_input(options, &list[i], diag))
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

bool path_checks_derived(const struct options *options, const char *option, const char *path,
			 const struct report_file *files, size_t file_count, struct diag *diag)
{
	const struct written derived = {option, path};
	struct written list[OUTPUT_OPTIONS];
	const size_t count = list_written(list, options);

	for (size_t i = 0; i < count; i++) {
		if (!is_free(&derived, list[i].path, diag))
			return false;
	}
	/* Files that were read exist. Most names are new, and there may be thousands of programs. */
	if (access(path, F_OK))
		return true;
	for (size_t i = 0; i < file_count; i++) {
		if (!is_free(&derived, files[i].path, diag))
			return false;
	}
	for (size_t i = 0; i < options->program_count; i++) {
		if (!is_free(&derived, options->programs[i], diag))
			return false;
	}
	return is_free(&derived, options->waivers, diag) && is_free(&derived, options->files_from, diag);
}

static bool spares(const struct options *options, const struct body *bodies, size_t count, struct diag *diag)
{
	struct written list[OUTPUT_OPTIONS];
	size_t listed = list_written(list, options);

	for (size_t i = 0; i < count; i++) {
		for (size_t k = 0; k < listed; k++) {
			if (!is_free(&list[k], bodies[i].mesh_path, diag))
				return false;
		}
	}
	return true;
}

bool path_checks_meshes(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag)
{
	return spares(options, machine->bodies, machine->body_count, diag) &&
	       (!setup || spares(options, setup->bodies, setup->body_count, diag));
}

bool path_checks_inputs(const struct options *options, const struct input_files *inputs, struct diag *diag)
{
	struct written list[OUTPUT_OPTIONS];
	size_t listed = list_written(list, options);

	for (size_t i = 0; i < inputs->count; i++) {
		for (size_t k = 0; k < listed; k++) {
			if (!is_free(&list[k], inputs->items[i].path, diag))
				return false;
		}
	}
	return true;
}

bool path_checks_stocks(const struct options *options, const struct input_files *inputs, struct diag *diag)
{
	for (size_t i = 0; i < options->unwritten_count; i++) {
		const struct unwritten_stock *stock = &options->unwritten_stocks[i];

		for (size_t k = 0; k < inputs->count; k++) {
			if (!is_same(stock->path, inputs->items[k].path))
				continue;
			diag_error(diag, (struct srcloc){0},
				   "%s is from before this run: the job \"%s\" has not written its remaining stock to "
				   "it; that job must come first, and must be checked to its end",
				   stock->path, stock->job);
			return false;
		}
	}
	return true;
}

static bool check_meshes_within(const char *root, struct body *bodies, size_t count, struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < count; i++) {
		bodies[i].mesh_root = root;
		if (!bodies[i].mesh_path || path_sandbox_holds(root, bodies[i].mesh_path))
			continue;
		diag_error(diag, bodies[i].loc,
			   "the mesh %s is outside the input root %s, or a symbolic link leads outside",
			   bodies[i].mesh_path, root);
		good = false;
	}
	return good;
}

static bool is_folder(const char *option, const char *path, struct diag *diag)
{
	struct stat status;

	if (!stat(path, &status) && S_ISDIR(status.st_mode))
		return true;
	diag_error(diag, (struct srcloc){0}, "--%s: %s is not a folder", option, path);
	return false;
}

bool path_checks_folders(const struct options *options, struct diag *diag)
{
	const char *root = options->check.read.input_root;
	bool good = !root || is_folder("input-root", root, diag);

	for (size_t i = 0; i < options->includes.count; i++)
		good = is_folder("include", options->includes.items[i], diag) && good;
	return good;
}

bool path_checks_within(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag)
{
	const char *root = options->check.read.input_root;

	return check_meshes_within(root, machine->bodies, machine->body_count, diag) &&
	       (!setup || check_meshes_within(root, setup->bodies, setup->body_count, diag));
}
