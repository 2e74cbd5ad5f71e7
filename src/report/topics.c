#include "report/topics.h"

#include <string.h>

const char *const topic_names[TOPIC_COUNT + 1] = {
	[FINDING_COLLISION] = "collision",
	[FINDING_CLEARANCE] = "clearance",
	[FINDING_LIMIT] = "limit",
	[FINDING_START_OVERLAP] = "start-overlap",
	[FINDING_RAPID_CONTACT] = "rapid-contact",
	[FINDING_GOUGE] = "gouge",
	[TOPIC_INCOMPLETE] = "incomplete",
	[TOPIC_CAUTION] = "caution",
	[TOPIC_CLEAR] = "clear",
	[TOPIC_PASSED] = "passed",
	[TOPIC_FOUND] = "found",
	[TOPIC_ACCEPTED] = "accepted",
	[TOPIC_CAUTIONS + CAUTION_SAMPLED] = "sampled",
	[TOPIC_CAUTIONS + CAUTION_NO_PAIRS] = "no-pairs",
	[TOPIC_CAUTIONS + CAUTION_NO_SETUP] = "no-setup",
	[TOPIC_CAUTIONS + CAUTION_EXCUSED] = "excused-neighbours",
	[TOPIC_CAUTIONS + CAUTION_WAIVED] = "waived-pairs",
	[TOPIC_CAUTIONS + CAUTION_SURFACES] = "open-mesh",
	[TOPIC_CAUTIONS + CAUTION_MESH_CUTTER] = "mesh-cutter",
	[TOPIC_CAUTIONS + CAUTION_NO_PATH_TOLERANCE] = "no-path-tolerance",
	[TOPIC_CAUTIONS + CAUTION_STRAIGHT_RAPIDS] = "straight-rapids",
	[TOPIC_CAUTIONS + CAUTION_FAR_CUTTER] = "far-cutter",
	[TOPIC_CAUTIONS + CAUTION_ACCEPTED] = "accepted-findings",
	[TOPIC_CAUTIONS + CAUTION_SHARD] = "shard",
	[TOPIC_CAUTIONS + CAUTION_WARNINGS] = "warnings",
	[TOPIC_CAUTIONS + CAUTION_DOUBT] = "model-doubt",
	[TOPIC_PAIRS + PAIR_CHECKED] = "checked",
	[TOPIC_PAIRS + PAIR_RIGID] = "rigid",
	[TOPIC_PAIRS + PAIR_ADJACENT] = "adjacent",
	[TOPIC_PAIRS + PAIR_OUT_OF_REACH] = "out of reach",
	[TOPIC_PAIRS + PAIR_WAIVED] = "waived",
	[TOPIC_PAIRS + PAIR_CUTTING] = "cutting",
};

