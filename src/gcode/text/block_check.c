#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/text/block.h"
#include "gcode/text/block_letters.h"

/* Is the code one of group 0 that uses the block's axis words (LinuxCNC's manual, "G Code Best Practices")? */
static bool takes_axis_words(int code)
{
	return code == G10 || code == G12 || code == G13 || code == G28 || code == G30 || code == G52 || code == G92 ||
	       code == G7_1 || code == G22 || code == G150;
}

static bool is_arc(int code)
{
	return code == G2 || code == G3;
}

/* The column of the first of these axis and arc words in the block, or 0. */
static int first_column(const struct block *block, uint32_t letters)
{
	int first = 0;

	letters &= block->letters;
	/* Most blocks have only X, Y and Z. */
	for (const char *letter = "XYZIJKRABCUVW"; letters && *letter; letter++) {
		int column = block_column(block, *letter);

		if ((letters & letter_bit(*letter)) && (first == 0 || column < first))
			first = column;
		letters &= ~letter_bit(*letter);
	}
	return first;
}

int block_motion_column(const struct block *block)
{
	return block->g[G_MOTION] != CODE_NONE ? block->g_column[G_MOTION] : first_column(block, AXIS_BITS | ARC_BITS);
}

/* For a code that uses the block's words: the block has no motion and no code of group 0. False: reported. */
static bool stands_apart(struct block *block, const struct line_place *at, enum g_group group, const char *message)
{
	block->motion = CODE_NONE;
	return (block->g[G_MOTION] == CODE_NONE && block->g[G_NONMODAL] == CODE_NONE) ||
	       fault(at, block->g_column[group], "G%g%s", block->g[group] / 10.0, message);
}

/* Do the words belong to G51, G60, G68 or to mirrored axes? *good is false after a fault. */
static bool belong_to_mode(struct block *block, const struct line_place *at, bool axes, bool *good)
{
	const int given = block->g[G_MOTION], other = block->g[G_NONMODAL];

	if ((block->g[G_LENGTH] == G43_1 || block->g[G_LENGTH] == G43_2) && axes) {
		*good = stands_apart(block, at, G_LENGTH, " with axis words needs a block without motion and offsets");
	} else if (block->g[G_CONTOUR] == G5_1 && axes && given == CODE_NONE) {
		*good = stands_apart(block, at, G_CONTOUR, " with axis words needs a block without motion and offsets");
	} else if (block->g[G_MIRROR] != CODE_NONE && axes) {
		*good = stands_apart(block, at, G_MIRROR, " with axis words needs a block without motion and offsets");
	} else if (block->g[G_SCALING] == G51) {
		*good = stands_apart(block, at, G_SCALING, " needs a block without motion and offsets");
	} else if (block->g[G_APPROACH] != CODE_NONE && axes) {
		block->motion = G0;
		*good = ((given == CODE_NONE || given == G0 || given == G80) && other == CODE_NONE) ||
			fault(at, block->g_column[G_APPROACH],
			      "G60 positions the axes itself; it needs a block without another motion or offset");
	} else if (block->g[G_ROTATION] == G68 || code_tilts(block->g[G_ROTATION])) {
		block->motion = CODE_NONE;
		*good = (given == CODE_NONE && other == CODE_NONE) ||
			fault(at, block->g_column[given != CODE_NONE ? G_MOTION : G_NONMODAL],
			      "G%g needs a block without motion, offsets or a dwell",
			      block->g[G_ROTATION] / 10.0);
	} else {
		return false;
	}
	return true;
}

/* The words belong to a code of group 0, and not to a motion of the block. False: reported. */
static bool check_beside_nonmodal(struct block *block, const struct line_place *at,
				  const struct dialect_traits *traits, bool axes)
{
	const int given = block->g[G_MOTION], other = block->g[G_NONMODAL];
	const bool beside = given >= G0 && given <= G3 && traits->motion_beside_words == ANSWER_YES;

	if (beside)
		block->motion = CODE_NONE;
	else if (given != CODE_NONE && given != G80)
		return fault(at, block->g_column[G_MOTION],
			     "G%g and G%g both need the axis words of the block; write two blocks", given / 10.0,
			     other / 10.0);
	if (!axes && (other == G52 || other == G92))
		return fault(at, block->g_column[G_NONMODAL], "G%d without an axis word", other / 10);
	return true;
}

