#include "gcode/dialect/klartext/machine/klartext_function.h"

#include <string.h>

#include "gcode/dialect/klartext/flow/klartext_flow.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/frames/klartext_preset.h"
#include "gcode/dialect/klartext/machine/klartext_system.h"
#include "gcode/dialect/klartext/moves/klartext_comp.h"
#include "gcode/dialect/klartext/moves/klartext_move.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_formula.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/execute/tool_length.h"

/* ---------------------------------------------------------------------- FN */

/*
 * iTNC 530 user's manual, "Additional functions": the effect that a checker cannot know; NULL: the function moves
 * nothing.
 */
static bool run_other(struct lexer *lexer, int number, int column)
{
	switch (number) {
	case 14:
		return fault(lexer->at, column, "FN 14 stops the program here with an error of its own");
	case 15: /* prints */
	case 16:
	case 26: /* opens a table */
	case 27: /* writes into a table */
	case 29: /* tells the PLC */
	case 38: /* sends */
		return true;
	case 17:
		return fault(
		    lexer->at, column,
		    "FN 17 writes data of the control: what that changes is not known here; leave it out to check "
		    "the program");
	case 18:
		return klartext_system_read(lexer);
	case 20:
		/* The control waits until the axes have carried out all blocks that were read ahead. */
		if (klartext_take(lexer, "WAIT") && klartext_take(lexer, "FOR") && klartext_take(lexer, "SYNC")) {
			klartext_system_synchronise(lexer->context);
			return true;
		}
		return fault(lexer->at, column, "FN %d: what the machine's PLC does is not known here", number);
	case 19:
		return fault(lexer->at, column, "FN %d: what the machine's PLC does is not known here", number);
	case 28:
		return klartext_system_read_table(lexer);
	default:
		return fault(lexer->at, column, "FN %d is not supported", number);
	}
}

bool klartext_function_run(struct lexer *lexer)
{
	int column = lexer_next_column(lexer), number;

	if (!klartext_integer(lexer, "the number of FN", 0, 99, &number))
		return false;
	if (lexer_peek(lexer) != ':')
		return fault(lexer->at, lexer_column(lexer), "':' is needed here");
	lexer_take(lexer);
	if (number <= 8 || number == 13)
		return klartext_formula_function(lexer, number);
	if (number >= 9 && number <= 12)
		return klartext_flow_jump(lexer, number);
	return run_other(lexer, number, column);
}

/* ---------------------------------------------------------------- FUNCTION */

static bool switch_tcpm(struct interp *interp, bool on, int column)
{
	if (on && !klartext_comp_check_known(interp, column, "TCPM"))
		return false;
	if (klartext_of(interp)->stay.waits)
		return fault(&interp->at, column, "TCPM before the rotary axes stand where PLANE ... STAY needs them");
	if (on == (interp->state.tcp == TCP_BY_MCODE))
		return true;
	if (!on)
		return klartext_move_end_tcp(interp, column);
	return klartext_preset_check(interp, column) && klartext_frame_check_zero(interp, column) &&
	       tool_length_switch_tcp(interp, column, TCP_BY_MCODE);
}

/* Reads TCP or CONT after F. MAX or a value limits only the feed of compensating moves. */
static bool read_tcpm_feed(struct lexer *lexer, int column)
{
	double unused;

	if (klartext_value_follows(lexer))
		return klartext_value(lexer, &unused);
	return klartext_take(lexer, "TCP") || klartext_take(lexer, "CONT") || klartext_take(lexer, "MAX") ||
	       fault(lexer->at, column, "F of TCPM is TCP, CONT, MAX or a feed rate");
}

/*
 * "FUNCTION TCPM": F TCP and F CONT select what the feed rate refers to. With AXIS POS, rotary words are positions of
 * the axes; with AXIS SPAT, spatial angles. With PATHCTRL AXIS the axes move linearly; with PATHCTRL VECTOR the tool
 * turns in the plane of its first and last directions.
 */
