#include "gcode/dialect.h"

bool dialect_answers(const struct dialect *dialect, const struct line_place *at, int column, int answer,
		     const char *question)
{
	if (answer)
		return true;
	return fault(at, column, "it is not known %s in the %s dialect", question, dialect->name);
}

bool dialect_refuse_whole_number(const struct line_place *at, int column, char letter, double value)
{
	return fault(
	    at, column,
	    "%c%.15g has no decimal point, and a parameter of the control decides whether it counts whole units or "
	    "increments: set least_input=\"1\" (whole units) or \"0.001\" (0.001 mm, 0.0001 inch) in the machine "
	    "file's <controller>",
	    letter, value);
}

bool dialect_answers_cycles(const struct dialect *dialect, const struct line_place *at, int column)
{
	const struct cycle_traits *traits = dialect->traits.cycles;

	if (!dialect_answers(dialect, at, column, traits != NULL, "how canned cycles drill"))
		return false;
	const struct {
		int answer;
		const char *question;
	} questions[] = {
		{traits->words_outlive_cycle, "whether words remain valid for the next canned cycle"},
		{traits->words_keep_place, "what a kept R of a canned cycle means after G90 or G91"},
		{traits->without_axes, "what a canned cycle without axis words does"},
		{traits->starts_at_r, "whether canned cycles retract to R before any G98 or G99"},
		{traits->never_below_r, "whether canned cycles with G98 retract below R"},
		{traits->level_is_coordinate, "whether the initial level of G98 is a coordinate"},
		{traits->p_is_needed, "which canned cycles use P as dwell"},
		{traits->q_has_sign, "whether Q of a canned cycle has a sign"},
		{traits->zero_repeats_refused, "what a canned cycle with 0 repetitions does"},
		{traits->only_xyz, "whether canned cycles move rotary axes"},
		{traits->spindle_must_turn, "whether canned cycles start the spindle"},
		{traits->axis_by_parameter, "which axis drills in planes other than G17"},
		{traits->taps_confuse_planes, "where G74 and G84 move in planes other than G17"},
		{traits->feeds_to_clear, "how far taps and G89 retract at the feed"},
		{traits->rises_first, "at which height canned cycles move to their first hole"},
		{traits->exact_path, "whether canned cycles drill in exact path mode"},
		{(int)traits->g87, "how G87 bores"},
		{traits->pecks_fall, "whether I, J and K are the pecks of a drilling cycle"},
		{traits->shift_by_ij, "whether I and J are the shift of boring cycles"},
		{traits->repeat_letter, "which word repeats a canned cycle"},
	};

	for (size_t i = 0; i < sizeof(questions) / sizeof(questions[0]); i++) {
		if (!dialect_answers(dialect, at, column, questions[i].answer, questions[i].question))
			return false;
	}
	return true;
}
