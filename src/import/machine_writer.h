/* machine_writer.h - writes a machine as machine.xml and its meshes as STL. */
#ifndef FIVECHECK_IMPORT_MACHINE_WRITER_H
#define FIVECHECK_IMPORT_MACHINE_WRITER_H

#include "base/strbuf.h"
#include "import/import.h"

/*
 * Appends the XML. `origin`: the source of the file, for a comment. Data that the other program does not have is marked
 * with TODO, as by `fivecheck init`: the control, and rates that are missing.
 */
void machine_writer_xml(struct strbuf *out, const struct import_machine *machine, const char *origin);

/* Appends comments with the tasks for the user. */
void machine_writer_todo(struct strbuf *out, const struct import_machine *machine);

/* Appends the attributes location, if it is needed or not 0, and rotation, if it is not 0. */
void machine_writer_frame(struct strbuf *out, const xform *frame, bool location_needed);

/* Appends the mesh as binary STL. */
void machine_writer_stl(struct strbuf *out, const struct mesh *mesh);

#endif
