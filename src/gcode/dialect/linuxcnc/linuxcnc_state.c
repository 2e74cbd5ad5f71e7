#include "gcode/dialect/linuxcnc/linuxcnc_state.h"

#include <stdlib.h>

#include "base/mem.h"

void *linuxcnc_state_new(void)
{
	struct linuxcnc *linuxcnc = mem_zalloc(1, sizeof(*linuxcnc));

	linuxcnc->params.numbered[5599] = 1;	/* DEBUG comments are shown */
	return linuxcnc;
}

void linuxcnc_state_free(void *state)
{
	struct linuxcnc *linuxcnc = state;

	params_release(&linuxcnc->params);
	labels_release(&linuxcnc->flow.labels);
	free(linuxcnc->flow.controls);
	free(linuxcnc);
}
