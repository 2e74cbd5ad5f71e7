/* dialect.h - how one control reads and carries out programs: its codes, its answers as data, and what only it does. */
#ifndef FIVECHECK_GCODE_DIALECT_H
#define FIVECHECK_GCODE_DIALECT_H

#include <stdbool.h>

#include "base/axes.h"
#include "control/controller.h"
#include "gcode/code.h"
#include "gcode/text/fault.h"

struct interp;

/*
 * A control is one folder of gcode/dialect with a table of this type, and one
 * row of control/dialects.h; no other file asks which control it is. It inherits
 * nothing: an answer that its table leaves out is 0, which is "not known", and
 * a program that needs the answer is refused (dialect_answers). Rows of codes
 * that several controls share are sets that each of them names.
 *
 * What a new control does in its own way is an answer here if others may do it
 * differently, too (add a member, and let the code that carries it out ask by
 * is_answered), and a hook in its folder if it is a language of its own.
 */

/* What a number without a decimal point means: whole units, or what the machine file's least_input says. */
enum whole_numbers { WHOLE_NUMBERS_UNKNOWN, WHOLE_NUMBERS_UNITS, WHOLE_NUMBERS_INCREMENTS };

/* The P of a dwell: seconds, or milliseconds if it has no decimal point. */
enum dwell_p { DWELL_P_UNKNOWN, DWELL_P_SECONDS, DWELL_P_MILLISECONDS };

/* When the feed in force is forgotten: with every G94 and G95, or where its unit changes. */
enum feed_forgotten { FEED_FORGOTTEN_UNKNOWN, FEED_FORGOTTEN_BY_CODE, FEED_FORGOTTEN_BY_CHANGE };

/* A G1 that names no axis: it needs a feed all the same, or it is ignored. */
enum empty_feed_move { EMPTY_FEED_MOVE_UNKNOWN, EMPTY_FEED_MOVE_CHECKED, EMPTY_FEED_MOVE_IGNORED };

/* The centre of an arc before any G90.1 or G91.1: counted from its start, or in program coordinates. */
enum arc_centre { ARC_CENTRE_UNKNOWN, ARC_CENTRE_INCREMENTAL, ARC_CENTRE_ABSOLUTE };

/* An arc with neither a centre nor a radius: an error; or a straight line, unless the control stops there. */
enum arc_without_centre { ARC_WITHOUT_CENTRE_UNKNOWN, ARC_WITHOUT_CENTRE_REFUSED, ARC_WITHOUT_CENTRE_LINE };

/* A feed move before any F: an error; or it goes on at a feed that the control kept, unless that stops. */
enum feed_missing { FEED_MISSING_UNKNOWN, FEED_MISSING_REFUSED, FEED_MISSING_KEPT };

/* ",C" and ",R": none, or a chamfer and a rounding between lines, or between lines and arcs. */
enum corner_words { CORNER_WORDS_UNKNOWN, CORNER_WORDS_WITH_LINES, CORNER_WORDS_WITH_ARCS };

/* What D of cutter compensation is: a tool, whose diameter is taken, or an offset that holds a radius. */
enum d_word { D_WORD_UNKNOWN, D_WORD_TOOL, D_WORD_RADIUS };

/* What T does. */
enum t_word { T_WORD_UNKNOWN, T_WORD_SELECTS };

/* How G53 moves: at the rapid rate, or as G0 and G1 say. */
enum g53_rate { G53_RATE_UNKNOWN, G53_RATE_PROGRAMMED, G53_RATE_RAPID };

/* What machine coordinates are while an M-code of the machine has TCP on: those of the axes or of the tool point. */
enum g53_under_tcp { G53_UNDER_TCP_UNKNOWN, G53_UNDER_TCP_AXES, G53_UNDER_TCP_TOOL_POINT };

/* G28 and G30 without an axis word: all axes go, or it is an error. */
enum g28_without_axes { G28_WITHOUT_AXES_UNKNOWN, G28_WITHOUT_AXES_ALL, G28_WITHOUT_AXES_REFUSED };

/* G28, G30 and G53 while G68 is in force: refused, or refused where they move an axis of the plane. */
enum turned_by_machine { TURNED_BY_MACHINE_UNKNOWN, TURNED_BY_MACHINE_REFUSED, TURNED_BY_MACHINE_ACROSS };

/* G10 L20: gives the present position a coordinate, or writes an additional work offset. */
enum g10_l20 { G10_L20_UNKNOWN, G10_L20_HERE, G10_L20_ADDITIONAL };

/* G10 L2 with G91: writes the words, or adds them to the offset. */
enum g10_incremental { G10_INCREMENTAL_UNKNOWN, G10_INCREMENTAL_WRITES, G10_INCREMENTAL_ADDS };

/* G43 without H: takes the tool in the spindle, the H given last, or is an error. */
enum h_missing { H_MISSING_UNKNOWN, H_MISSING_SPINDLE, H_MISSING_LAST, H_MISSING_REFUSED };

