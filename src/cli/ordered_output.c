#include "cli/ordered_output.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static bool is_current(const struct program_output *output)
{
	return output == &output->order->programs[output->order->current];
}

static void report(void *context, const struct diag_entry *entry)
{
	struct program_output *output = context;

	error_list_add(&output->errors, entry);
	pthread_mutex_lock(&output->order->lock);
	diag_pass(is_current(output) ? &output->order->ui->diag : &output->waiting.diag, entry);
	pthread_mutex_unlock(&output->order->lock);
}

void ordered_output_init(struct ordered_output *order, size_t count, struct stderr_ui *ui, struct sinks *sinks)
{
	*order = (struct ordered_output){.ui = ui, .sinks = sinks, .count = count};
	pthread_mutex_init(&order->lock, NULL);
	order->programs = mem_zalloc(count + 1, sizeof(*order->programs));
	for (size_t i = 0; i < count; i++) {
		struct program_output *output = &order->programs[i];

		output->order = order;
		output->diag = (struct diag){.handle = report, .context = output};
		diag_queue_init(&output->waiting);
	}
}

void ordered_output_release(struct ordered_output *order)
{
	for (size_t i = 0; i < order->count; i++) {
		struct program_output *output = &order->programs[i];

		diag_queue_release(&output->waiting);
		for (size_t k = 0; k < FORMAT_COUNT; k++)
			strbuf_release(&output->text[k]);
		error_list_release(&output->errors);
	}
	free(order->programs);
	pthread_mutex_destroy(&order->lock);
}

bool ordered_output_is_lost(struct ordered_output *order)
{
	bool lost;

	pthread_mutex_lock(&order->lock);
	lost = sinks_are_lost(order->sinks);
	pthread_mutex_unlock(&order->lock);
	return lost;
}

static bool write_now(struct ordered_output *order, size_t index, struct strbuf *text)
{
	struct sink *sink = &order->sinks->items[index];

	stderr_ui_clear(order->ui);
	sink_write(sink, text);
	return sink_flush(sink);
}

bool program_output_write(struct program_output *output, size_t sink, struct strbuf *text)
{
	struct ordered_output *order = output->order;
	bool good;

	pthread_mutex_lock(&order->lock);
	if (is_current(output)) {
		good = write_now(order, sink, text);
	} else {
		strbuf_add(&output->text[sink], strbuf_text(text), text->length);
		strbuf_clear(text);
		good = !sinks_are_lost(order->sinks);
	}
	pthread_mutex_unlock(&order->lock);
	return good;
}

void program_output_progress(struct program_output *output, const char *file, long lines, double share)
{
	pthread_mutex_lock(&output->order->lock);
	if (is_current(output))
		stderr_ui_progress(output->order->ui, file, lines, share);
	pthread_mutex_unlock(&output->order->lock);
}

/* Writes the buffered text. */
static void write_held(struct program_output *output)
{
	diag_queue_deliver(&output->waiting, &output->order->ui->diag, LONG_MAX);
	for (size_t i = 0; i < output->order->sinks->count; i++) {
		if (output->text[i].length)
			write_now(output->order, i, &output->text[i]);
	}
}

void program_output_end(struct program_output *output)
{
	struct ordered_output *order = output->order;

	pthread_mutex_lock(&order->lock);
	output->ended = true;
	stderr_ui_done(order->ui);
	while (order->current < order->count && order->programs[order->current].ended) {
		order->current++;
		if (order->current < order->count)
			write_held(&order->programs[order->current]);
	}
	pthread_mutex_unlock(&order->lock);
}
