/* file_kind.h - determines the kind of a file of another program by its content. */
#ifndef FIVECHECK_IMPORT_FILE_KIND_H
#define FIVECHECK_IMPORT_FILE_KIND_H

#include <stdbool.h>

#include "base/diag.h"

enum file_kind {
	FILE_VERICUT_MACHINE,	/* XML with the root VcMachine */
	FILE_VERICUT_PROJECT,	/* XML with the root VcProject */
	FILE_EMC_MACHINE,	/* an ini file of LinuxCNC (once EMC), with a section [KINS] */
	FILE_FREECAD,	/* JSON of FreeCAD's CAM workbench */
	FILE_URDF,	/* XML with the root robot */
	FILE_MTCONNECT,	/* XML with the root MTConnectDevices */
	FILE_MESH,	/* a format of mesh_file.h */
	FILE_TOOLS	/* what machine/library/library_file.h reads */
};

/* False, reported: the file cannot be read, or is of none of these kinds. */
bool file_kind_of(enum file_kind *kind, const char *path, struct diag *diag);

#endif
