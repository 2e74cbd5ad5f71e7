#include "cli/option_table.h"

#include <stddef.h>

#include "cli/dialect_choice.h"
#include "cli/options.h"
#include "cli/stderr_ui.h"
#include "report/topics.h"

enum {
	IN_CHECK = 1 << RUN_CHECK,
	IN_PARSE = 1 << RUN_PARSE_ONLY,
	IN_DUMP = 1 << RUN_DUMP_PATH,
	IN_PAIRS = 1 << RUN_LIST_PAIRS,
	WITH_PROGRAM = IN_CHECK | IN_PARSE | IN_DUMP,
	ANYWHERE = WITH_PROGRAM | IN_PAIRS | 1 << RUN_CHECK_MACHINE | 1 << RUN_DEPENDS
};

/* Options without a letter. */
enum {
	KEY_METHOD = 256,
	KEY_STEP,
	KEY_TOLERANCE,
	KEY_CLEARANCE,
	KEY_POSE,
	KEY_STOCK_OUT,
	KEY_PARSE_ONLY,
	KEY_DUMP_PATH,
	KEY_LIST_PAIRS,
	KEY_CHECK_MACHINE,
	KEY_DEPENDS,
	KEY_EXPLAIN,
	KEY_DIALECT,
	KEY_DUPLICATES,
	KEY_BLOCK_DELETE,
	KEY_INCLUDE,
	KEY_INPUT_ROOT,
	KEY_MAX_BLOCKS,
	KEY_DEPFILE,
	KEY_FILES_FROM,
	KEY_SHARD,
	KEY_PROGRESS,
	KEY_FAIL_ON,
	KEY_STATS,
	KEY_COLOR,
	KEY_RECORD,
	KEY_WAIVERS,
	KEY_CLEARANCE_REPORT,
	KEY_CLEARANCE_CAP,
	KEY_TIMING,
	KEY_SENSITIVITY,
	KEY_REPORT,
	KEY_REPORT_SIZE,
	KEY_REPORT_CODE,
	KEY_GLB,
	KEY_PICTURE,
	KEY_STOCK_TOLERANCE
};

