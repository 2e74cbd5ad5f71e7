/* vericut_text.h - recognises files of VERICUT 6 and before in their text form, and rejects them. */
#ifndef FIVECHECK_MACHINE_LIBRARY_VERICUT_TEXT_H
#define FIVECHECK_MACHINE_LIBRARY_VERICUT_TEXT_H

#include <stdbool.h>

#include "base/diag.h"

/*
 * The grammar of the text form is not published. True, reported: `text` is in this form, and the message says what to
 * do. False: it is not (XML, JSON, binary, empty, or a file name that VERICUT does not use).
 */
bool vericut_text_refuse(const char *path, const char *text, struct diag *diag);

#endif
