/* doubt_text.h - a doubt about the model in one sentence: the problem, with its numbers, and what to do. */
#ifndef FIVECHECK_REPORT_DOUBT_TEXT_H
#define FIVECHECK_REPORT_DOUBT_TEXT_H

#include "base/strbuf.h"
#include "machine/doubt.h"
#include "scene/scene.h"

/* Appends one line without its end. */
void doubt_text_add(struct strbuf *out, const struct scene *scene, const struct doubt *doubt);

#endif
