/* apart.h - keeps what is seldom done out of functions that run for every block. */
#ifndef FIVECHECK_BASE_APART_H
#define FIVECHECK_BASE_APART_H

/*
 * Of a static function with one caller: it stays a function of its own. As a part of its caller it would have the
 * caller save registers and reserve memory for it in every call, also in the many that do not get that far.
 */
#define APART __attribute__((noinline))

#endif
