/* comp_moves.h - moves beside the programmed path wait here, and go to the sink when it is known where they end. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_MOVES_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_MOVES_H

#include <stdbool.h>

#include "gcode/state.h"

/* Positions are straight (rotated_frame.h), in mm. What can fail reports why before it returns false. */

/* The axes of the plane, and the one across it. */
enum axis_slot comp_slot_a(const struct interp *interp);
enum axis_slot comp_slot_b(const struct interp *interp);
enum axis_slot comp_slot_across(const struct interp *interp);

/* The point of the plane at a position, and at the programmed position where the program is. */
struct plane_point comp_point_of(const struct interp *interp, const slot_values *values);
struct plane_point comp_here(const struct interp *interp);

/* The point at this distance and angle from `from`. */
struct plane_point comp_beside(struct plane_point from, double distance, double angle);

/* Sends everything that waits, with its present ends; the next move starts at `start`. */
bool comp_send_all(struct interp *interp, struct plane_point start);

/* Ends everything that waits at this point and sends it. */
bool comp_send_to(struct interp *interp, struct plane_point end);

/* Fills in what the block says about a move, and its end on the axes off the plane. */
struct canon_move comp_complete(struct interp *interp, const struct canon_move *move, const slot_values *target);

/* Takes the programmed position as the present one; only the axes off the plane are really there. */
void comp_arrive(struct interp *interp, const slot_values *target, struct plane_point current);

/* A line in a programmed direction, 0 for none, that ends at `end` unless the next corner trims it. */
bool comp_add_line(struct interp *interp, const slot_values *target, const struct canon_move *move,
		   struct plane_point direction, struct plane_point end);

/* The same for an arc; the item has its centre, direction and turns already. comp_arrive is the caller's. */
bool comp_add_arc(struct interp *interp, const slot_values *target, const struct canon_move *move,
		  struct comp_item *item);

#endif
