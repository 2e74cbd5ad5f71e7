#include "check/batch.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

void batch_release(struct batch *batch)
{
	free(batch->steps);
	free(batch->paths);
	free(batch->path_tcp);
	free(batch->tcps);
	*batch = (struct batch){0};
}

void batch_clear(struct batch *batch)
{
	batch->step_count = batch->path_count = batch->tcp_count = 0;
}

static void add_path(struct batch *batch, const struct path *path)
{
	batch->paths = mem_grow(batch->paths, &batch->path_capacity, batch->path_count + 1, sizeof(*batch->paths));
	batch->path_tcp = mem_grow(batch->path_tcp, &batch->path_tcp_capacity, batch->path_count + 1,
				   sizeof(*batch->path_tcp));
	if (path->tcp && (!batch->tcp_count || memcmp(&batch->tcps[batch->tcp_count - 1], path->tcp, sizeof(*path->tcp)))) {
		batch->tcps = mem_grow(batch->tcps, &batch->tcp_capacity, batch->tcp_count + 1, sizeof(*batch->tcps));
		memcpy(&batch->tcps[batch->tcp_count++], path->tcp, sizeof(*path->tcp));
	}
	batch->path_tcp[batch->path_count] = batch->tcp_count ? batch->tcp_count - 1 : 0;
	batch->paths[batch->path_count++] = *path;
}

void batch_add(struct batch *batch, const struct motion_step *step, long block)
{
	struct batch_step *copy;
	bool same_path = step->span.u0 > 0 && batch->step_count > 0;

	if (!same_path)
		add_path(batch, step->span.path);
	batch->steps = mem_grow(batch->steps, &batch->step_capacity, batch->step_count + 1, sizeof(*batch->steps));
	copy = &batch->steps[batch->step_count++];
	copy->motion = *step;
	copy->path = batch->path_count - 1;
	copy->block = block;
}

void batch_close(struct batch *batch)
{
	for (size_t i = 0; i < batch->path_count; i++)
		if (batch->paths[i].tcp)
			batch->paths[i].tcp = &batch->tcps[batch->path_tcp[i]];
	for (size_t i = 0; i < batch->step_count; i++)
		batch->steps[i].motion.span.path = &batch->paths[batch->steps[i].path];
}
