/* prefetch.h - asks the processor for memory that will be written soon, so that a later store need not wait for it. */
#ifndef FIVECHECK_BASE_PREFETCH_H
#define FIVECHECK_BASE_PREFETCH_H

#include <stddef.h>

enum { CACHE_LINE = 64 };

/*
 * Takes the bytes away from another processor that used them last. Changes nothing but time, so the address may also be
 * past the end of an array. For x86-64, compilers make a prefetch for reading of __builtin_prefetch(p, 1) unless they
 * are told that the processor has PREFETCHW. A prefetch for reading does not help: the store still waits for the other
 * processor. Processors without PREFETCHW treat it as no operation.
 */
static inline void prefetch_for_writing(const void *start, size_t size)
{
	for (size_t i = 0; i < size; i += CACHE_LINE)
#if defined(__x86_64__)
		__asm__ volatile("prefetchw %0" : : "m"(((const char *)start)[i]));
#else
		__builtin_prefetch((const char *)start + i, 1);
#endif
}

#endif
