/* vericut_text.h - tells files of VERICUT 6 and before that are in its text form, and refuses them. */
#ifndef FIVECHECK_MACHINE_LIBRARY_VERICUT_TEXT_H
#define FIVECHECK_MACHINE_LIBRARY_VERICUT_TEXT_H

#include <stdbool.h>

#include "base/diag.h"

/*
 * The grammar of the text form is not published. True, reported: `text` of the file is in this form, and the message
 * says what to do. False: it is something else (XML, JSON, not text, empty, or no name that VERICUT gives).
 */
bool vericut_text_refuse(const char *path, const char *text, struct diag *diag);

#endif
