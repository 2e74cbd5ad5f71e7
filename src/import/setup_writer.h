/* setup_writer.h - writes the description of a setup as a setup file. */
#ifndef FIVECHECK_IMPORT_SETUP_WRITER_H
#define FIVECHECK_IMPORT_SETUP_WRITER_H

#include "base/strbuf.h"
#include "machine/description.h"

/* Appends a setup file. `origin` says in a comment what it was made from. */
void setup_writer_xml(struct strbuf *out, const struct setup_description *setup, const char *origin);

#endif
