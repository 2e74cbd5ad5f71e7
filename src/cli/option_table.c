#include "cli/option_table.h"

#include <stddef.h>

#include "cli/options.h"
#include "cli/stderr_ui.h"
#include "control/dialects.h"

enum {
	IN_CHECK = 1 << RUN_CHECK,
	IN_PARSE = 1 << RUN_PARSE_ONLY,
	IN_DUMP = 1 << RUN_DUMP_PATH,
	IN_PAIRS = 1 << RUN_LIST_PAIRS,
	WITH_PROGRAM = IN_CHECK | IN_PARSE | IN_DUMP,
	ANYWHERE = WITH_PROGRAM | IN_PAIRS | 1 << RUN_CHECK_MACHINE
};

/* Options without a letter. */
enum {
	KEY_METHOD = 256, KEY_STEP, KEY_TOLERANCE, KEY_CLEARANCE, KEY_POSE, KEY_PARSE_ONLY, KEY_DUMP_PATH,
	KEY_LIST_PAIRS, KEY_CHECK_MACHINE, KEY_DIALECT, KEY_DUPLICATES, KEY_BLOCK_DELETE, KEY_INCLUDE, KEY_INPUT_ROOT,
	KEY_MAX_BLOCKS, KEY_DEPFILE, KEY_FILES_FROM,
	KEY_SHARD, KEY_PROGRESS, KEY_BASELINE, KEY_FAIL_ON, KEY_EXIT_ZERO,
	KEY_RECORD, KEY_WAIVERS, KEY_CLEARANCE_REPORT, KEY_CLEARANCE_CAP, KEY_TIMING, KEY_SENSITIVITY
};

static const char *const methods[] = {
	[CHECK_CERTIFIED] = "certified", [CHECK_INTERPOLATED] = "interpolated",
	[CHECK_CONVENTIONAL] = "conventional", NULL,
};
static const char *const progress[] = {
	[PROGRESS_AUTO] = "auto", [PROGRESS_PLAIN] = "plain", [PROGRESS_NONE] = "none", NULL,
};
static const char *const duplicates[] = {"error", "last", NULL};

#define FIELD(member) .field = offsetof(struct options, member)
#define FLAG(member) .kind = VALUE_FLAG, FIELD(member)
#define TEXT(member) .kind = VALUE_TEXT, FIELD(member)
#define LIST(member) .kind = VALUE_LIST, FIELD(member)
#define NUMBER(member, from, to, of) \
	.kind = VALUE_NUMBER, FIELD(member), .least = (from), .greatest = (to), .unit = (of)
#define CHOICE(member, names) .kind = VALUE_CHOICE, FIELD(member), .choices = (names)
#define MODE(which) .modes = ANYWHERE, .kind = VALUE_MODE, .mode = (which)

