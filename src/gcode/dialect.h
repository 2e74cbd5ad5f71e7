/* dialect.h - describes how a control reads and carries out programs: its codes, its answers as data, and its hooks. */
#ifndef FIVECHECK_GCODE_DIALECT_H
#define FIVECHECK_GCODE_DIALECT_H

#include <stdbool.h>

#include "base/axes.h"
#include "control/controller.h"
#include "gcode/code.h"
#include "gcode/text/fault.h"

struct interp;

/*
 * A control is one folder of gcode/dialect with a table of this type, and one row of control/dialects.h; no other file
 * asks which control it is. A table inherits nothing: an answer that it leaves out is 0, which means "not known", and a
 * program that needs the answer is refused (dialect_answers). Controls that share codes name the same code sets.
 *
 * A behaviour that differs between controls is an answer here: add a member, and let the code that depends on it call
 * is_answered. A language of its own is a set of hooks in the control's folder.
 */

/* The unit of a number without a decimal point: whole units, or the machine file's least_input. */
enum whole_numbers { WHOLE_NUMBERS_UNKNOWN, WHOLE_NUMBERS_UNITS, WHOLE_NUMBERS_INCREMENTS };

/* The P of a dwell: seconds, or milliseconds if it has no decimal point. */
enum dwell_p { DWELL_P_UNKNOWN, DWELL_P_SECONDS, DWELL_P_MILLISECONDS };

/* When the active feed becomes invalid: at every G94 and G95, or only if its unit changes. */
enum feed_forgotten { FEED_FORGOTTEN_UNKNOWN, FEED_FORGOTTEN_BY_CODE, FEED_FORGOTTEN_BY_CHANGE };

/* A G1 without an axis word: it needs a feed like any other G1, or it is ignored. */
enum empty_feed_move { EMPTY_FEED_MOVE_UNKNOWN, EMPTY_FEED_MOVE_CHECKED, EMPTY_FEED_MOVE_IGNORED };

/* The centre of an arc before any G90.1 or G91.1: relative to the start of the arc, or in program coordinates. */
enum arc_centre { ARC_CENTRE_UNKNOWN, ARC_CENTRE_INCREMENTAL, ARC_CENTRE_ABSOLUTE };

/* An arc with neither a centre nor a radius: an error; or a straight line, unless the control stops with an alarm. */
enum arc_without_centre { ARC_WITHOUT_CENTRE_UNKNOWN, ARC_WITHOUT_CENTRE_REFUSED, ARC_WITHOUT_CENTRE_LINE };

/* A feed move before any F: an error; or it uses a feed that the control has kept, unless the control stops. */
enum feed_missing { FEED_MISSING_UNKNOWN, FEED_MISSING_REFUSED, FEED_MISSING_KEPT };

/* ",C" and ",R", a chamfer and a rounding: none, between lines only, or also at arcs. */
enum corner_words { CORNER_WORDS_UNKNOWN, CORNER_WORDS_WITH_LINES, CORNER_WORDS_WITH_ARCS };

/* The D of cutter compensation: the number of a tool, whose diameter counts, or of an offset that holds a radius. */
enum d_word { D_WORD_UNKNOWN, D_WORD_TOOL, D_WORD_RADIUS };

/* What T does. */
enum t_word { T_WORD_UNKNOWN, T_WORD_SELECTS };

/* The rate of G53: that of G0 or G1, whichever is programmed, or always rapid. */
enum g53_rate { G53_RATE_UNKNOWN, G53_RATE_PROGRAMMED, G53_RATE_RAPID };

/* Machine coordinates while an M-code of the machine has TCP on: those of the axes or of the tool point. */
enum g53_under_tcp { G53_UNDER_TCP_UNKNOWN, G53_UNDER_TCP_AXES, G53_UNDER_TCP_TOOL_POINT };

/* G28 and G30 without an axis word: all axes move, or it is an error. */
enum g28_without_axes { G28_WITHOUT_AXES_UNKNOWN, G28_WITHOUT_AXES_ALL, G28_WITHOUT_AXES_REFUSED };