/* The words belong to the motion of the block, to the modal motion, or to none. False: reported. */
static bool find_in_force(struct block *block, const struct line_place *at, const struct dialect_traits *traits,
			  const struct block_modes *modes)
{
	const bool axes = block->letters & AXIS_BITS;
	const bool offsets = block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K'));

	if (block->g[G_MOTION] == G80 && axes && modes->after_g80 == CODE_NONE)
		return fault(at, first_column(block, AXIS_BITS),
			     "axis words with G80, which cancels motion; write a motion code instead");
	if (block->g[G_MOTION] == G80 && axes)
		block->motion = modes->after_g80;
	if (block->g[G_MOTION] != CODE_NONE)
		return true;
	if (axes && modes->motion == CODE_NONE)
		return fault(at, first_column(block, AXIS_BITS),
			     "axis words without an active motion code (G0, G1, G2, G3)%s",
			     traits->power_on.asks_motion
				 ? "; set power_on_motion=\"rapid\" or \"feed\" (the motion code at power-on) in the "
				   "machine file's <controller>"
				 : "");
	if (axes || (offsets && (is_arc(modes->motion) || modes->motion == G6_2 || block->vectors)))
		block->motion = modes->motion;
	return true;
}

/* Finds the motion to which the block's words belong: NIST RS274/NGC, 3.8; LinuxCNC's manual, "Modal Groups". */
static bool find_motion(struct block *block, const struct line_place *at, const struct dialect_traits *traits,
			const struct block_modes *modes)
{
	const int other = block->g[G_NONMODAL];
	const bool axes = block->letters & AXIS_BITS;
	bool good = true;

	block->motion = block->g[G_MOTION];
	if (belong_to_mode(block, at, axes, &good))
		return good;
	if (takes_axis_words(other) || (other == G92_1 && traits->one_shift == ANSWER_NO))
		return check_beside_nonmodal(block, at, traits, axes);
	return find_in_force(block, at, traits, modes);
}

/* "one word, X, U or P" */
static bool fault_without_time(const struct block *block, const struct line_place *at, const char *letters)
{
	char text[64] = "";
	size_t count = strlen(letters), length = 0;

	for (size_t i = 0; i < count; i++)
		length += (size_t)snprintf(text + length, sizeof(text) - length, "%s%c",
					   i == 0	   ? ""
					   : i + 1 < count ? ", "
							   : " or ",
					   letters[i]);
	return fault(at, block->g_column[G_NONMODAL], "G4 needs its time in %s%s", count > 1 ? "one word, " : "", text);
}

/* A dwell has its time in one of several letters; if its block may have a motion, other axis words belong to that. */
static bool check_dwell(struct block *block, const struct line_place *at, const struct dialect *dialect)
{
	const char *letters = dialect->traits.dwell_letters ? dialect->traits.dwell_letters : "";
	int column = block->g_column[G_NONMODAL];
	bool alone = dialect->traits.dwell_alone == ANSWER_YES;
	uint32_t times, given;

	if (!dialect_answers(dialect, at, column, letters[0] != '\0', "which word of G4 is its time") ||
	    !dialect_answers(dialect, at, column, (int)dialect->traits.dwell_alone,
			     "whether G4 is allowed in a block with motion"))
		return false;
	times = letter_bits(letters);
	given = block->letters & (alone ? times | AXIS_BITS : times);
	if (alone)
		block->motion = CODE_NONE;
	if (alone && block->g[G_MOTION] != CODE_NONE)
		return fault(at, block->g_column[G_MOTION], "G4 needs a block without motion");
	if (given == 0 || (given & ~times) || (given & (given - 1)))
		return fault_without_time(block, at, letters);
	if (is_arc(block->motion))
		return fault(at, column, "G4 is not allowed with G2 or G3, which also use P");
	return true;
}

static bool check_machine_coordinates(struct block *block, const struct line_place *at,
				      const struct gcode_config *config, const struct block_modes *modes)
{
	const struct dialect *dialect = config->dialect;
	enum g53_with_g91 answer = config->controller.g53_with_g91;
	bool incremental = block->g[G_DISTANCE] == CODE_NONE ? modes->incremental : block->g[G_DISTANCE] == G91;
	bool axes = block->letters & AXIS_BITS;

	if (!axes && block->motion == CODE_NONE) {
		if (!dialect_answers(dialect, at, block->g_column[G_NONMODAL], (int)dialect->traits.g53_alone,
				     "what G53 without axis words does"))
			return false;
		if (dialect->traits.g53_alone == ANSWER_YES)
			return true;
	}
	/* G53 is a rapid whatever the active motion, which stays active. */
	if (dialect->traits.g53_rate == G53_RATE_RAPID && block->g[G_MOTION] == CODE_NONE && is_arc(block->motion))
		block->motion = G0;
	if (block->motion != G0 && block->motion != G1)
		return fault(at, block->g_column[G_NONMODAL], "G53 needs G0 or G1");
	if (!incremental || answer == G53_WITH_G91_ABSOLUTE)
		return true;
	if (answer == G53_WITH_G91_INCREMENTAL)
		block->g[G_NONMODAL] = CODE_NONE;
	else if (dialect->traits.g53_asks_g91 == ANSWER_YES)
		return fault(
		    at, block->g_column[G_NONMODAL],
		    "G53 in incremental mode (G91) depends on the control: set g53_with_g91=\"absolute\" or "
		    "\"incremental\" in the machine file's <controller>");
	else
		return fault(at, block->g_column[G_NONMODAL], "G53 in incremental mode (G91); write G90 first");
	return true;
}

