#include "program.h"

#include <algorithm>

static const double PI = 3.14159265358979323846;
static const double INCH = 25.4;

/* Writes lines, and keeps the state of a control after them. */
class Writer {
public:
	Writer(Random &random, const Machine &machine) : random_(random), machine_(machine), at_(machine.home())
	{
		line("G17 G21 G90 G94");
	}

	void step();
	Program finish();

private:
	void line(const std::string &text);
	std::string word(char letter, double value, double *read);
	std::string feed();
	double shift(int axis) const;
	double target(int axis);
	void straight();
	void arc();
	void tip();
	void change_tool();
	void tip_on();
	void length_off();
	bool stays_inside(const Move &move) const;
	void push(Move move);

	Random &random_;
	const Machine &machine_;
	Program program_;
	Position at_;
	int lines_ = 0, tool_ = 0, offset_ = 0;
	bool inch_ = false, relative_ = false, tip_ = false, turns_ = false;
	double length_ = 0;	/* G43 */
};

void Writer::line(const std::string &text)
{
	program_.text += text + "\n";
	lines_++;
}

/* A word for a value in mm or degrees; *read is the value that a control reads. */
std::string Writer::word(char letter, double value, double *read)
{
	bool rotary = letter >= 'A' && letter <= 'C';
	double unit = inch_ && !rotary ? INCH : 1;
	std::string digits = decimal(value / unit, inch_ ? 5 : 4);

	*read = std::stod(digits) * unit;
	return std::string(" ") + letter + digits;
}

std::string Writer::feed()
{
	return " F" + decimal(random_.in(100, 6000) / (inch_ ? INCH : 1), 2);
}

/* The sum of all that is added to a word of G90. */
double Writer::shift(int axis) const
{
	double shift = machine_.has_setup ? machine_.offsets[(size_t)offset_].shift[(size_t)axis] : 0;

	return shift + (machine_.world.axes[axis].letter == 'Z' && !tip_ ? length_ : 0);
}

/* A position that is seldom outside the travel. */
double Writer::target(int axis)
{
	const Travel &travel = machine_.travels[(size_t)axis];
	double value;

	if (random_.chance(0.005))
		return random_.in(travel.low - 20, travel.high + 20);
	if (random_.chance(0.25))
		value = at_[(size_t)axis] + random_.in(-5, 5);
	else
		value = random_.in(travel.low, travel.high);
	/* Rounding of the words must not move the end outside again. */
	return std::min(std::max(value, travel.low + 0.001), travel.high - 0.001);
}

void Writer::push(Move move)
{
	double change = std::fabs(move.sweep);

	move.line = lines_ + 1;
	move.tool = tool_;
	move.from = at_;
	for (size_t i = 0; i < machine_.travels.size(); i++)
		change += std::fabs(move.to[i] - at_[i]);
	at_ = move.to;
	if (change > 0)
		program_.moves.push_back(move);
}

bool Writer::stays_inside(const Move &move) const
{
	for (int k = 0; k <= 32; k++) {
		Position q = position(machine_, move, k / 32.0);

		for (size_t i = 0; i < machine_.travels.size(); i++)
			if (q[i] < machine_.travels[i].low || q[i] > machine_.travels[i].high)
				return false;
	}
	return true;
}

void Writer::straight()
{
	/* Fanuc and Haas move there at rapid, for both G0 and G1, and may cancel the tool length. */
	bool of_machine = !relative_ && length_ <= 0 && random_.chance(0.06), rapid = of_machine || random_.chance(0.4);
	std::string text = std::string(of_machine ? "G53 " : "") + (rapid ? "G0" : "G1");
	Move move;
	int only = random_.below(machine_.world.axis_count);

	move.path = rapid && machine_.rapid == "dogleg" ? Path::DOGLEG : Path::STRAIGHT;
	move.to = at_;
	for (int i = 0; i < machine_.world.axis_count; i++) {
		double origin = relative_ ? at_[(size_t)i] : of_machine ? 0 : shift(i), read;

		if (i != only && random_.chance(0.5))
			continue;
		text += word(machine_.world.axes[i].letter, target(i) - origin, &read);
		move.to[(size_t)i] = origin + read;
	}
	move.cuts = !rapid && turns_;
	push(move);
	line(text + (rapid ? "" : feed()));
}

/* The angle from the start about the centre to the end, at least a little: if both are the same, a full circle. */
static double sweep_of(const Move &move, bool clockwise, bool full)
{
	auto i = (size_t)move.first, j = (size_t)move.second;
	double sweep = std::atan2(move.to[j] - move.centre[1], move.to[i] - move.centre[0]) -
		       std::atan2(move.from[j] - move.centre[1], move.from[i] - move.centre[0]);

	sweep = full ? 0 : sweep;
	if (clockwise)
		return sweep > -1e-9 ? sweep - 2 * PI : sweep;
	return sweep < 1e-9 ? sweep + 2 * PI : sweep;
}

