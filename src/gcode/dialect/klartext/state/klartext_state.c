#include "gcode/dialect/klartext/state/klartext_state.h"

#include <stdlib.h>

#include "base/mem.h"

void *klartext_state_new(void)
{
	struct klartext *klartext = mem_zalloc(1, sizeof(*klartext));

	klartext->frame.turn = klartext->frame.tilt = mat3_identity();
	klartext->frame.scale = klartext->frame.factor = (vec3){1, 1, 1};
	klartext->pole.across = SLOT_Z;
	return klartext;
}

void klartext_state_free(void *state)
{
	struct klartext *klartext = state;

	labels_release(&klartext->calls.labels);
	strbuf_release(&klartext->calls.folders);
	strbuf_release(&klartext->lines.joined);
	strbuf_release(&klartext->corner.path_text);
	strbuf_release(&klartext->corner.text);
	strbuf_release(&klartext->approach.text);
	free(klartext);
}