static bool check_nonmodal(struct block *block, const struct line_place *at, const struct gcode_config *config,
			   const struct block_modes *modes)
{
	const struct dialect *dialect = config->dialect;
	int code = block->g[G_NONMODAL];

	if (code == G4)
		return check_dwell(block, at, dialect);
	if ((code == G53_1 || code == G53_6) && (block->motion != CODE_NONE || (block->letters & AXIS_BITS)))
		return fault(at, block->g_column[G_NONMODAL], "G%g needs a block without motion", code / 10.0);
	if (code == G53)
		return check_machine_coordinates(block, at, config, modes);
	if ((code != G28 && code != G30) || (block->letters & AXIS_BITS))
		return true;
	if (!dialect_answers(dialect, at, block->g_column[G_NONMODAL], (int)dialect->traits.g28_without_axes,
			     "which axes G28 and G30 without an axis word move"))
		return false;
	if (dialect->traits.g28_without_axes == G28_WITHOUT_AXES_REFUSED)
		return fault(at, block->g_column[G_NONMODAL], "G%d without an axis word", code / 10);
	return true;
}

/* LinuxCNC's manual, "M66 Wait on Input". */
static bool check_input(const struct block *block, const struct line_place *at)
{
	bool digital = block_has(block, 'P') && block_value(block, 'P') >= 0;
	bool analog = block_has(block, 'E') && block_value(block, 'E') >= 0;
	bool waits = block_has(block, 'Q') && block_value(block, 'Q') > 0;
	int column = block->m_column[M_OUTPUT], way = 0;

	if (digital == analog)
		return fault(at, column, "M66 needs the number of one input, in either P or E");
	if (block_has(block, 'L') && !block_integer(block, at, 'L', 0, 4, &way))
		return false;
	if (way > 0 && (analog || !waits))
		return fault(at, block_column(block, 'L'), "M66 with L%d needs P (input) and Q (timeout)", way);
	return true;
}

static bool check_output(const struct block *block, const struct line_place *at)
{
	int code = block->m[M_OUTPUT], column = block->m_column[M_OUTPUT];
	char letter = code < 66 ? 'P' : 'E';

	if (code == CODE_NONE)
		return true;
	if (code == 66)
		return check_input(block, at);
	if (!block_has(block, letter))
		return fault(at, column, "M%d needs %c (number of the output)", code, letter);
	if (letter == 'E' && block_value(block, 'E') < 0)
		return fault(at, block_column(block, 'E'), "the number of an output must not be negative");
	return true;
}

/* "G54.1", "M98" */
static void name_claim(const struct block_claim *claim, char *name, size_t size)
{
	if (claim->kind == 'G')
		snprintf(name, size, "G%g", claim->code / 10.0);
	else
		snprintf(name, size, "M%d", claim->code);
}

/* The first letter of a set of bits. */
static char first_letter(uint32_t bits)
{
	char letter = 'A';

	while (!(bits & letter_bit(letter)))
		letter++;
	return letter;
}

/* Checks a word that two codes take. D and H are numbers of a table, the same for both codes. */
static bool check_apart(const struct block *block, const struct line_place *at, const struct block_claim *one,
			const struct block_claim *other)
{
	const uint32_t both = one->letters & other->letters & block->letters & ~letter_bits("DH");
	char names[2][16], letter;

	if (both == 0 || one->kind == '\0' || other->kind == '\0')
		return true;
	letter = first_letter(both);
	name_claim(one, names[0], sizeof(names[0]));
	name_claim(other, names[1], sizeof(names[1]));
	return fault(at, block_column(block, letter),
		     "%c can belong to %s or to %s, and it is not known to which; write two blocks", letter,
		     names[0], names[1]);
}