const struct topic topics[TOPIC_COUNT] = {
    [FINDING_COLLISION] =
	{"Collision", "Two bodies of the machine meet.",
	 "Two bodies touch or enter each other during the block. The finding names the first instant of contact, exact "
	 "to --tolerance.",
	 "Look at the positions of the axes and at the point of contact (--pose writes all bodies in their positions "
	 "there). Then change the program, the tool, or the setup."},
    [FINDING_CLEARANCE] =
	{"Clearance", "Two bodies come closer than the required clearance.",
	 "During the block, two bodies come closer than --clearance or the machine file's <pair clearance> allows. If "
	 "a clearance is required, bodies that collide are also reported with this kind.",
	 "Change the program or the setup, or require less clearance for this pair."},
    [FINDING_LIMIT] =
	{"AxisLimit", "An axis leaves its travel.",
	 "The block moves an axis past limit_min or limit_max of the machine file. The control would stop with an "
	 "alarm, or refuse the program. Some motions are known only as a set of paths: the overrun of G60, "
	 "compensation whose form is not given, a probe. For them the finding says that the axis may leave its "
	 "travel, and by how much.",
	 "Move the part on the table, choose another solution of the rotary axes, or change the program. The report "
	 "names the work offset and the tool length that led to this position."},
    [FINDING_START_OVERLAP] =
	{"StartOverlap", "Two bodies overlap before the block moves.",
	 "The bodies overlap at the start of the program, or where a tool change puts a new body. A proof cannot begin "
	 "with bodies that are already inside each other.",
	 "Check the home positions and the setup. If only the models overlap there, and not the real bodies, <pair "
	 "check=\"never\" reason=\"...\"/> in the machine file waives the pair."},
    [FINDING_RAPID_CONTACT] =
	{"RapidContact", "A cutter that does not cut enters the part or the stock.",
	 "At rapid, or with a stopped spindle, a cutter, or a probe that does not measure (G31, G38.2), enters the "
	 "finished part or the remaining stock deeper than rapid_allowance of <part> or <stock> allows (0.1 and "
	 "0.25 mm by default). That breaks the tool.",
	 "Feed into the part with M3 or M4 active, retract before the rapid, and look for a missing G43. For a probe "
	 "or a nozzle give <tool kind> in the setup."},
    [FINDING_GOUGE] =
	{"Gouge", "A cutter cuts into the finished part.",
	 "At feed a cutter enters the finished part deeper than <part gouge> allows. The part would be scrap.",
	 "Compare the program with the model of the part: stock to leave, tool, length and radius compensation, work "
	 "offset."},
    [TOPIC_INCOMPLETE] =
	{"Incomplete", "Not everything could be checked.",
	 "Something could not be read, interpreted, or decided, so nothing is proved from that place on. Such a check "
	 "is never clear, and its exit status is 2.",
	 "The message names the cause and what to write instead."},
    [TOPIC_CAUTION] =
	{"Caution", "The verdict holds under a condition.",
	 "A caution names something that was not checked, was assumed, or is doubtful.",
	 "Read each caution before you run the program. The cautions have these names: sampled, no-pairs, no-setup, "
	 "excused-neighbours, waived-pairs, open-mesh, mesh-cutter, no-path-tolerance, straight-rapids, far-cutter, "
	 "accepted-findings, shard, warnings and model-doubt."},
    [TOPIC_CLEAR] =
	{NULL, "Every pair of bodies is proved apart.",
	 "At every instant of every block every required pair of bodies keeps more than its clearance, and every axis "
	 "stays in its travel. The proof covers the programmed path and the bodies as drawn.",
	 "Read the cautions beside the verdict: they name what the proof assumes."},
    [TOPIC_PASSED] =
	{NULL, "Nothing was found, but no proof was asked for.",
	 "A sampled method, --parse-only, or one shard of a program found nothing. None of them alone proves that "
	 "the program is clear.",
	 "Run the certified check of the whole program, or join all shards with fivecheck merge."},
    [TOPIC_FOUND] = {NULL, "At least one finding fails the run.",
		     "At least one block of the program violates a requirement. The exit status is 1.",
		     "Look at the first finding. With --all the check continues and lists the others."},
    [TOPIC_ACCEPTED] =
	{NULL, "There are findings, and all of them are accepted.",
	 "Each finding is named by --waivers or is of a kind that --fail-on leaves out. The exit status is 0, but the "
	 "program is not clear.",
	 "Read the reasons of the waivers, and the caution accepted-findings."},
    [TOPIC_CAUTIONS + CAUTION_SAMPLED] =
	{NULL, "The bodies were checked in samples only.",
	 "The methods interpolated and conventional look at the bodies every --step seconds. Between two samples, "
	 "contact may come earlier than the finding, or be missed.",
	 "Use --method=certified, the default."},
    [TOPIC_CAUTIONS + CAUTION_NO_PAIRS] =
	{NULL, "No pair of bodies had to be checked.",
	 "Every pair is rigid, excused, waived, or out of reach, so the verdict is only about axis limits.",
	 "--list-pairs gives the reason for each pair. Often a setup or a mesh is missing."},
    [TOPIC_CAUTIONS +
	CAUTION_NO_SETUP] = {NULL, "No setup was given.",
			     "Only the bodies of the machine itself were checked: no tool, no fixture and no part.",
			     "Give the setup of the job with -s setup.xml."},
    [TOPIC_CAUTIONS + CAUTION_EXCUSED] =
	{NULL, "Neighbours in the machine's structure are excused.",
	 "One axis connects these bodies, and they are drawn close together, like a slide and its guideway. They touch "
	 "by design and are not proved apart.",
	 "Look at the rows with the status adjacent in --list-pairs. To check such a pair, write <pair "
	 "check=\"always\"/> in the machine file."},
    [TOPIC_CAUTIONS +
	CAUTION_WAIVED] = {NULL, "The machine file waives pairs of bodies.",
			   "Pairs with <pair check=\"never\"/> are not checked, whatever the program does.",
			   "Look at the rows with the status waived in --list-pairs and at their reasons."},
    [TOPIC_CAUTIONS + CAUTION_SURFACES] =
	{NULL, "A body with an open mesh is checked as a surface.",
	 "A mesh with gaps has no defined inside. Contact of the surfaces is always found. But a body that is wholly "
	 "inside another one, or enters it through a gap, may be missed.",
	 "Close the mesh. --check-machine names the gaps."},
    [TOPIC_CAUTIONS + CAUTION_MESH_CUTTER] =
	{NULL, "A cutter that is a mesh is not checked against the part at rapid.",
	 "fivecheck cannot tell how deep such a cutter enters the part, so it does not find a rapid of this cutter "
	 "through the part. It checks this cutter against everything else.",
	 "Describe the cutter by sections in the setup."},
    [TOPIC_CAUTIONS + CAUTION_NO_PATH_TOLERANCE] =
	{NULL, "The control may leave the programmed path by an unknown distance.",
	 "G64 and similar codes blend corners. Without a tolerance only the programmed path was checked.",
	 "Give the tolerance in the program (G64 P) or in the machine file (<controller path_tolerance>), or use "
	 "exact stops."},
    [TOPIC_CAUTIONS + CAUTION_STRAIGHT_RAPIDS] =
	{NULL, "Rapids were checked as straight lines, but the control may move them in another way.",
	 "On many controls a parameter decides: each axis may move at its own rate, so that the tool leaves the "
	 "straight line by far.",
	 "Give <controller rapid> in the machine file: linear, dogleg, or any if it is not known."},
    [TOPIC_CAUTIONS + CAUTION_FAR_CUTTER] =
	{NULL, "A cutter feeds, but never comes near the part.",
	 "During the whole program the cutter, while it turns and feeds, stays farther from the convex hull of the "
	 "part than 5 mm and its radius, or, if the setup has a <stock>, farther than 1 mm from part and blank. Often "
	 "a work offset, a tool length or the location of the part is wrong; then the proof is about another place "
	 "than the one where the tool will cut. This caution is given only if the program was checked to its end.",
	 "Look at the named line, where the cutter is nearest. Check the active work offset, H, the tool length and "
	 "the location of the part. If all are right, checked=\"reason\" on <tool> or <part> removes this caution."},
    [TOPIC_CAUTIONS + CAUTION_ACCEPTED] =
	{NULL, "The rest of a block after an accepted finding is not checked.",
	 "After a finding that --waivers or --fail-on accepts, the same bodies or axis are not checked in the rest of "
	 "that block.",
	 "Remove the cause of the finding, or check the rest of the block by other means."},
    [TOPIC_CAUTIONS + CAUTION_SHARD] =
	{NULL, "Only a part of the program's blocks was checked.",
	 "With --shard K/N a run checks its own share. The program is clear if no shard has a finding and none is "
	 "missing.",
	 "Join the results of all shards with fivecheck merge."},
    [TOPIC_CAUTIONS + CAUTION_WARNINGS] =
	{NULL, "There were warnings during the check.",
	 "fivecheck understood something in the program in one way, but another way is possible. The caution repeats "
	 "the first warning.",
	 "Read the warnings on standard error. --fail-on=warning makes them fail the run."},
    [TOPIC_CAUTIONS + CAUTION_DOUBT] =
	{NULL, "Something in the machine file or in the setup is odd.",
	 "Signs of axes, units, positions, offsets or lengths do not fit together. If one of them is wrong, the proof "
	 "is about another machine than yours.",
	 "Verify the value that the caution names, at the machine if possible. If it is right, checked=\"reason\" "
	 "on its element removes the doubt. fivecheck-machine(5) lists all doubts."},
    [TOPIC_PAIRS + PAIR_CHECKED] =
	{NULL, "The two bodies are kept apart in every block, or a finding names the block.",
	 "They can meet within the travel of the axes, or the machine file requires the check. If a clearance is "
	 "required, they keep more than that.",
	 "The reason beside the status says why the pair is checked."},
    [TOPIC_PAIRS + PAIR_RIGID] =
	{NULL, "There is no axis between the two bodies.",
	 "They never move relative to each other, so no program can make them meet.",
	 "If they do move on the real machine, put one of them into the <axis> that carries it."},
    [TOPIC_PAIRS + PAIR_ADJACENT] =
	{NULL, "The two bodies are neighbours that are drawn close together.",
	 "One axis connects them, like a slide and its guide, and they touch by design. They are excused, not proved "
	 "apart.",
	 "To check them, write <pair check=\"always\"/> in the machine file."},
    [TOPIC_PAIRS + PAIR_OUT_OF_REACH] =
	{NULL, "The two bodies are proved apart over the whole travel of the axes.",
	 "They cannot meet at any position within the limits of the axes between them, so no block needs a check.",
	 "The proof uses limit_min and limit_max of the machine file: they must be those of the real machine."},
    [TOPIC_PAIRS + PAIR_WAIVED] =
	{NULL, "The machine file leaves the pair out.",
	 "<pair check=\"never\"/> names the two bodies or their links. The pair is not checked at all.",
	 "Read the reason beside the status, and decide whether it still holds."},
    [TOPIC_PAIRS + PAIR_CUTTING] =
	{NULL, "A cutter with the part or the stock that it cuts.",
	 "Contact of the two is no finding while the cutter turns and feeds. At rapid, or with a stopped spindle, "
	 "it is a rapid-contact.",
	 "The attribute gouge of <part> limits how deep the cutter may go; <pair check=\"always\"/> forbids any "
	 "contact."},
};

