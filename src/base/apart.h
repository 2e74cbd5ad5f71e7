/* apart.h - keeps rare code out of functions that run for every block. */
#ifndef FIVECHECK_BASE_APART_H
#define FIVECHECK_BASE_APART_H

/*
 * For a static function with one caller: it is not inlined. Inlined, it would make its caller save registers and
 * reserve memory for it in every call, including the many that never reach it.
 */
#define APART __attribute__((noinline))

#endif
