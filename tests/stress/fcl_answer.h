/* fcl_answer.h - what FCL says of two triangle meshes, for a program in C. */
#ifndef STRESS_FCL_ANSWER_H
#define STRESS_FCL_ANSWER_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The library's version, "0.7.0". */
const char *fcl_version(void);

struct fcl_body;

/* From corners[9 * count]. Never NULL. */
struct fcl_body *fcl_body_new(const double *corners, size_t count);
void fcl_body_free(struct fcl_body *body);

/* b posed in a's coordinates: rotation by rows, then translation. NULL: where both were drawn. */
bool fcl_bodies_meet(const struct fcl_body *a, const struct fcl_body *b, const double *pose);
double fcl_bodies_distance(const struct fcl_body *a, const struct fcl_body *b, const double *pose);

/*
 * Conservative advancement while b goes straight from one pose to another: the share of the way at which it has them
 * meet, or -1 if it says that they do not.
 */
double fcl_bodies_advance(const struct fcl_body *a, const struct fcl_body *b, const double *from, const double *to);

#ifdef __cplusplus
}
#endif

#endif
