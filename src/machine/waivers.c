#include "machine/waivers.h"

#include <stdlib.h>

void waivers_free(struct waivers *waivers)
{
	if (!waivers)
		return;
	arena_release(&waivers->arena);
	free(waivers);
}
