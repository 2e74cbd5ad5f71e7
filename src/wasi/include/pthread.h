/*
 * pthread.h - for WebAssembly, which has one thread: none can be started, and nothing must be locked.
 *
 * pthread_create fails as on a system that has no more threads; every caller must handle this.
 */
#ifndef FIVECHECK_WASI_PTHREAD_H
#define FIVECHECK_WASI_PTHREAD_H

#include <errno.h>
#include <stddef.h>

typedef int pthread_t;
typedef char pthread_mutex_t;
typedef char pthread_cond_t;
typedef char pthread_attr_t;

#define PTHREAD_MUTEX_INITIALIZER 0
#define PTHREAD_COND_INITIALIZER 0

static inline int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
				 void *context)
{
	(void)thread;
	(void)attributes;
	(void)run;
	(void)context;
	return EAGAIN;
}

static inline int pthread_join(pthread_t thread, void **result)
{
	(void)thread;
	(void)result;
	return ESRCH;
}

static inline int pthread_mutex_init(pthread_mutex_t *mutex, const void *attributes)
{
	(void)attributes;
	*mutex = 0;
	return 0;
}

static inline int pthread_mutex_destroy(pthread_mutex_t *mutex)
{
	(void)mutex;
	return 0;
}

static inline int pthread_mutex_lock(pthread_mutex_t *mutex)
{
	(void)mutex;
	return 0;
}

static inline int pthread_mutex_trylock(pthread_mutex_t *mutex)
{
	(void)mutex;
	return 0;
}

static inline int pthread_mutex_unlock(pthread_mutex_t *mutex)
{
	(void)mutex;
	return 0;
}

static inline int pthread_cond_init(pthread_cond_t *condition, const void *attributes)
{
	(void)attributes;
	*condition = 0;
	return 0;
}

static inline int pthread_cond_destroy(pthread_cond_t *condition)
{
	(void)condition;
	return 0;
}

static inline int pthread_cond_signal(pthread_cond_t *condition)
{
	(void)condition;
	return 0;
}

static inline int pthread_cond_broadcast(pthread_cond_t *condition)
{
	(void)condition;
	return 0;
}

/* The condition could never change. */
static inline int pthread_cond_wait(pthread_cond_t *condition, pthread_mutex_t *mutex)
{
	(void)condition;
	(void)mutex;
	__builtin_trap();
}

#endif
