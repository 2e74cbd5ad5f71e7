/* mem.h - allocation that cannot fail: out of memory ends the program, only here. */
#ifndef FIVECHECK_BASE_MEM_H
#define FIVECHECK_BASE_MEM_H

#include <stddef.h>

/*
 * Like malloc, calloc, realloc and strndup, but never NULL: if memory is exhausted, or count * size overflows, they
 * print an error and exit with status 3. Free with free().
 */
void *mem_alloc(size_t size);
void *mem_zalloc(size_t count, size_t size);
void *mem_realloc(void *block, size_t count, size_t size);
char *mem_strndup(const char *text, size_t length);

/*
 * For main, before any other thread starts: freed memory is kept for later allocations, and the heap of a thread grows
 * by megabytes. By default (glibc) the heaps of all threads but the first grow page by page, by system calls during
 * which the other threads cannot get pages either. The first thread's heap begins with large pages.
 */
void mem_keep_freed(void);

/* Prints the error and exits, for code with its own allocation that has failed. */
_Noreturn void mem_exhausted(void);

/*
 * Makes room for at least `need` elements of `size` bytes in a growing array:
 * returns the array (perhaps moved) and raises *capacity at least by half.
 */
void *mem_grow(void *array, size_t *capacity, size_t need, size_t size);

#endif
