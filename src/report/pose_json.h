/* pose_json.h - the distances of the bodies at one pose, as a line of JSON: for a machine that is moved by hand. */
#ifndef FIVECHECK_REPORT_POSE_JSON_H
#define FIVECHECK_REPORT_POSE_JSON_H

#include "base/strbuf.h"
#include "scene/pose_clearance.h"

/*
 * {"kind":"pose","axes":{"X":..},"tool":1,"pairs":5,"nearest":{"a":"head","b":"table","distance":12.5,"on_a":[x,y,z],
 * "on_b":[x,y,z]},"meets":[["a","b"]],"near":[],"unknown":[]}
 *
 * `pairs` counts those that must stay apart, `nearest` is the nearest of them that is apart (or null), `meets` are
 * those that overlap, `near` those within their clearance, `unknown` those that could not be decided.
 */
void pose_json_add(struct strbuf *out, const struct scene *scene, const axis_values *q, int tool,
		   const struct pose_clearance *clearance, const enum pose_state *states);

#endif