/* H0: the length of the tool in the spindle, or none. */
enum h_zero { H_ZERO_UNKNOWN, H_ZERO_SPINDLE, H_ZERO_NONE };

/* H without G43: where G43 is in force it changes the length; or only H0 does that, and any other is refused. */
enum h_alone { H_ALONE_UNKNOWN, H_ALONE_CHANGES, H_ALONE_CANCELS };

/*
 * G87: back boring beside the axis by I and J, up to K; the same by Q, up to Z; or a bore that the operator leaves by
 * hand.
 */
enum g87 { G87_UNKNOWN, G87_BACK_BY_IJK, G87_BACK_BY_Q, G87_BY_HAND };

/* How canned cycles drill: each answer is needed by each of them. */
struct cycle_traits {
	enum answer words_outlive_cycle;	/* words hold for the next cycle of another code, too */
	/* R and the depth stay where they were, whichever of G90 and G91 follows; no: their words are read anew */
	enum answer words_keep_place;
	enum answer without_axes;	/* a cycle without axis words keeps its words, drills nothing; no: an error */
	enum answer starts_at_r;	/* before any G98 or G99, the tool retracts to R; no: to the level before */
	enum answer never_below_r;	/* with G98, the tool retracts to R where that lies higher */
	enum answer level_is_coordinate;	/* the level changes with the coordinates; no: that is refused */
	enum answer p_is_needed;	/* by G82, G86, G89; no: P is optional, and other cycles take it, too */
	enum answer q_has_sign;	/* a negative Q is an error; no: its sign is ignored */
	enum answer zero_repeats_refused;
	enum answer only_xyz;	/* a rotary axis cannot be named */
	enum answer spindle_must_turn;	/* for taps and bores; no: the control starts it */
	enum answer taps_confuse_planes;	/* G74 and G84 go elsewhere in other planes than that of G17 */
	enum answer feeds_to_clear;	/* taps and G89 leave the hole at the feed; no: they do up to R */
	enum answer rises_first;	/* to R, before it goes over the first hole */
	enum answer exact_path;	/* whatever path mode is in force */
	enum answer any_order;	/* R and Z may lie the wrong way round: the tool goes there, or it is an error */
	enum answer taps_peck;	/* taps may have Q: their pecks lie on the same way */
	enum answer taps_retract_by_j;	/* taps may have J, how fast they retract */
	enum g87 g87;
	enum answer pecks_fall;	/* pecks may have I, J and K in place of Q */
	enum answer shift_by_ij;	/* I and J may stand for the Q of bores, and then say in which direction */
	char repeat_letter;
};

/*
 * Modes at power-on: G-codes in tenths. 0: a parameter of the control decides. Then the machine file says it, or the
 * program must choose before the first word that needs it.
 */
struct power_on {
	int units;	/* G20, G21 */
	int distance;	/* G90, G91 */
	int plane;	/* G17, G18, G19 */
	int feed_mode;	/* G93, G94, G95 */
	int path;	/* G61, G64; 0: not known, so the control may leave the path until the program says G61 */
	bool asks_motion;	/* a parameter decides between G0 and G1; else none is in force */
};