static const char *const methods[] = {
	[CHECK_CERTIFIED] = "certified", [CHECK_INTERPOLATED] = "interpolated",
	[CHECK_CONVENTIONAL] = "conventional", NULL,
};
static const char *const colors[] = {
	[COLOR_AUTO] = "auto", [COLOR_ALWAYS] = "always", [COLOR_NEVER] = "never", NULL,
};
static const char *const progress[] = {
	[PROGRESS_AUTO] = "auto", [PROGRESS_PLAIN] = "plain", [PROGRESS_NONE] = "none", NULL,
};
/* In the order of enum finding_kind, then FAIL_ON_WARNING and FAIL_ON_NONE. */
static const char *const fail_on_names[] = {
	[FINDING_COLLISION] = "collision", [FINDING_CLEARANCE] = "clearance", [FINDING_LIMIT] = "limit",
	[FINDING_START_OVERLAP] = "start-overlap", [FINDING_RAPID_CONTACT] = "rapid-contact",
	[FINDING_GOUGE] = "gouge", [FAIL_ON_WARNING] = "warning", [FAIL_ON_NONE] = "none", NULL,
};
static const char *const report_code[] = {[REPORT_CODE_FULL] = "full", [REPORT_CODE_NONE] = "none", NULL};
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
     .help = "certified: a proof (the default); interpolated or conventional: sampled, unsafe between samples"},
    {KEY_STEP, "step", "SECONDS", IN_CHECK, NUMBER(check.step, 1e-6, 1000, "s"),
     .help = "time between samples of the sampled methods (0.01)"},
    {KEY_TOLERANCE, "tolerance", "MM", IN_CHECK | IN_DUMP, NUMBER(check.tolerance, 1e-6, 100, "mm"),
     .help = "how exactly contact is decided, and how exactly --dump-path follows curves (0.001)"},
    {KEY_CLEARANCE, "clearance", "MM", IN_CHECK | IN_PAIRS, NUMBER(clearance, 0, 1e5, "mm"),
     .help = "the distance that bodies must keep (0)"},
    {KEY_STOCK_TOLERANCE, "stock-tolerance", "MM", IN_CHECK, NUMBER(check.stock_tolerance, 0.001, 10, "mm"),
     .help = "the tolerance of the remaining stock (0.1)"},
    {'a', "all", NULL, IN_CHECK | IN_PARSE, FLAG(check.all),
     .help = "continue after the first finding; report the first one of each block and pair"},
    {KEY_POSE, "pose", "FILE.stl", IN_CHECK, TEXT(pose),
     .help = "write all bodies in their positions at the first finding"},
    {KEY_STOCK_OUT, "stock-out", "FILE.stl", IN_CHECK, TEXT(stock_out),
     .help = "write the stock that remains after the program"},
    {KEY_REPORT, "report", "FILE.html", IN_CHECK | 1 << RUN_CHECK_MACHINE, TEXT(report),
     .help = "write a report for the browser; for several programs FILE.html is an index; with --check-machine it "
	     "shows what each axis does"},
    {KEY_REPORT_SIZE, "report-size", "MB", IN_CHECK, NUMBER(report_size, 0.1, 1000, "MB"),
     .help = "the largest size of a report (5)"},
    {KEY_REPORT_CODE, "report-code", "full|none", IN_CHECK, CHOICE(report_code, report_code),
     .help = "none: leave the program text out of the report"},
    {KEY_GLB, "glb", "FILE.glb", IN_CHECK, TEXT(glb),
     .help = "write machine and motion before the first finding as glTF"},
    {KEY_PICTURE, "picture", "FILE.svg|.png", IN_CHECK, TEXT(picture), .help = "draw the first finding"},
    {KEY_PARSE_ONLY, "parse-only", NULL, MODE(RUN_PARSE_ONLY),
     .help = "interpret the programs and check axis limits, but not collisions"},
    {KEY_DUMP_PATH, "dump-path", NULL, MODE(RUN_DUMP_PATH), .help = "print the path of the axes, one row per span"},
    {KEY_LIST_PAIRS, "list-pairs", NULL, MODE(RUN_LIST_PAIRS), .help = "print every pair of bodies with its status"},
    {KEY_CHECK_MACHINE, "check-machine", NULL, MODE(RUN_CHECK_MACHINE),
     .help = "print how the machine file was understood, and what is odd in it"},
    {KEY_DEPENDS, "depends", NULL, MODE(RUN_DEPENDS),
     .help = "print the names of the files that a check reads, except subprograms, escaped for make"},
    {KEY_EXPLAIN, "explain", "WORD", 1 << RUN_EXPLAIN, .kind = VALUE_MODE, .mode = RUN_EXPLAIN, FIELD(explain),
     .choices = topic_names, .other_choice = "codes",
     .help = "explain a word of the reports or a code such as G43.4; codes: list all codes"},
    {KEY_DIALECT, "dialect", "NAME", WITH_PROGRAM | 1 << RUN_EXPLAIN, CHOICE(dialect, dialect_choice_names),
     .help = "%s; overrides the machine file; auto: find the dialect from codes that only some controls have"},
    {KEY_DUPLICATES, "duplicates", "error|last", WITH_PROGRAM, CHOICE(duplicates, duplicates),
     .help = "a word that occurs twice in a block is an error (the default), or the last one counts"},
    {KEY_BLOCK_DELETE, "block-delete", NULL, WITH_PROGRAM, FLAG(check.read.block_delete),
     .help = "skip blocks that begin with /"},
    {KEY_INCLUDE, "include", "DIR", WITH_PROGRAM, LIST(includes),
     .help = "look for subprograms in DIR after the folder of the program; may be given several times"},
    {KEY_INPUT_ROOT, "input-root", "DIR", ANYWHERE, TEXT(check.read.input_root),
     .help = "refuse meshes, subprograms and other files that files name, outside DIR"},
    {KEY_MAX_BLOCKS, "max-blocks", "N", WITH_PROGRAM, .kind = VALUE_COUNT, FIELD(check.read.max_blocks), .least = 1,
     .greatest = 2e9, .help = "give up after N blocks in loops and subprograms (100000000)"},
    {KEY_FILES_FROM, "files-from", "FILE", IN_CHECK | IN_PARSE, TEXT(files_from),
     .help = "also check the programs listed in FILE, one per line; - is standard input"},
    {KEY_SHARD, "shard", "K/N", IN_CHECK | IN_PARSE, .kind = VALUE_SHARD, FIELD(shard),
     .help = "check only the K-th of N parts of the programs, or of the blocks of a single program"},
    {KEY_PROGRESS, "progress", "KIND", IN_CHECK | IN_PARSE, CHOICE(progress, progress),
     .help = "auto (the default): one line, renewed, on a terminal; plain: a line every ten seconds; none"},
    {'j', "jobs", "N", ANYWHERE, .kind = VALUE_COUNT, FIELD(check.threads), .least = 1, .greatest = 1024,
     .help = "use N threads (1)"},
    {KEY_WAIVERS, "waivers", "FILE.xml", IN_CHECK | IN_PARSE, TEXT(waivers),
     .help = "accept the findings listed in FILE.xml, each with a reason and a last day (see fivecheck waive)"},
    {KEY_FAIL_ON, "fail-on", "KIND,...", IN_CHECK | IN_PARSE, .kind = VALUE_KINDS, FIELD(fail_on),
     .choices = fail_on_names,
     .help = "findings of these kinds fail the run, others only warn: %s; warning: warnings fail, too; none: nothing "
	     "fails"},
    {'f', "format", "FORMAT[=FILE]", IN_CHECK | IN_PARSE | IN_PAIRS | 1 << RUN_CHECK_MACHINE, .kind = VALUE_FORMAT,
     FIELD(formats), .choices = writer_names,
     .help = "%s (json: --check-machine and --list-pairs only), written to FILE; may be given several times (text)"},
    {'o', "output", "FILE", ANYWHERE, TEXT(output),
     .help = "write the results to FILE, which is replaced when they are complete; - is standard output"},
    {KEY_DEPFILE, "depfile", "FILE", IN_CHECK | IN_PARSE, TEXT(depfile),
     .help = "write a make rule to FILE: the outputs depend on every file that was read"},
    {KEY_RECORD, "record", "FILE.json", IN_CHECK | IN_PARSE, TEXT(record),
     .help = "write to FILE.json what was checked, with digests of all files that were read"},
    {KEY_CLEARANCE_REPORT, "clearance-report", "FILE", IN_CHECK, TEXT(clearance_report),
     .help = "write the proven clearance of each block and pair to FILE (CSV); makes the check slower"},
    {KEY_CLEARANCE_CAP, "clearance-cap", "MM", IN_CHECK, NUMBER(check.block_clearance_cap, 1e-3, 1e5, "mm"),
     .help = "measure clearances only up to this (10)"},
    {KEY_TIMING, "timing", "FILE", IN_CHECK, TEXT(timing),
     .help = "write the time that each block took to FILE (CSV); makes the check slower"},
    {KEY_SENSITIVITY, "sensitivity", "DX,DY,DZ,DL", IN_CHECK, .kind = VALUE_AMOUNTS, FIELD(sensitivity), .least = 0,
     .greatest = 1e4, .unit = "mm",
     .help = "report how far, up to these values, work offsets and tool lengths may be wrong before the verdict "
	     "changes"},
    {'q', "quiet", NULL, ANYWHERE, FLAG(quiet), .help = "print no warnings, notes, statistics and progress"},
    {KEY_STATS, "stats", NULL, IN_CHECK | IN_PARSE, FLAG(stats), .help = "print all statistics instead of one line"},
    {KEY_COLOR, "color", "WHEN", ANYWHERE, CHOICE(color, colors),
     .help = "%s; auto (the default): on a terminal, unless NO_COLOR is set"},
    {'v', "verbose", NULL, IN_CHECK, FLAG(verbose), .help = "also print the smallest proven clearance of each pair"},
    {'V', "version", NULL, MODE(RUN_VERSION), .help = "print the version"},
    {'h', "help", NULL, MODE(RUN_HELP), .help = "print this help"},
};