/* Checks that every word belongs to a code, and only to one unless the control gives the word to several codes. */
static bool check_words(const struct block *block, const struct line_place *at, const struct dialect *dialect)
{
	struct block_claim claims[BLOCK_CLAIMS_MAX];
	const int count = block_claims(block, dialect, claims);
	uint32_t unused = block->letters;
	char letter;

	for (int i = 0; i < count; i++) {
		unused &= ~claims[i].letters;
		for (int j = 0; j < i && dialect->traits.words_are_shared != ANSWER_YES; j++) {
			if (!check_apart(block, at, &claims[j], &claims[i]))
				return false;
		}
	}
	if (unused == 0)
		return true;
	letter = first_letter(unused);
	return fault(at, block_column(block, letter), "no code in the block uses the word %c%s", letter,
		     letter == 'E' ? "; numbers cannot have an exponent" : "");
}

/* Axis words of such a code name the axes that are not mirrored or scaled any more, and move nothing. */
static bool check_idle(const struct block *block, const struct line_place *at)
{
	if (block->idle == CODE_NONE || !(block->letters & AXIS_BITS))
		return true;
	return fault(at, block->idle_column, "G%g needs a block without axis words", block->idle / 10.0);
}

static bool check_order(const struct block *block, const struct line_place *at, const struct gcode_config *config)
{
	int code = block->g[G_NONMODAL];
	bool moves = (code != G4 && (block->letters & AXIS_BITS)) || code == G28 || code == G30 || code == G53_1 ||
		     code == G53_6 ||
		     ((block->g[G_LENGTH] != CODE_NONE || block_has(block, 'H')) &&
		      config->controller.length_moves == ANSWER_YES);
	int group = block->m[M_TOOL] != CODE_NONE ? M_TOOL : M_TCP;

	if (config->dialect->traits.known_order == ANSWER_YES || block->m[group] == CODE_NONE || !moves)
		return true;
	if (group == M_TCP)
		return fault(at, block->m_column[group],
			     "an M-code that switches TCP in a block with motion: controls differ in whether it comes "
			     "before or after the move; write two blocks");
	return config->controller.m6_with_move != M6_WITH_MOVE_UNKNOWN ||
	       fault(
		   at, block->m_column[group],
		   "M6 in a block with motion: the machine builder decides whether it comes before or after the move: "
		   "set m6_with_move=\"after\" or \"before\" in the machine file's <controller>, or write two blocks");
}

/* LinuxCNC asks for G17 before the block, not in it. */
static bool check_polar(const struct block *block, const struct line_place *at, const struct block_modes *modes)
{
	if (block->polar && modes->plane != G17)
		return fault(at, first_column(block, block->polar),
			     "polar coordinates (@, ^) need the plane G17 in a block before");
	if (!block->polar || (block->motion >= G0 && block->motion <= G3 && block->g[G_NONMODAL] == CODE_NONE))
		return true;
	return fault(at, first_column(block, block->polar),
		     "polar coordinates (@, ^) are supported with G0, G1, G2 and G3 alone");
}

bool block_check(struct block *block, const struct line_place *at, const struct gcode_config *config,
		 const struct block_modes *modes)
{
	const struct dialect *dialect = config->dialect;
	int length = block->g[G_LENGTH];

	block->vectors = length == G43_5 || (modes->vectors && length == CODE_NONE);
	if (!check_idle(block, at))
		return false;
	if (!(dialect->traits.dwell_alone == ANSWER_YES && block->g[G_NONMODAL] == G4) &&
	    !find_motion(block, at, &dialect->traits, modes))
		return false;
	if (block->g[G_MOTION] > G3 && block->g[G_MOTION] != G80 && block->g[G_MOTION] != G5_2 &&
	    block->g[G_MOTION] != G5_3 && block->g[G_MOTION] != G6_2 && !(block->letters & AXIS_BITS) &&
	    !(dialect->traits.cycles && dialect->traits.cycles->without_axes == ANSWER_YES))
		return fault(at, block->g_column[G_MOTION], "G%g without an axis word", block->g[G_MOTION] / 10.0);
	if (block->g[G_NONMODAL] != CODE_NONE && !check_nonmodal(block, at, config, modes))
		return false;
	if (!check_polar(block, at, modes) || !check_order(block, at, config) || !check_output(block, at))
		return false;
	if (block->g[G_SPINDLE] == G96 && !block_has(block, 'S'))
		return fault(at, block->g_column[G_SPINDLE], "G96 needs S (surface speed)");
	return check_words(block, at, dialect);
}

bool block_integer(const struct block *block, const struct line_place *at, char letter, int least, int greatest,
		   int *value)
{
	double number = block_value(block, letter), nearest = round(number);

	/* LinuxCNC's tolerance for "close to an integer". */
	if (fabs(number - nearest) > 0.0001 || nearest < least || nearest > greatest)
		return fault(at, block_column(block, letter), "%c%.15g must be a whole number from %d to %d", letter,
			     number, least, greatest);
	*value = (int)nearest;
	return true;
}