/* G28, G30 and G53 while G68 is active: refused, or refused only if they move an axis of the plane. */
enum turned_by_machine { TURNED_BY_MACHINE_UNKNOWN, TURNED_BY_MACHINE_REFUSED, TURNED_BY_MACHINE_ACROSS };

/* G10 L20: sets the coordinates of the present position, or writes an additional work offset. */
enum g10_l20 { G10_L20_UNKNOWN, G10_L20_HERE, G10_L20_ADDITIONAL };

/* G10 L2 with G91: the words replace the offset, or are added to it. */
enum g10_incremental { G10_INCREMENTAL_UNKNOWN, G10_INCREMENTAL_WRITES, G10_INCREMENTAL_ADDS };

/* G43 without H: takes the tool in the spindle, the H given last, or is an error. */
enum h_missing { H_MISSING_UNKNOWN, H_MISSING_SPINDLE, H_MISSING_LAST, H_MISSING_REFUSED };

/* H0: the length of the tool in the spindle, or none. */
enum h_zero { H_ZERO_UNKNOWN, H_ZERO_SPINDLE, H_ZERO_NONE };

/* H without G43, while G43 is active: changes the length; or only H0 cancels the length, and any other is refused. */
enum h_alone { H_ALONE_UNKNOWN, H_ALONE_CHANGES, H_ALONE_CANCELS };

/*
 * G87: back boring with the shift in I and J, up to K; back boring with the shift in Q, up to Z; or a bore from which
 * the operator retracts by hand.
 */
enum g87 { G87_UNKNOWN, G87_BACK_BY_IJK, G87_BACK_BY_Q, G87_BY_HAND };

/* The behaviour of canned cycles. Every cycle needs every answer. */
struct cycle_traits {
	enum answer words_outlive_cycle;	/* words stay valid for a following cycle with another code */
	/* R and the depth keep their position if G90 or G91 follows; no: their words are interpreted again */
	enum answer words_keep_place;
	enum answer without_axes;	/* a cycle without axis words keeps its words, drills nothing; no: an error */
	enum answer starts_at_r;	/* before any G98 or G99, the tool retracts to R; no: to the initial level */
	enum answer never_below_r;	/* with G98, the tool retracts to R if R is higher than the initial level */
	enum answer level_is_coordinate;	/* the initial level follows the coordinates; no: a change is refused */
	enum answer p_is_needed;	/* by G82, G86, G89; no: P is optional, and other cycles take P, too */
	enum answer q_has_sign;	/* a negative Q is an error; no: the sign is ignored */
	enum answer zero_repeats_refused;
	enum answer only_xyz;	/* words of rotary axes are an error */
	enum answer spindle_must_turn;	/* for taps and bores; no: the control starts the spindle */
	enum answer axis_by_parameter;	/* in planes other than that of G17, Z may drill all the same */
	enum answer taps_confuse_planes;	/* in planes other than that of G17, G74 and G84 move elsewhere */
	enum answer feeds_to_clear;	/* taps and G89 retract at the feed all the way; no: up to R */
	enum answer rises_first;	/* the tool rises to R before it moves to the first hole */
	enum answer exact_path;	/* in every path mode */
	enum answer any_order;	/* R and Z may be in the wrong order: the tool moves there; no: an error */
	enum answer taps_peck;	/* taps may have Q: the pecks are on the path without Q */
	enum answer taps_retract_by_j;	/* taps may have J, the speed of the retract */
	enum g87 g87;
	enum answer pecks_fall;	/* pecks may have I, J and K instead of Q */
	enum answer shift_by_ij;	/* bores may have I and J instead of Q; these give the direction, too */
	char repeat_letter;
};

/*
 * Modes at power-on: G-codes in tenths. 0: a parameter of the control decides. Then the machine file must name the
 * mode, or the program must select it before the first word that needs it.
 */
