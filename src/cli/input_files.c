#define _GNU_SOURCE

#include "cli/input_files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/mem.h"
#include "report/depfile.h"
#include "report/output.h"

struct file_stamp {
	const char *path;	/* borrowed from the item */
	dev_t device;
	ino_t inode;
	off_t size;
	struct timespec written, changed;
};

static bool is_same_time(const struct timespec *a, const struct timespec *b)
{
	return a->tv_sec == b->tv_sec && a->tv_nsec == b->tv_nsec;
}

static bool is_later(const struct timespec *a, const struct timespec *b)
{
	return a->tv_sec != b->tv_sec ? a->tv_sec > b->tv_sec : a->tv_nsec > b->tv_nsec;
}

/* A missing file gets no stamp: it is reported when it is read. */
static void add_stamp(struct input_files *inputs, const char *path)
{
	struct stat status;

	if (stat(path, &status) != 0)
		return;
	inputs->stamps = mem_grow(inputs->stamps, &inputs->stamp_capacity, inputs->stamp_count + 1,
				  sizeof(*inputs->stamps));
	inputs->stamps[inputs->stamp_count++] = (struct file_stamp){path, status.st_dev, status.st_ino, status.st_size,
								    status.st_mtim, status.st_ctim};
}

static bool has_changed(const struct input_files *inputs, const char *path, const struct stat *now)
{
	for (size_t i = 0; i < inputs->stamp_count; i++) {
		const struct file_stamp *then = &inputs->stamps[i];

		if (then->path == path && (then->device != now->st_dev || then->inode != now->st_ino ||
					   then->size != now->st_size || !is_same_time(&then->written, &now->st_mtim) ||
					   !is_same_time(&then->changed, &now->st_ctim)))
			return true;
	}
	return is_later(&now->st_ctim, &inputs->started);
}

static void add_file(struct input_files *inputs, const char *kind, const char *path)
{
	for (size_t i = 0; i < inputs->count; i++) {
		if (!strcmp(inputs->items[i].path, path))
			return;
	}
	inputs->items = mem_grow(inputs->items, &inputs->capacity, inputs->count + 1, sizeof(*inputs->items));
	inputs->items[inputs->count] = (struct report_file){kind, mem_strndup(path, strlen(path)), ""};
	add_stamp(inputs, inputs->items[inputs->count++].path);
}

static void on_opened(void *context, const char *path)
{
	struct input_files *inputs = context;

	pthread_mutex_lock(&inputs->lock);
	add_file(inputs, "subprogram", path);
	pthread_mutex_unlock(&inputs->lock);
}

void input_files_init(struct input_files *inputs)
{
	*inputs = (struct input_files){.opened = {inputs, on_opened}};
	pthread_mutex_init(&inputs->lock, NULL);
	clock_gettime(CLOCK_REALTIME, &inputs->started);
}

void input_files_release(struct input_files *inputs)
{
	for (size_t i = 0; i < inputs->count; i++)
		free((char *)inputs->items[i].path);
	free(inputs->items);
	free(inputs->stamps);
	pthread_mutex_destroy(&inputs->lock);
}

static void add_meshes(struct input_files *inputs, const struct body *bodies, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (bodies[i].mesh_path)
			add_file(inputs, "mesh", bodies[i].mesh_path);
	}
}

void input_files_add_files(struct input_files *inputs, const struct options *options, const struct machine *machine,
			   const struct setup *setup, bool meshes)
{
	add_file(inputs, "machine", options->machine);
	if (options->setup)
		add_file(inputs, "setup", options->setup);
	for (size_t i = 0; setup && i < setup->library_count; i++)
		add_file(inputs, "tools", setup->libraries[i]);
	if (options->waivers)
		add_file(inputs, "waivers", options->waivers);
	if (meshes)
		add_meshes(inputs, machine->bodies, machine->body_count);
	if (meshes && setup)
		add_meshes(inputs, setup->bodies, setup->body_count);
	for (size_t i = 0; i < options->program_count; i++) {
		if (strcmp(options->programs[i], "-") != 0)
			add_file(inputs, "program", options->programs[i]);
	}
}

static int compare(const void *a, const void *b)
{
	const struct report_file *x = a, *y = b;
	int order = strcmp(x->kind, y->kind);

	return order ? order : strcmp(x->path, y->path);
}

void input_files_sort(struct input_files *inputs)
{
	if (inputs->count)
		qsort(inputs->items, inputs->count, sizeof(*inputs->items), compare);
}

void known_digests_release(struct known_digests *known)
{
	for (size_t i = 0; i < known->count; i++)
		free((char *)known->items[i].path);
	free(known->items);
	*known = (struct known_digests){0};
}