enum { COLUMNS = 80 };

/* Appends the words of a text, divided into lines. */
static void add_paragraph(struct strbuf *out, const char *text)
{
	size_t column = 0;

	while (*text) {
		size_t length = strcspn(text, " ");

		if (column && column + 1 + length > COLUMNS) {
			strbuf_addf(out, "\n");
			column = 0;
		}
		strbuf_addf(out, "%s%.*s", column ? " " : "", (int)length, text);
		column += (column ? 1 : 0) + length;
		text += length;
		text += strspn(text, " ");
	}
	strbuf_addf(out, "\n");
}

static const char *sort_of(int topic)
{
	if (topic < FINDING_KINDS)
		return "a kind of finding";
	if (topic >= TOPIC_PAIRS)
		return "a status of --list-pairs";
	return topic == TOPIC_CAUTION || topic >= TOPIC_CAUTIONS ? "stands beside a verdict" : "a verdict";
}

bool topics_explain(struct strbuf *out, const char *name)
{
	for (int i = 0; i < TOPIC_COUNT; i++) {
		if (strcmp(topic_names[i], name) != 0)
			continue;
		strbuf_addf(out, "%s (%s)\n\n", name, sort_of(i));
		add_paragraph(out, topics[i].brief);
		add_paragraph(out, topics[i].meaning);
		strbuf_addf(out, "\n");
		add_paragraph(out, topics[i].advice);
		return true;
	}
	return false;
}