struct dialect_traits {
	enum answer last_of_group;	/* of two G-codes of a group in a block the last one counts; no: an error */
	struct power_on power_on;
	enum whole_numbers whole_numbers;
	enum answer known_order;	/* execute_block has the control's order; no: it is not known */
	/* each code of a block takes a word that several can have; not known, or no: an error */
	enum answer words_are_shared;
	/* G4: the letters that can have its time, and whether it needs a block without motion. */
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
	enum answer arc_radius_wins;	/* an arc with R and a centre takes R; not known, or no: that is an error */
	/* I, J or K of the axis across the plane may be 0; not known, or no: an error */
	enum answer arc_idle_zero;
	enum answer arc_spirals;	/* a parameter says up to which difference of their radii arcs are spirals */
	enum corner_words corner_words;
	/* the parameter that says past how many blocks without a move cutter compensation looks; NULL: none asked */
	const char *idle_blocks_parameter;
	const char *corner_names;	/* of the words in messages; NULL: ",C or ,R" */
	enum answer wrap_below_turn;	/* absolute values of an axis with wrap="sign" lie between -360 and 360 */
	const struct cycle_traits *cycles;	/* NULL: not known */
	/* cycles and G80 are a group beside G0 to G3: G80 brings back which of them was there */
	enum answer cycles_apart;
	/* Moves to places of the machine. */
	/* G0 to G3 beside G10, G28, G30, G52, G92 hold from the next block on; no: an error */
	enum answer motion_beside_words;
	enum g53_rate g53_rate;
	enum g53_under_tcp g53_under_tcp;
	enum answer g53_asks_g91;	/* the machine file says what G53 does in G91; no: that is an error */
	enum answer g53_alone;	/* G53 without motion and axis words does nothing; no: it is an error */
	enum g28_without_axes g28_without_axes;
	enum answer references_in_parameters;	/* programs write G28's and G30's; no: the machine file has G30's */
	enum answer g30_has_number;	/* in P */
	enum answer m19_has_time;	/* in Q: how long to wait for the spindle */
	enum answer m8_has_pressure;	/* in P; not known, or no: M8 takes no P */
	enum turned_by_machine turned_by_machine;
	enum answer g68_in_space;	/* G68 with I, J and K turns about any direction */
	enum t_word t_word;
	enum answer m6_loads_own_t;	/* whichever T waits; no: the machine file says it */
	enum answer tool_change_stays;	/* M6 moves no axis if the machine file names no place; no: it must */
	/* Work offsets. */
	int additional_offsets;	/* of G54.1 or G154 */
	int shared_p;	/* P up to this may be both that of G54 and of another code of the block */
	enum answer g54_has_number;	/* G54 with P is G54.1 */
	int g10_first, g10_last;	/* the P of G10 L2; g10_last 0: not known */
	enum g10_l20 g10_l20;
	enum g10_incremental g10_incremental;
	enum answer g10_writes_tools;	/* L1, L10, L11, and L0 */
	/* L10 and L11 write H and its wear, L12 and L13 D and its wear, from R */
	enum answer g10_writes_registers;
	enum answer one_shift;	/* G52 and G92 write the same shift; no: both at a time are refused */
	enum answer shifts_ignore_g91;	/* no: G52 and G92 in G91 are refused */
	/* Tool lengths. */
	enum h_missing h_missing;
	enum h_zero h_zero;
	enum h_alone h_alone;	/* not known: H needs G43 in its block */
	enum answer d_alone;	/* D may stand in any block: it moves nothing */
	enum d_word d_word;
	enum answer comp_waits;	/* G41 without a move waits for one; no: the machine file says it */
	enum answer length_axis_asked;	/* a parameter decides along which axis the length acts */
	enum answer length_never_moves;	/* its change moves no axis; no: the machine file says it */
	enum answer g49_finds_length_gone;	/* after G28, G30, G53 that may have taken it back */
	const char *call_letters;	/* of M97 to M99; NULL: none */
};

struct dialect {
	const char *name;
	const char *manual;	/* which of the control's manuals the rows were read in; their `what` is the topic */
	const struct code_set *g_codes[CODE_SETS_MAX], *m_codes[CODE_SETS_MAX];	/* looked through in this order */
	const struct word_set *words[CODE_SETS_MAX];	/* of its language; for people only: the hooks read them */
	struct dialect_traits traits;
	/*
	 * Hooks; NULL: the control has no such thing. All report what is wrong
	 * before they return false.
	 */
	/* What the hooks remember of a program, in interp->dialect_state; all or none of the two. */
	void *(*state_new)(void);
	void (*state_free)(void *state);
	/*
	 * The line in hand if it is a statement and no block, such as control flow: then *done is true. Where
	 * interp->block.plain is set the line has been read as a plain block; the hook clears it if the control has
	 * another meaning for its G-code.
	 */
	bool (*statement)(struct interp *interp, bool *done);
	/*
	 * G28, G30, G53 or DOUBT_M6 (state.h) has moved the axes marked: what became of the length compensation.
	 * NULL: that is not known, if there is one.
	 */
	void (*after_machine_move)(struct interp *interp, int code, const bool moved[SLOT_COUNT]);
	/*
	 * Fills interp->block from the line in hand, which is no plain block; no words: there is nothing to carry out.
	 * NULL: not known, and no line is read as a plain block.
	 */
	bool (*read_block)(struct interp *interp);
	/* The block has been read and checked, and nothing of it has been carried out: what it assigns takes effect. */
	bool (*before_block)(struct interp *interp);
	/* The block has been carried out: calls and returns. */
	bool (*after_block)(struct interp *interp);
	/* The file in hand has ended: false if something in it is not closed. It may jump, to where reading goes on. */
	bool (*end_of_file)(struct interp *interp);
	/*
	 * The calls that are under way: 0 is the call of the subprogram in hand, 1 the call of the one that called it.
	 * *at is where the call stands; *title, unless NULL, receives what is called. False: there are not so many.
	 */
	bool (*caller)(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);
};

/*
 * Is the control's answer known? False: reported at the column; `question`
 * says what is not known, as in "whether P of G4 is in seconds".
 */
bool dialect_answers(const struct dialect *dialect, const struct line_place *at, int column, int answer,
		     const char *question);

/*
 * Reports a number without a decimal point where neither the control nor least_input of the machine file says what it
 * counts: the answers are a thousand times apart. False.
 */
bool dialect_refuse_whole_number(const struct line_place *at, int column, char letter, double value);

/* Are all of its cycle_traits known? What a cycle does depends on several at once. False: reported at the column. */
bool dialect_answers_cycles(const struct dialect *dialect, const struct line_place *at, int column);

#endif
