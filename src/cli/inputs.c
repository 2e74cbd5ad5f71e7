#include "cli/inputs.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/depfile.h"
#include "report/output.h"

static void add(struct inputs *inputs, enum input_kind kind, const char *path)
{
	for (size_t i = 0; i < inputs->count; i++) {
		if (!strcmp(inputs->items[i].path, path))
			return;
	}
	inputs->items = mem_grow(inputs->items, &inputs->capacity, inputs->count + 1, sizeof(*inputs->items));
	inputs->items[inputs->count++] = (struct input){kind, mem_strndup(path, strlen(path))};
}

static void on_opened(void *context, const char *path)
{
	struct inputs *inputs = context;

	pthread_mutex_lock(&inputs->lock);
	add(inputs, INPUT_SUBPROGRAM, path);
	pthread_mutex_unlock(&inputs->lock);
}

void inputs_init(struct inputs *inputs)
{
	*inputs = (struct inputs){.watch = {inputs, on_opened}};
	pthread_mutex_init(&inputs->lock, NULL);
}

void inputs_release(struct inputs *inputs)
{
	for (size_t i = 0; i < inputs->count; i++)
		free(inputs->items[i].path);
	free(inputs->items);
	pthread_mutex_destroy(&inputs->lock);
}

static void add_meshes(struct inputs *inputs, const struct body *bodies, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (bodies[i].mesh_path)
			add(inputs, INPUT_MESH, bodies[i].mesh_path);
	}
}

void inputs_add_files(struct inputs *inputs, const struct options *options, const struct machine *machine,
		      const struct setup *setup, bool meshes)
{
	add(inputs, INPUT_MACHINE, options->machine);
	if (options->setup)
		add(inputs, INPUT_SETUP, options->setup);
	if (options->baseline)
		add(inputs, INPUT_BASELINE, options->baseline);
	if (meshes)
		add_meshes(inputs, machine->bodies, machine->body_count);
	if (meshes && setup)
		add_meshes(inputs, setup->bodies, setup->body_count);
	for (size_t i = 0; i < options->program_count; i++) {
		if (strcmp(options->programs[i], "-") != 0)
			add(inputs, INPUT_PROGRAM, options->programs[i]);
	}
}

static int compare(const void *a, const void *b)
{
	const struct input *x = a, *y = b;

	return x->kind != y->kind ? (int)x->kind - (int)y->kind : strcmp(x->path, y->path);
}

void inputs_sort(struct inputs *inputs)
{
	if (inputs->count)
		qsort(inputs->items, inputs->count, sizeof(*inputs->items), compare);
}

bool inputs_write_depfile(const struct inputs *inputs, const struct options *options, struct diag *diag)
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
	strbuf_addf(&text, ":");
	for (size_t i = 0; i < inputs->count; i++) {
		strbuf_addf(&text, " \\\n ");
		good = depfile_add_name(&text, inputs->items[i].path, false, diag) && good;
	}
	strbuf_addf(&text, "\n");
	/* A mesh that is no longer used may be deleted: a rule without a recipe keeps make from asking for it. */
	for (size_t i = 0; i < inputs->count && good; i++) {
		strbuf_addf(&text, "\n");
		good = depfile_add_name(&text, inputs->items[i].path, true, diag);
		strbuf_addf(&text, ":\n");
	}
	good = good && output_open(&out, options->depfile, diag);
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}