/* Is the file one of those from which a model is loaded? Programs and waivers are read again by each check. */
static bool is_loaded_once(const struct report_file *file)
{
	static const char *const kinds[] = {"machine", "mesh", "setup", "tools"};

	for (size_t i = 0; i < sizeof(kinds) / sizeof(*kinds); i++) {
		if (!strcmp(file->kind, kinds[i]))
			return true;
	}
	return false;
}

static struct report_file *find_known(const struct known_digests *known, const char *path)
{
	for (size_t i = 0; i < known->count; i++) {
		if (!strcmp(known->items[i].path, path))
			return &known->items[i];
	}
	return NULL;
}

void input_files_take_known(struct input_files *inputs, const struct known_digests *known)
{
	for (size_t i = 0; i < inputs->count; i++) {
		struct report_file *file = &inputs->items[i];
		const struct report_file *found = is_loaded_once(file) ? find_known(known, file->path) : NULL;

		if (found)
			memcpy(file->digest, found->digest, DIGEST_SIZE);
	}
}

void input_files_remember(const struct input_files *inputs, struct known_digests *known)
{
	for (size_t i = 0; i < inputs->count; i++) {
		const struct report_file *file = &inputs->items[i];

		if (!file->digest[0] || !is_loaded_once(file) || find_known(known, file->path))
			continue;
		known->items = mem_grow(known->items, &known->capacity, known->count + 1, sizeof(*known->items));
		known->items[known->count] = *file;
		known->items[known->count++].path = mem_strndup(file->path, strlen(file->path));
	}
}

void input_files_digest_one(struct input_files *inputs, size_t i, const struct cancel *cancel)
{
	struct report_file *file = &inputs->items[i];
	struct stat status;

	/* A pipe cannot be read twice, and opening it would wait for a writer. */
	if (!file->digest[0] && !stat(file->path, &status) && S_ISREG(status.st_mode))
		digest_file(file->digest, file->path, cancel);
}

void input_files_digest(struct input_files *inputs)
{
	for (size_t i = 0; i < inputs->count; i++)
		input_files_digest_one(inputs, i, NULL);
}

bool input_files_verify(const struct input_files *inputs, bool strict, struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < inputs->count; i++) {
		const struct report_file *file = &inputs->items[i];
		struct stat status;
		bool there = !stat(file->path, &status);

		if (there && !S_ISREG(status.st_mode)) {
			if (strict)
				diag_error(diag, (struct srcloc){0}, "--record: %s is not a regular file", file->path);
			good = good && !strict;
		} else if (!there || !file->digest[0]) {
			if (strict)
				diag_error(diag, (struct srcloc){0}, "--record: cannot read %s: %s", file->path,
					   strerror(there ? EIO : errno));
			good = good && !strict;
		} else if (has_changed(inputs, file->path, &status)) {
			diag_error(diag, (struct srcloc){0}, "%s changed while it was checked", file->path);
			good = false;
		}
	}
	return good;
}

static bool add_prerequisite(struct strbuf *text, const char *path, struct diag *diag)
{
	strbuf_addf(text, " \\\n ");
	return depfile_add_name(text, path, false, diag);
}

static bool add_empty_rule(struct strbuf *text, const char *path, struct diag *diag)
{
	bool good;

	strbuf_addf(text, "\n");
	good = depfile_add_name(text, path, true, diag);
	strbuf_addf(text, ":\n");
	return good;
}

bool input_files_write_depfile(const struct input_files *inputs, const struct options *options, struct diag *diag)
{
	struct output out = {0};
	struct strbuf text = {0};
	bool good = true;

	if (!options->depfile)
		return true;
	if (options->output)
		good = depfile_add_name(&text, options->output, true, diag);
	for (int i = 0; i < FORMAT_COUNT; i++) {
		if (options->formats[i].path)
			good = depfile_add_name(&text, options->formats[i].path, true, diag) && good;
	}
	if (options->clearance_report)
		good = depfile_add_name(&text, options->clearance_report, true, diag) && good;
	if (options->timing)
		good = depfile_add_name(&text, options->timing, true, diag) && good;
	strbuf_addf(&text, ":");
	if (options->job_file)
		good = add_prerequisite(&text, options->job_file, diag) && good;
	for (size_t i = 0; i < inputs->count; i++)
		good = add_prerequisite(&text, inputs->items[i].path, diag) && good;
	strbuf_addf(&text, "\n");
	/* With an empty rule for each input, make still works after an unused mesh was deleted. */
	if (options->job_file)
		good = good && add_empty_rule(&text, options->job_file, diag);
	for (size_t i = 0; i < inputs->count && good; i++)
		good = add_empty_rule(&text, inputs->items[i].path, diag);
	good = good && output_open(&out, options->depfile, diag);
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}
