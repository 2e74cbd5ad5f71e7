/* machine_json.h - the tables of a machine as JSON: --check-machine and --list-pairs with --format=json. */
#ifndef FIVECHECK_REPORT_MACHINE_JSON_H
#define FIVECHECK_REPORT_MACHINE_JSON_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "report/oddities.h"
#include "scene/scene.h"

/*
 * Both append one JSON document: lengths in mm, angles in degrees, rates per minute; null for missing values.
 * fivecheck(1) describes the keys.
 */
void machine_json_add(struct strbuf *out, struct scene *scene, const struct oddities *oddities);
void machine_json_add_pairs(struct strbuf *out, const struct scene *scene);

#endif
