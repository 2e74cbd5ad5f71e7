#include "base/mem.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#define MEGABYTE (1024 * 1024)

void mem_keep_freed(void)
{
#ifdef __GLIBC__
	/* Larger blocks come from the kernel: their memory can be used by all threads after they are freed. */
	mallopt(M_MMAP_THRESHOLD, MEGABYTE);
	mallopt(M_TOP_PAD, 8 * MEGABYTE);
	mallopt(M_TRIM_THRESHOLD, 256 * MEGABYTE);
#endif
}

void mem_exhausted(void)
{
	fputs("fivecheck: out of memory\n", stderr);
	_Exit(3);
}

void *mem_alloc(size_t size)
{
	void *block = malloc(size ? size : 1);

	if (!block)
		mem_exhausted();
	return block;
}

void *mem_zalloc(size_t count, size_t size)
{
	void *block = calloc(count ? count : 1, size ? size : 1);

	if (!block)
		mem_exhausted();
	return block;
}

void *mem_realloc(void *block, size_t count, size_t size)
{
	if (size && count > SIZE_MAX / size)
		mem_exhausted();
	block = realloc(block, count && size ? count * size : 1);
	if (!block)
		mem_exhausted();
	return block;
}

char *mem_strndup(const char *text, size_t length)
{
	char *copy = mem_alloc(length + 1);

	memcpy(copy, text, length);
	copy[length] = '\0';
	return copy;
}

void *mem_grow(void *array, size_t *capacity, size_t need, size_t size)
{
	size_t more = *capacity + *capacity / 2;

	if (need <= *capacity)
		return array;
	if (more < need)
		more = need;
	if (more < 16)
		more = 16;
	array = mem_realloc(array, more, size);
	*capacity = more;
	return array;
}
