/*
 * fault.c - to be preloaded: makes one allocation, read or start of a thread fail, as the environment says.
 *
 *   FAULT_ALLOC=n    the n-th allocation finds no memory, and none after it
 *   FAULT_ONCE=1     only that one
 *   FAULT_READ=n     the n-th read() reports an input/output error
 *   FAULT_THREAD=n   from the n-th on, no thread can be started
 *   FAULT_COUNT=path how many allocations there were, written at the end
 */
#define _GNU_SOURCE

#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *block, size_t size);

static atomic_long allocations, reads, threads;
static long fail_alloc, fail_read, fail_thread, once;
static atomic_bool armed;

static long number(const char *name)
{
	const char *text = getenv(name);

	return text ? strtol(text, NULL, 10) : 0;
}

static __attribute__((constructor)) void arm(void)
{
	fail_alloc = number("FAULT_ALLOC");
	fail_read = number("FAULT_READ");
	fail_thread = number("FAULT_THREAD");
	once = number("FAULT_ONCE");
	atomic_store(&armed, true);
}

static __attribute__((destructor)) void tell(void)
{
	const char *path = getenv("FAULT_COUNT");
	FILE *file;

	atomic_store(&armed, false);
	file = path ? fopen(path, "w") : NULL;
	if (file) {
		fprintf(file, "%ld\n", atomic_load(&allocations));
		fclose(file);
	}
}

static bool fails(void)
{
	long count;

	if (!atomic_load(&armed))
		return false;
	count = atomic_fetch_add(&allocations, 1) + 1;
	return fail_alloc && (count == fail_alloc || (count > fail_alloc && !once));
}

void *malloc(size_t size)
{
	if (fails()) {
		errno = ENOMEM;
		return NULL;
	}
	return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
	if (fails()) {
		errno = ENOMEM;
		return NULL;
	}
	return __libc_calloc(count, size);
}

void *realloc(void *block, size_t size)
{
	if (fails()) {
		errno = ENOMEM;
		return NULL;
	}
	return __libc_realloc(block, size);
}

ssize_t read(int fd, void *buffer, size_t size)
{
	static ssize_t (*next)(int, void *, size_t);

	if (!next)
		*(void **)&next = dlsym(RTLD_NEXT, "read");
	if (atomic_load(&armed) && atomic_fetch_add(&reads, 1) + 1 == fail_read) {
		errno = EIO;
		return -1;
	}
	return next(fd, buffer, size);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *context)
{
	static int (*next)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

	if (!next)
		*(void **)&next = dlsym(RTLD_NEXT, "pthread_create");
	if (fail_thread && atomic_fetch_add(&threads, 1) + 1 >= fail_thread)
		return EAGAIN;
	return next(thread, attributes, start, context);
}