/* An arc in G17, G18 or G19, sometimes with other axes; most arcs that leave the travel are given up. */
void Writer::arc()
{
	static const char *const planes[] = {"XY", "ZX", "YZ"};
	int plane = random_.below(3);
	bool clockwise = random_.chance(0.5), full = random_.chance(0.2);
	double radius = random_.size(1, 50), start = random_.in(0, 2 * PI);
	double end = start + (clockwise ? -1 : 1) * random_.in(0.1, 6), read;
	std::string text = "G" + std::to_string(17 + plane) + (clockwise ? " G2" : " G3");
	Move move;

	move.path = Path::ARC;
	move.first = machine_.axis(planes[plane][0]);
	move.second = machine_.axis(planes[plane][1]);
	move.from = move.to = at_;
	for (int i = 0; i < machine_.world.axis_count; i++) {
		double origin = relative_ ? at_[(size_t)i] : shift(i), wanted;

		if (i == move.first)
			wanted = at_[(size_t)i] + radius * (std::cos(end) - std::cos(start));
		else if (i == move.second)
			wanted = at_[(size_t)i] + radius * (std::sin(end) - std::sin(start));
		else
			wanted = target(i);
		/* A full circle has no words for the axes of its plane. */
		if (i == move.first || i == move.second ? full : random_.chance(0.7))
			continue;
		text += word(machine_.world.axes[i].letter, wanted - origin, &read);
		move.to[(size_t)i] = origin + read;
	}
	for (int k = 0; k < 2; k++) {
		double wanted = -radius * (k ? std::sin(start) : std::cos(start));

		text += word((char)('I' + planes[plane][k] - 'X'), wanted, &read);
		move.centre[k] = at_[(size_t)(k ? move.second : move.first)] + read;
	}
	move.sweep = sweep_of(move, clockwise, full);
	if (!stays_inside(move) && random_.chance(0.95)) {
		straight();
		return;
	}
	move.cuts = turns_;
	push(move);
	line(text + feed());
}

/* All words are given, so that none depends on the meaning of earlier positions under TCP. */
void Writer::tip()
{
	/* The path of a rapid that is not straight is not known under TCP. */
	bool rapid = random_.chance(0.3) && machine_.rapid == "linear";
	std::string text = rapid ? "G0" : "G1";
	Position wanted = at_;
	double read[3];
	vec commanded;
	Move move;

	for (int i = 0; i < machine_.world.axis_count; i++)
		wanted[(size_t)i] = random_.chance(0.5) ? at_[(size_t)i] : target(i);
	for (int i = 0; i < machine_.world.axis_count; i++) {
		double value;

		if (!machine_.world.axes[i].rotary)
			continue;
		text += word(machine_.world.axes[i].letter, wanted[(size_t)i] - shift(i), &value);
		wanted[(size_t)i] = shift(i) + value;
	}
	commanded = commanded_for(machine_, tip_at(machine_, wanted, length_));
	for (int k = 0; k < 3; k++) {
		double value = k == 0 ? commanded.x : k == 1 ? commanded.y : commanded.z;
		int i = machine_.axis("XYZ"[k]);

		text += word("XYZ"[k], value - shift(i), &read[k]);
		read[k] += shift(i);
	}
	move.path = Path::TIP;
	move.length = length_;
	move.tip_from = tip_at(machine_, at_, length_);
	move.tip_to = tip_for(machine_, vec_of(read[0], read[1], read[2]));
	move.to = follow_tip(machine_, wanted, move.tip_to, length_);
	move.cuts = !rapid && turns_;
	push(move);
	line(text + (rapid ? "" : feed()));
}

void Writer::length_off()
{
	if (tip_ || length_ > 0)
		line("G49");
	tip_ = false;
	length_ = 0;
}

void Writer::change_tool()
{
	length_off();
	tool_ = 1 + random_.below((int)machine_.tools.size());
	line("T" + std::to_string(tool_) + " M6");
	turns_ = random_.chance(0.5);
	line(turns_ ? "M3 S1000" : "M5");
	if (random_.chance(0.5) && machine_.axis('Z') >= 0) {
		length_ = machine_.tools[(size_t)tool_ - 1].length;
		line("G43 H" + std::to_string(tool_));
	}
}

void Writer::tip_on()
{
	length_off();
	if (relative_ || inch_)
		line("G90 G21");
	relative_ = inch_ = false;
	line((machine_.dialect == "haas" ? "G234 H" : "G43.4 H") + std::to_string(tool_));
	tip_ = true;
	length_ = machine_.tools[(size_t)tool_ - 1].length;
}

/* One line or a few. */
void Writer::step()
{
	int kind = random_.below(100);
	bool three = machine_.axis('X') >= 0 && machine_.axis('Y') >= 0 && machine_.axis('Z') >= 0;

	if (tip_) {
		if (kind < 8)
			length_off();
		else
			tip();
	} else if (kind < 6 && !machine_.tools.empty()) {
		change_tool();
	} else if (kind < 9) {
		relative_ = !relative_;
		line(relative_ ? "G91" : "G90");
	} else if (kind < 12) {
		inch_ = !inch_;
		line(inch_ ? "G20" : "G21");
	} else if (kind < 15 && machine_.has_setup) {
		offset_ = random_.below((int)machine_.offsets.size());
		line(machine_.offsets[(size_t)offset_].name);
	} else if (kind < 40 && tool_ && tip_can_follow(machine_)) {
		tip_on();
	} else if (kind < 50 && three) {
		arc();
	} else {
		straight();
	}
}

Program Writer::finish()
{
	line("M30");
	return program_;
}

Program generate_program(Random &random, const Machine &machine)
{
	Writer writer(random, machine);
	int steps = 3 + random.below(random.chance(0.2) ? 60 : 16);

	for (int i = 0; i < steps; i++)
		writer.step();
	return writer.finish();
}