struct power_on {
	int units;	/* G20, G21 */
	bool units_of_control;	/* G20 instead if the control's own unit is the inch */
	int distance;	/* G90, G91 */
	int plane;	/* G17, G18, G19 */
	int feed_mode;	/* G93, G94, G95 */
	int path;	/* G61, G64; 0: not known, so the control may leave the path until the program says G61 */
	bool asks_motion;	/* a parameter decides between G0 and G1; else no motion is active */
};

struct dialect_traits {
	enum answer last_of_group;	/* two G-codes of a group in a block: the last one counts; no: an error */
	struct power_on power_on;
	enum whole_numbers whole_numbers;
	enum answer known_order;	/* execute_block has the control's order of execution; no: it is not known */
	/* all codes of a block that can take a word share it; not known, or no: an error */
	enum answer words_are_shared;
	/* G4: the letters of the time, and whether the block must have no motion. */
	const char *dwell_letters;
	enum dwell_p dwell_p;
	enum answer dwell_alone;
	enum answer text_before_percent;	/* text that is no block may precede the first '%'; no: blank lines */
	/* Motion and feed. */
	enum feed_forgotten feed_forgotten;
	enum empty_feed_move empty_feed_move;
	enum feed_missing feed_missing;	/* not known: as refused */
	enum answer g64_has_tolerance;	/* in P */
	enum arc_centre arc_centre;
	enum arc_without_centre arc_without_centre;
	enum answer arcs_have_turns;	/* in P */
	enum answer arc_radius_wins;	/* R counts if an arc has R and a centre; not known, or no: an error */
	/* I, J or K of the axis perpendicular to the plane may be 0; not known, or no: an error */
	enum answer arc_idle_zero;
	enum answer arc_spirals;	/* a parameter limits the difference of the radii of a spiral arc */
	enum corner_words corner_words;
	/* the parameter for the number of blocks without a move that compensation reads past; NULL: not asked */
	const char *idle_blocks_parameter;
	const char *corner_names;	/* of the words in messages; NULL: ",C or ,R" */
	enum answer wrap_below_turn;	/* absolute values of an axis with wrap="sign" are between -360 and 360 */
	const struct cycle_traits *cycles;	/* NULL: not known */
	/* cycles and G80 are a separate group from G0 to G3: G80 restores the former code of G0 to G3 */
	enum answer cycles_apart;
	/* Moves to places of the machine. */
	/* G0 to G3 in a block with G10, G28, G30, G52 or G92 are valid from the next block on; no: an error */
	enum answer motion_beside_words;
	enum g53_rate g53_rate;
	enum g53_under_tcp g53_under_tcp;
	enum answer g53_asks_g91;	/* the machine file says how G53 behaves in G91; no: G53 in G91 is an error */
	enum answer g53_alone;	/* G53 without motion and axis words does nothing; no: an error */
	enum g28_without_axes g28_without_axes;
	/* programs can write the reference positions of G28 and G30; no: the machine file has that of G30 */
	enum answer references_in_parameters;
	enum answer g30_has_number;	/* in P */
	enum answer m19_has_time;	/* in Q: the time to wait for the spindle */
	enum answer m8_has_pressure;	/* in P; not known, or no: M8 takes no P */
	enum turned_by_machine turned_by_machine;
	enum answer g68_in_space;	/* G68 with I, J and K turns about any direction */
	enum t_word t_word;
	enum answer m6_loads_own_t;	/* M6 loads the T of its own block; no: the machine file says which T */
	enum answer tool_change_stays;	/* M6 moves no axis if the machine file has no position; no: an error */
	/* Work offsets. */
	int additional_offsets;	/* of G54.1 or G154 */
	int shared_p;	/* a P up to this number may belong to G54 and to another code of the block */
	enum answer g54_has_number;	/* G54 with P is G54.1 */
	int g10_first, g10_last;	/* the P of G10 L2; g10_last 0: not known */
	enum g10_l20 g10_l20;
	enum g10_incremental g10_incremental;
	enum answer g10_writes_tools;	/* L1, L10, L11, and L0 */
	/* L10 and L11 write H and its wear, L12 and L13 D and its wear, from R */
	enum answer g10_writes_registers;
	enum answer one_shift;	/* G52 and G92 write the same shift; no: both at the same time are refused */
	enum answer shifts_ignore_g91;	/* no: G52 and G92 in G91 are refused */
	/* Tool lengths. */
	enum h_missing h_missing;
	enum h_zero h_zero;
	enum h_alone h_alone;	/* not known: H needs G43 in its block */
	enum answer d_alone;	/* D is allowed in any block: it moves nothing */
	enum d_word d_word;
	enum answer comp_waits;	/* G41 without a move starts with the next move; no: the machine file says when */
	enum answer length_axis_asked;	/* a parameter decides along which axis the length acts */
	enum answer length_never_moves;	/* a change of the length moves no axis; no: the machine file says it */
	enum answer g49_finds_length_gone;	/* after G28, G30, G53, which may have cancelled the length */
	const char *call_letters;	/* letters of words of M97 to M99; NULL: none */
};