static bool read_tcpm(struct lexer *lexer)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer);
	bool positions = false, path = false, spatial = false, vector = false;

	while (!klartext_ends(lexer)) {
		int word = lexer_next_column(lexer);

		if (klartext_take(lexer, "FMAX"))
			continue;
		if (klartext_take(lexer, "F")) {
			if (!read_tcpm_feed(lexer, word))
				return false;
		} else if (klartext_take(lexer, "AXIS")) {
			if (positions)
				return fault(lexer->at, word, "AXIS stands twice in the block");
			spatial = klartext_take(lexer, "SPAT");
			positions = spatial || klartext_take(lexer, "POS");
			if (!positions)
				return fault(lexer->at, word, "AXIS of TCPM is POS or SPAT");
		} else if (klartext_take(lexer, "PATHCTRL")) {
			if (path)
				return fault(lexer->at, word, "PATHCTRL stands twice in the block");
			vector = klartext_take(lexer, "VECTOR");
			path = vector || klartext_take(lexer, "AXIS");
			if (!path)
				return fault(lexer->at, word, "PATHCTRL of TCPM is AXIS or VECTOR");
		} else if (klartext_take(lexer, "REFPNT")) {
			if (!klartext_take(lexer, "TIP-TIP"))
				return fault(lexer->at, word, "REFPNT other than TIP-TIP is not supported");
		} else {
			return fault(lexer->at, word, "this is no word of FUNCTION TCPM");
		}
	}
	if (!positions || !path)
		return fault(lexer->at, column, "FUNCTION TCPM needs AXIS POS or SPAT, and PATHCTRL AXIS or VECTOR");
	if (!switch_tcpm(interp, true, column))
		return false;
	klartext_of(interp)->tcpm.spatial = spatial;
	klartext_of(interp)->tcpm.by_vector = vector;
	memset(klartext_of(interp)->tcpm.given, 0, sizeof(klartext_of(interp)->tcpm.given));
	return true;
}

/* TNC 640 user's manual: functions that move no axis and change at most feed rates, speeds, monitoring or a counter. */
static bool is_harmless(const char *word)
{
	static const char *const words[] = {"FEED", "DWELL", "S", "DCM", "AFC", "COUNT", "HEARTBEAT", "LIFTOFF"};

	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (!strcmp(word, words[i]))
			return true;
	}
	return false;
}

/* The files that a program copies, moves or deletes may be programs that it calls later. */
static bool change_files(struct lexer *lexer, int column)
{
	static const char *const words[] = {"FILE", "FILECOPY", "FILEMOVE", "FILEDELETE"};

	for (size_t i = 0; i < sizeof(words) / sizeof(words[0]); i++) {
		if (!klartext_take(lexer, words[i]))
			continue;
		caution(lexer->at, column, "FUNCTION %s is not carried out: called programs are read as they are now",
			words[i]);
		return true;
	}
	return false;
}

/*
 * Takes words that end a function which is not supported, so that they end nothing. PARAXCOMP DISPLAY matters only on a
 * machine with parallel axes.
 */
static bool ends_nothing(struct lexer *lexer)
{
	const bool *has = ((const struct interp *)lexer->context)->config->has_axis;

	if (klartext_take(lexer, "POLARKIN") || klartext_take(lexer, "PARAXMODE"))
		return klartext_take(lexer, "OFF");
	if (klartext_take(lexer, "PARAXCOMP"))
		return klartext_take(lexer, "OFF") ||
		       (klartext_take(lexer, "DISPLAY") && !has[SLOT_U] && !has[SLOT_V] && !has[SLOT_W]);
	if (klartext_take(lexer, "CORRDATA"))
		return klartext_take(lexer, "RESET");
	return klartext_take(lexer, "PROG") && klartext_take(lexer, "PATH") && klartext_take(lexer, "OFF");
}

bool klartext_function_mode(struct lexer *lexer)
{
	int column = lexer_next_column(lexer);
	struct lexer ahead = *lexer;
	char word[KLARTEXT_WORD];

	klartext_word(&ahead, word);
	if (!strcmp(word, "COUNT") && klartext_take(&ahead, "REPEAT"))
		return fault(lexer->at, column,
			     "FUNCTION COUNT REPEAT: how often it jumps the counter of the control says; to check the "
			     "program, write CALL LBL ... REP 1 in its place");
	if (is_harmless(word))
		return true;
	if (klartext_take(lexer, "TCPM"))
		return read_tcpm(lexer);
	if (klartext_take(lexer, "RESET")) {
		if (klartext_take(lexer, "S-PULSE") || klartext_take(lexer, "FEED"))
			return true;
		if (klartext_take(lexer, "TCPM")) {
			klartext_of(lexer->context)->tcpm.spatial = false;
			return klartext_expect_end(lexer) && switch_tcpm(lexer->context, false, column);
		}
	}
	if (ends_nothing(lexer) || change_files(lexer, column))
		return true;
	if (klartext_take(lexer, "MODE") && klartext_take(lexer, "MILL"))
		return klartext_ends(lexer) ||
		       fault(lexer->at, lexer_next_column(lexer),
			     "FUNCTION MODE MILL with another kinematics is not supported: leave its "
			     "name out, and check the program with the machine file of these "
			     "kinematics");
	return fault(lexer->at, column, "this FUNCTION is not supported; TCPM, RESET TCPM and MODE MILL are");
}