const struct option_row option_table[OPTION_COUNT] = {
	{'s', "setup", "FILE", ANYWHERE, TEXT(setup), .help = "the job's work offsets, fixtures, part and tools"},
	{KEY_METHOD, "method", "METHOD", IN_CHECK, CHOICE(check.method, methods),
	 .help = "certified: a proof (the default); interpolated or\nconventional: sampled, unsafe between the samples"},
	{KEY_STEP, "step", "SECONDS", IN_CHECK, NUMBER(check.step, 1e-6, 1000, "s"),
	 .help = "time between samples of the sampled methods (0.01)"},
	{KEY_TOLERANCE, "tolerance", "MM", IN_CHECK | IN_DUMP, NUMBER(check.tolerance, 1e-6, 100, "mm"),
	 .help = "how exactly contact is decided, or --dump-path\nflattens curves (0.001)"},
	{KEY_CLEARANCE, "clearance", "MM", IN_CHECK | IN_PAIRS, NUMBER(clearance, 0, 1e5, "mm"),
	 .help = "the distance that bodies must keep (0)"},
	{'a', "all", NULL, IN_CHECK | IN_PARSE, FLAG(check.all),
	 .help = "go on after the first finding: the first of each\nblock and pair"},
	{KEY_POSE, "pose", "FILE.stl", IN_CHECK, TEXT(pose),
	 .help = "write all bodies as they stand at the first finding"},
	{KEY_PARSE_ONLY, "parse-only", NULL, MODE(RUN_PARSE_ONLY),
	 .help = "interpret everything and check the axis limits,\nbut no collision"},
	{KEY_DUMP_PATH, "dump-path", NULL, MODE(RUN_DUMP_PATH), .help = "print the path of the axes, one span a row"},
	{KEY_LIST_PAIRS, "list-pairs", NULL, MODE(RUN_LIST_PAIRS),
	 .help = "print every pair of bodies and whether it is checked"},
	{KEY_CHECK_MACHINE, "check-machine", NULL, MODE(RUN_CHECK_MACHINE),
	 .help = "print the machine as it was understood, and what is\nodd about it"},
	{KEY_DIALECT, "dialect", "NAME", WITH_PROGRAM, CHOICE(dialect, dialect_names),
	 .help = "%s, instead of the machine's"},
	{KEY_DUPLICATES, "duplicates", "error|last", WITH_PROGRAM, CHOICE(duplicates, duplicates),
	 .help = "a word that stands twice in a block is an error\n(the default), or the last one counts"},
	{KEY_BLOCK_DELETE, "block-delete", NULL, WITH_PROGRAM, FLAG(check.read.block_delete),
	 .help = "skip the blocks that begin with /"},
	{KEY_INCLUDE, "include", "DIR", WITH_PROGRAM, LIST(includes),
	 .help = "look for subprograms in DIR, too, after the program's\nown folder; may be given again"},
	{KEY_INPUT_ROOT, "input-root", "DIR", ANYWHERE, TEXT(check.read.input_root),
	 .help = "meshes and subprograms outside of DIR are an error"},
	{KEY_MAX_BLOCKS, "max-blocks", "N", WITH_PROGRAM, .kind = VALUE_COUNT, FIELD(check.read.max_blocks), .least = 1,
	 .greatest = 2e9, .help = "stop after N blocks in loops and subprograms\n(100000000)"},
	{KEY_FILES_FROM, "files-from", "FILE", IN_CHECK | IN_PARSE, TEXT(files_from),
	 .help = "check the programs that FILE names, too, one a line;\n- is standard input"},
	{KEY_SHARD, "shard", "K/N", IN_CHECK | IN_PARSE, .kind = VALUE_SHARD, FIELD(shard),
	 .help = "check the K-th of N parts of the programs only, or\nof the blocks of a single one"},
	{KEY_PROGRESS, "progress", "KIND", IN_CHECK | IN_PARSE, CHOICE(progress, progress),
	 .help = "auto: a line that is renewed on a terminal (the\ndefault); plain: a line now and then; none"},
	{'j', "jobs", "N", ANYWHERE, .kind = VALUE_COUNT, FIELD(check.threads), .least = 1, .greatest = 1024,
	 .help = "use N threads (1)"},
	{KEY_BASELINE, "baseline", "FILE", IN_CHECK | IN_PARSE, TEXT(baseline),
	 .help = "accept the findings of an earlier run, which wrote\nthem with --all --format=ndjson=FILE"},
	{KEY_WAIVERS, "waivers", "FILE.xml", IN_CHECK | IN_PARSE, TEXT(waivers),
	 .help = "accept the findings that FILE.xml names, each with its\nreason and until its last day"},
	{KEY_FAIL_ON, "fail-on", "KIND,...", IN_CHECK | IN_PARSE, .kind = VALUE_KINDS, FIELD(fail_on), .choices = finding_kind_names,
	 .help = "findings of these kinds fail, others are warnings:\n%s"},
	{KEY_EXIT_ZERO, "exit-zero", NULL, IN_CHECK | IN_PARSE, FLAG(exit_zero),
	 .help = "exit with 0 where something was found, too"},
	{'f', "format", "FORMAT[=FILE]", IN_CHECK | IN_PARSE, .kind = VALUE_FORMAT, FIELD(formats),
	 .choices = writer_names,
	 .help = "%s (text),\ninto FILE; may be given again for another format"},
	{'o', "output", "FILE", ANYWHERE, TEXT(output),
	 .help = "write the results to FILE, replaced when complete;\n- is standard output"},
	{KEY_DEPFILE, "depfile", "FILE", IN_CHECK | IN_PARSE, TEXT(depfile),
	 .help = "write a make rule into FILE: the files written here\ndepend on every file that was read"},
	{KEY_RECORD, "record", "FILE.json", IN_CHECK | IN_PARSE, TEXT(record),
	 .help = "write what was checked into FILE.json, with digests\nof all that was read"},
	{KEY_CLEARANCE_REPORT, "clearance-report", "FILE", IN_CHECK, TEXT(clearance_report),
	 .help = "write the proven clearance of each block and pair\ninto FILE (CSV), which takes more time"},
	{KEY_CLEARANCE_CAP, "clearance-cap", "MM", IN_CHECK, NUMBER(check.block_clearance_cap, 1e-3, 1e5, "mm"),
	 .help = "measure no more than this (10)"},
	{KEY_TIMING, "timing", "FILE", IN_CHECK, TEXT(timing),
	 .help = "write the time that each block took into FILE\n(CSV), which takes more of it"},
	{KEY_SENSITIVITY, "sensitivity", "DX,DY,DZ,DL", IN_CHECK, .kind = VALUE_AMOUNTS, FIELD(sensitivity), .least = 0,
	 .greatest = 1e4, .unit = "mm",
	 .help = "by how many mm, up to these, the work offsets or tool\nlengths may be off before the verdict turns"},
	{'q', "quiet", NULL, ANYWHERE, FLAG(quiet), .help = "no warnings, notes and statistics"},
	{'v', "verbose", NULL, IN_CHECK, FLAG(verbose),
	 .help = "the smallest proven clearance of each pair as well"},
	{'V', "version", NULL, MODE(RUN_VERSION), .help = "print the version"},
	{'h', "help", NULL, MODE(RUN_HELP), .help = "print this help"},
};
