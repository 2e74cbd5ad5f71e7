#define _DEFAULT_SOURCE	/* madvise */

#include "base/mem.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

#define MEGABYTE (1024 * 1024)

/* Bytes: the size and the alignment of a large page on most processors, and of the smallest block that gets some. */
#define LARGE_PAGE (2 * (size_t)MEGABYTE)
#define LARGE_BLOCK (LARGE_PAGE / 2)

/* Bytes: as much as most checks need in blocks that are smaller. */
#define HEAP_START (16 * MEGABYTE)

void mem_exhausted(void)
{
	fputs("fivecheck: out of memory\n", stderr);
	_Exit(3);
}

/*
 * Asks the kernel for large pages inside the block. Many kernels give them only if asked. Measured with 1,000,000
 * triangles: loading takes less than half, and checking two thirds of the time; with 20,000 to 100,000 triangles, both
 * together take a tenth to a fifth less.
 */
static void ask_for_large_pages(void *block, size_t size)
{
#ifdef MADV_HUGEPAGE
	const size_t before = (LARGE_PAGE - (uintptr_t)block % LARGE_PAGE) % LARGE_PAGE;

	/* If the kernel refuses, the pages are small. */
	if (size >= before + LARGE_PAGE)
		(void)madvise((char *)block + before, (size - before) / LARGE_PAGE * LARGE_PAGE, MADV_HUGEPAGE);
#else
	(void)block;
	(void)size;
#endif
}

void mem_keep_freed(void)
{
#ifdef __GLIBC__
	void *heap;

	mallopt(M_TOP_PAD, 8 * MEGABYTE);
	mallopt(M_TRIM_THRESHOLD, 256 * MEGABYTE);
	/* The heap is made to grow once, and keeps the large pages of the block that it has grown for. */
	mallopt(M_MMAP_THRESHOLD, 2 * HEAP_START);
	heap = malloc(HEAP_START);
	ask_for_large_pages(heap, heap ? HEAP_START : 0);
	free(heap);
	/* Larger blocks come from the kernel: their memory can be used by all threads after they are freed. */
	mallopt(M_MMAP_THRESHOLD, MEGABYTE);
#endif
}

void *mem_alloc(size_t size)
{
	void *block = NULL;

#ifdef MADV_HUGEPAGE
	if (size >= LARGE_BLOCK && size < SIZE_MAX - LARGE_PAGE) {
		/* A block that begins with a large page and ends with one consists of them. */
		size = (size + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
		if (posix_memalign(&block, LARGE_PAGE, size))
			block = NULL;
	}
#endif
	if (!block)
		block = malloc(size ? size : 1);
	if (!block)
		mem_exhausted();
	ask_for_large_pages(block, size);
	return block;
}

void *mem_zalloc(size_t count, size_t size)
{
	void *block = calloc(count ? count : 1, size ? size : 1);

	if (!block)
		mem_exhausted();
	ask_for_large_pages(block, count * size);
	return block;
}

void *mem_realloc(void *block, size_t count, size_t size)
{
	if (size && count > SIZE_MAX / size)
		mem_exhausted();
	block = realloc(block, count && size ? count * size : 1);
	if (!block)
		mem_exhausted();
	ask_for_large_pages(block, count * size);
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
