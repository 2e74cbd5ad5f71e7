/*
 * mesh_program.h - starts the program fivecheck-mesh. WebAssembly has no processes: its build uses
 * src/wasi/mesh_program.c instead of mesh_program.c.
 */
#ifndef FIVECHECK_IMPORT_MESH_PROGRAM_H
#define FIVECHECK_IMPORT_MESH_PROGRAM_H

#include <stdbool.h>
#include <stdio.h>

struct mesh_program {
	FILE *out;	/* what it prints */
	long child;	/* its process */
};

/* Runs the program on the file, with a limit of time and memory. False: it cannot be started. */
bool mesh_program_start(struct mesh_program *running, const char *path);

/* Waits for its end; a program that still prints does not delay it. */
void mesh_program_end(struct mesh_program *running);

#endif