struct dialect {
	const char *name;
	const char *manual;	/* the control's manual that is the source of the rows; their `what` is the topic */
	const struct code_set *g_codes[CODE_SETS_MAX], *m_codes[CODE_SETS_MAX];	/* searched in this order */
	const struct word_set *words[CODE_SETS_MAX];	/* of its language; for listings only: the hooks read them */
	struct dialect_traits traits;
	/* Hooks; NULL: the control has no such function. Each reports the fault before it returns false. */
	/* The hooks' data of a program, in interp->dialect_state; both hooks or none. */
	void *(*state_new)(void);
	void (*state_free)(void *state);
	/*
	 * Carries out the current line if it is a statement and no block, such as control flow: then *done is true. If
	 * interp->block.plain is set, the line has been read as a plain block; the hook clears it if the G-code has
	 * another meaning on this control.
	 */
	bool (*statement)(struct interp *interp, bool *done);
	/*
	 * Updates the length compensation after G28, G30, G53 or DOUBT_M6 (state.h) has moved the marked axes. NULL:
	 * whether an active length is still active is not known.
	 */
	void (*after_machine_move)(struct interp *interp, int code, const bool moved[SLOT_COUNT]);
	/*
	 * Fills interp->block from the current line, which is no plain block. A block without words does nothing. NULL:
	 * the syntax of blocks is not known, and no line is read as a plain block.
	 */
	bool (*read_block)(struct interp *interp);
	/* Called after the block has been read and checked, before it is carried out: its assignments take effect. */
	bool (*before_block)(struct interp *interp);
	/* Called after the block has been carried out: calls and returns. */
	bool (*after_block)(struct interp *interp);
	/* Called at the end of the current file; may jump elsewhere. False: a statement in the file is not closed. */
	bool (*end_of_file)(struct interp *interp);
	/* Is this line of the file the head of a main program? Behind the end it is an error. NULL: there are none. */
	bool (*heads_main)(const char *text);
	/*
	 * The active calls: level 0 is the call of the current subprogram, 1 the call of its caller. *at is the place
	 * of the call; *title, unless NULL, receives the name of the callee. False: the level does not exist.
	 */
	bool (*caller)(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);
};

/*
 * Is the control's answer known? False: reported at the column; `question` says what is not known, as in "whether P of
 * G4 is in seconds".
 */
bool dialect_answers(const struct dialect *dialect, const struct line_place *at, int column, int answer,
		     const char *question);

/*
 * Reports a number without a decimal point whose unit neither the control nor least_input of the machine file gives:
 * the possible units differ by a factor of a thousand. Returns false.
 */
bool dialect_refuse_whole_number(const struct line_place *at, int column, char letter, double value);

/* Are all cycle_traits of the control known? A cycle depends on several of them. False: reported at the column. */
bool dialect_answers_cycles(const struct dialect *dialect, const struct line_place *at, int column);

#endif
