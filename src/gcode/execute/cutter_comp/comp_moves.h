/* comp_moves.h - keeps compensated moves until their ends are known, and then sends them to the sink. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_MOVES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Positions are straight (rotated_frame.h), in mm. Functions that can fail report the reason and return false. */

/* The axes of the plane, and the axis perpendicular to it. */
enum axis_slot comp_slot_a(const struct interp *interp);
enum axis_slot comp_slot_b(const struct interp *interp);
enum axis_slot comp_slot_across(const struct interp *interp);

/* The point of the plane of a position, and of the present programmed position. */
struct plane_point comp_point_of(const struct interp *interp, const slot_values *values);
struct plane_point comp_here(const struct interp *interp);

/* The point at this distance from `from`, in the direction of the angle. */
struct plane_point comp_beside(struct plane_point from, double distance, double angle);

/* Sends all waiting moves with their present ends; the next move starts at `start`. */
bool comp_send_all(struct interp *interp, struct plane_point start);

/* Ends all waiting moves at this point and sends them. */
bool comp_send_to(struct interp *interp, struct plane_point end);

/* Sets the block's data of a move, and its end on the axes outside the plane. */
struct canon_move comp_complete(struct interp *interp, const struct canon_move *move, const slot_values *target);

/* Sets the state to the programmed position; only the axes outside the plane are really there. */
void comp_arrive(struct interp *interp, const slot_values *target, struct plane_point current);

/* Adds a line with a programmed direction (0: none) that ends at `end` unless the next corner shortens it. */
bool comp_add_line(struct interp *interp, const slot_values *target, const struct canon_move *move,
		   struct plane_point direction, struct plane_point end);

/* The same for an arc; the item has its centre, direction and turns already. The caller must call comp_arrive. */
bool comp_add_arc(struct interp *interp, const slot_values *target, const struct canon_move *move,
		  struct comp_item *item);

#endif
