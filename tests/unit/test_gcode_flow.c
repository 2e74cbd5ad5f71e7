/* test_gcode_flow.c - LinuxCNC's control flow: branches, loops, subprograms, their files, pipes, and their limits. */
#include "gcode_case.h"

#include <sys/wait.h>
#include <unistd.h>

/* The X of every move, in turn. */
static const struct {
	const char *program, *ways;
} programs[] = {
	{"o1 if [#1 EQ 0]\nG0 X1\no1 else\nG0 X2\no1 endif\nG0 X3\n", "1 3"},
	{"o1 if [0]\nG0 X1\no1 elseif [1]\nG0 X2\no1 elseif [1]\nG0 X3\no1 else\nG0 X4\no1 endif\n", "2"},
	{"o1 if [0]\nG0 X1\no1 elseif [0]\nG0 X2\no1 else\nG0 X4\no1 endif\n", "4"},
	{"o1 if [1]\no2 if [0]\nG0 X1\no2 else\nG0 X2\no2 endif\nG0 X3\no1 else\nG0 X9\no1 endif\n", "2 3"},
	{"o1 if [0]\nno block at all\no1 endif\nG0 X1\n", "1"},
	{"o1 while [#1 LT 3]\n#1=[#1+1]\nG0 X#1\no1 endwhile\no2 while [0]\nG0 X9\no2 endwhile\n", "1 2 3"},
	{"o1 do\n#1=[#1+1]\nG0 X#1\no1 while [#1 LT 3]\nG0 X7\n", "1 2 3 7"},
	{"o1 do\nG0 X1\no1 while [0]\n", "1"},
	/* halves to even: 2 and 4 times */
	{"G91\no1 repeat [2.5]\nG0 X1\no1 endrepeat\no2 repeat [3.5]\nG0 X10\no2 endrepeat\n", "1 2 12 22 32 42"},
	{"G91\no1 repeat [2]\no2 repeat [2]\nG0 X1\no2 endrepeat\nG0 X10\no1 endrepeat\n", "1 2 12 13 14 24"},
	{"o1 repeat [0]\nG0 X1\no1 endrepeat\no2 repeat [-3]\nG0 X1\no2 endrepeat\nG0 X2\n", "2"},
	{"o1 while [1]\n#1=[#1+1]\no2 if [#1 EQ 3]\no1 break\no2 endif\nG0 X#1\no1 endwhile\nG0 X9\n", "1 2 9"},
	{"o1 while [#1 LT 4]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 X#1\no1 endwhile\n", "1 3 4"},
	{"o1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 break\no2 endif\nG0 X#1\no1 while [1]\nG0 X9\n", "1 9"},
	{"o1 while [1]\no2 while [1]\n#1=[#1+1]\nG0 X#1\no3 if [#1 EQ 2]\no1 break\no3 endif\no2 endwhile\no1 "
	 "endwhile\n",
	 "1 2"},
	/* labels */
	{"O<My Loop> repeat [2]\nG91 G0 X1\no < my loop > endrepeat\n", "1 2"},
	{"#1=7\no[#1+1] if [1]\nG0 X1\nN10 o 8 endif (done)\n", "1"},
	/* subprograms */
	{"o1 sub\nG0 X#1\n#1=9\no1 endsub\n#1=5\no1 call [2]\nG0 X#1\n", "2 5"},
	{"o1 sub\no2 if [#1 GT 0]\no1 return [#1*2]\no2 endif\no1 endsub\no1 call [4]\nG0 X#<_value>\n"
	 "G0 X#<_value_returned>\no1 call [-4]\nG0 X[#<_value_returned>+3]\n",
	 "8 1 3"},
	{"o1 sub\n#<mine>=[#1*2]\nG0 X#<mine>\no1 endsub\n#<mine>=3\no1 call [4]\nG0 X#<mine>\n", "8 3"},
	{"o1 sub\nG0 X#1\no2 if [#1 GT 1]\no1 call [#1-1]\no2 endif\no1 endsub\no1 call [3]\n", "3 2 1"},
	{"o1 sub\no5 repeat [2]\nG91 G0 X1\no5 endrepeat\no1 endsub\no5 if [1]\no1 call\no5 endif\no1 "
	 "call\n", "1 2 3 4"},
	{"o1 call [4]\nG0 X1\nM2\no1 sub\nG0 X#1\no1 endsub\n", "4 1"},
	{"o1 sub\nG0 X1\nM2\no1 endsub\no1 call\nG0 X9\n", "1"},
	{"#1=6\nM98 P100 L2\nG0 X#1\nM2\nO100 (Fanuc)\nG91 G0 X1\nG90\n#1=9\nM99\n", "1 2 9"},
	{"M98 P100\nM2\nO100\nG0 X1\nM98 P200\nM99\nO200\nG0 X2\nM99\n", "1 2"},
	/* M99 of the main program: a pass that changes nothing is the last one. */
	{"G0 X1\nG0 X2\nM99\n", "1 2 1 2"},
	{"%\nG0 X1\nG0 X2\nM99\n%\n", "1 2 1 2"},
	{"\n\n%\n#1=[#1+1]\no1 if [#1 EQ 3]\nM2\no1 endif\nG0 X#1\nM99\n%\n", "1 2"},
	{"#1=[#1+1]\no1 if [#1 EQ 3]\nM2\no1 endif\nG0 X#1\nM99\n", "1 2"},
};

static void add_way(struct strbuf *ways, const char *moves)
{
	for (const char *at = moves; *at; at = strchr(at, '\n') + 1)
		strbuf_addf(ways, "%s%.*s", ways->length ? " " : "", (int)strcspn(at + 6, " "), at + 6);
}

START_TEST(ways)
{
	for (size_t i = 0; i < COUNT(programs); i++) {
		struct strbuf found = {0};
		struct gcode_case c;

		case_init(&c);
		ck_assert_msg(case_run(&c, programs[i].program), "%s: %s", programs[i].program,
			      strbuf_text(&c.messages));
		add_way(&found, strbuf_text(&c.moves));
		ck_assert_msg(!strcmp(strbuf_text(&found), programs[i].ways), "%s goes %s", programs[i].program,
			      strbuf_text(&found));
		strbuf_release(&found);
		case_release(&c);
	}
}
END_TEST

/* Programs and all that is said of them. */
static const struct {
	const char *program, *messages;
} faults[] = {
	{"o1 endif\n", "p.nc:1:1: error: o1 endif without if\n    o1 endif\n    ^\n"},
	{"o<x> else\n", "p.nc:1:1: error: o<x> else without if\n    o<x> else\n    ^\n"},
	{"o1 endwhile\n", "p.nc:1:1: error: o1 endwhile without while\n    o1 endwhile\n    ^\n"},
	{"o1 repeat [2]\no1 break\n",
	 "p.nc:2:1: error: o1 break without while or do\n    o1 break\n    ^\n"},
	{"o1 if [1]\no2 while [1]\no1 endif\n",
	 "p.nc:3:1: error: o1 endif inside the while of line 2, which is not closed\n    o1 endif\n    ^\n"},
	{"o1 if [1]\no1 endif\no1 while [1]\n",
	 "p.nc:3:1: error: the label o1 is already used for another if in line 1 of p.nc\n    o1 while [1]\n    ^\n"},
	{"o1 if [0]\no1 while [1]\n",
	 "p.nc:2:1: error: the label o1 is already used for the if of line 1, which is not closed\n    o1 while [1]\n  "
	 "  ^\n"},
	{"o1 if #1\n", "p.nc:1:7: error: if needs a value in brackets, [...]\n    o1 if #1\n          ^\n"},
	{"o1 if [1] G0\n",
	 "p.nc:1:11: error: only a comment can follow the o-word if\n    o1 if [1] G0\n              ^\n"},
	{"o1 unless\n",
	 "p.nc:1:4: error: an o-word must be followed by sub, endsub, call, return, if, elseif, else, endif, while, "
	 "endwhile, do, repeat, endrepeat, break or continue\n    o1 unless\n       ^\n"},
	{"G0 X1\no1 if [0]\n", "p.nc:2:1: error: this if is not closed\n"},
	{"o1 while [#1 LT 1]\n#1=1\n", "p.nc:2: error: the while in line 1 is not closed\n"},
	{"o1 sub\nG0 X1\n", "p.nc:1:1: error: this sub is not closed: endsub is missing\n"},
	{"o1 endsub\n", "p.nc:1:1: error: o1 endsub outside of a sub\n    o1 endsub\n    ^\n"},
	{"o1 sub\no2 sub\n",
	 "p.nc:2:1: error: a subprogram inside the sub of line 1; close that sub first\n    o2 sub\n    ^\n"},
	{"o1 sub\no1 endsub\no1 sub\n",
	 "p.nc:3:1: error: o1 is already defined in line 1 of p.nc\n    o1 sub\n    ^\n"},
	{"o1 call\no1 sub\no1 endsub\n",
	 "p.nc:2:1: error: o1 sub is reached again after its call, or in a loop, where LinuxCNC stops; define it once, "
	 "before its first call\n    o1 sub\n    ^\n"},
	{"o<none> call\n",
	 "p.nc:1:1: error: the subprogram o<none> is neither in p.nc nor in a file none.ngc beside the program "
	 "or in an "
	 "--include folder\n"},
	{"o<../a> call\n",
	 "p.nc:1:1: error: the name of a subprogram's file must not contain a folder: '../a'\n    o<../a> call\n"
	 "    ^\n"},
	{"o</etc/a> call\n",
	 "p.nc:1:1: error: the name of a subprogram's file must not contain a folder: '/etc/a'\n    o</etc/a> call\n"
	 "    ^\n"},
	{"G0 X1 M98 P1\n", "p.nc:1:7: error: M98 must be at the start of its block\n    G0 X1 M98 P1\n          ^\n"},
	{"M98 P1 X2\n",
	 "p.nc:1:8: error: M98 takes only P and L, once each\n    M98 P1 X2\n           ^\n"},
	{"M98 L2\n", "p.nc:1:1: error: M98 needs P (subprogram number)\n    M98 L2\n    ^\n"},
	{"M98 P1 L0\n",
	 "p.nc:1:1: error: M98 with L0: LinuxCNC would continue as if it were inside the subprogram\n    M98 P1 L0\n   "
	 " ^\n"},
	{"o1 sub\no1 endsub\nM98 P1\n",
	 "p.nc:3:1: error: o1 is a sub for call, not for M98\n    M98 P1\n    ^\n"},
	{"o1 sub\nG0 X1 M99\no1 endsub\no1 call\n",
	 "p.nc:2:7: error: M99 in a subprogram needs a block of its own\n    G0 X1 M99\n          ^\n"
	 "p.nc:4:1: note: o1 is called from here\n"},
	{"o1 sub\nG0 X[1/#1]\no1 endsub\no2 sub\n o1 call [#1]\no2 endsub\no2 call [0]\n",
	 "p.nc:2:7: error: division by zero\n    G0 X[1/#1]\n          ^\n"
	 "p.nc:5:2: note: o1 is called from here\np.nc:7:1: note: o2 is called from here\n"},
	/* Faults of LinuxCNC itself, which would carry out something other than what is written. */
	{"o1 while [1]\no1 break\no1 endwhile\no2 do\n#1=[#1+1]\no2 while [#1 LT 3]\n",
	 "p.nc:6:1: error: in LinuxCNC, an earlier o-word break still has an effect, which would end the loop here; "
	 "write the loops without break\n    o2 while [#1 LT 3]\n    ^\n"},
	{"o1 do\n#1=[#1+1]\no2 if [#1 EQ 1]\no1 continue\no2 endif\no1 while [#1 LT 2]\no3 repeat [1]\no3 endrepeat\n",
	 "p.nc:8:1: error: in LinuxCNC, an earlier o-word continue still has an effect, which would repeat the loop "
	 "again here; write the loops without continue\n    o3 endrepeat\n    ^\n"},
	{"o1 sub\no2 repeat [5]\no1 return\no2 endrepeat\no1 endsub\no1 call\no1 call\n",
	 "p.nc:2:1: error: this repeat was left by return or still runs in a caller: LinuxCNC would continue its old "
	 "count\n    o2 repeat [5]\n    ^\np.nc:7:1: note: o1 is called from here\n"},
	{"o1 sub\no1 endsub [3]\nG0 X#<_value>\n",
	 "p.nc:3:5: error: #<_value> directly after a sub whose endsub has a value: LinuxCNC evaluates that value even "
	 "without a call\n    G0 X#<_value>\n        ^\n"},
};

START_TEST(messages)
{
	for (size_t i = 0; i < COUNT(faults); i++) {
		struct gcode_case c;

		case_init(&c);
		ck_assert_msg(!case_run(&c, faults[i].program), "accepted: %s", faults[i].program);
		ck_assert_str_eq(strbuf_text(&c.messages), faults[i].messages);
		case_release(&c);
	}
}
END_TEST

START_TEST(nesting_is_bounded)
{
	struct gcode_case c;

	/* Nine nested calls, but not ten. */
	expect_moves("o1 sub\no2 if [#1 LT 9]\no1 call [#1+1]\no2 else\nG0 X#1\no2 endif\no1 endsub\no1 call [1]\n",
		     "rapid 9 0 0 0 0\n");
	case_init(&c);
	ck_assert(!case_run(&c, "o1 sub\no1 call\no1 endsub\no1 call\n"));
	ck_assert_ptr_nonnull(strstr(c.messages.text, "p.nc:2:1: error: more than 9 nested calls"));
	ck_assert_ptr_nonnull(strstr(c.messages.text, "p.nc:4:1: note: o1 is called from here\n"));
	case_release(&c);
}
END_TEST

START_TEST(endless_loops_end)
{
	static const char *const endless[] = {"o1 while [1]\no1 endwhile\n", "G91 G0 X1\nM99\n",
					      "o1 do\no1 while [1]\n",
					      "o1 sub\no2 do\no2 while [1]\no1 endsub\no1 call\n"};
	struct strbuf straight = {0};
	struct gcode_case c;

	for (size_t i = 0; i < COUNT(endless); i++) {
		case_init(&c);
		c.config.read.max_blocks = 1000;
		ck_assert(!case_run(&c, endless[i]));
		ck_assert_msg(strstr(c.messages.text,
				     "error: 1000 blocks of loops and subprograms were executed: is this loop endless? "
				     "--max-blocks sets another limit"),
			      "%s", c.messages.text);
		case_release(&c);
	}
	/* A straight program is never limited. */
	for (int i = 0; i < 5000; i++)
		strbuf_addf(&straight, "G0 X%d\n", i % 2);
	case_init(&c);
	c.config.read.max_blocks = 1000;
	ck_assert(case_run(&c, straight.text));
	strbuf_release(&straight);
	case_release(&c);
}
END_TEST

/* ------------------------------------------------------------------ files */

static void write_file(const char *folder, const char *name, const char *text)
{
	struct strbuf path = {0};
	FILE *out;

	strbuf_addf(&path, "%s/%s", folder, name);
	out = fopen(path.text, "w");
	ck_assert_ptr_nonnull(out);
	fputs(text, out);
	fclose(out);
	strbuf_release(&path);
}

static void remove_files(const char *folder, const char *const names[], size_t count)
{
	for (size_t i = 0; i < count; i++) {
		struct strbuf path = {0};

		strbuf_addf(&path, "%s/%s", folder, names[i]);
		ck_assert_int_eq(remove(path.text), 0);
		strbuf_release(&path);
	}
	ck_assert_int_eq(rmdir(folder), 0);
}

static bool note_files(void *context, const struct canon_event *event)
{
	struct gcode_case *c = context;
	const struct canon_block *block = event->of.block;

	if (event->kind == CANON_MOVE) {
		ck_assert_ptr_nonnull(event->of.move->file);
		return case_move(c, event->of.move);
	}
	strbuf_addf(&c->blocks, "%s:%ld\n", strrchr(block->file, '/') ? strrchr(block->file, '/') + 1 : block->file,
		    block->line);
	return true;
}

START_TEST(subprograms_in_files)
{
	static const char *const names[] = {"square.ngc", "deep.ngc", "open.ngc"};
	char folder[] = "/tmp/fivecheck-flow-XXXXXX";
	const char *includes[1];
	struct gcode_case c;
	struct canon_sink sink = {.context = &c, .event = note_files};
	struct kinematics kinematics = case_kinematics(&c);
	struct interp *interp;
	FILE *in = tmpfile();

	ck_assert_ptr_nonnull(mkdtemp(folder));
	includes[0] = folder;
	write_file(folder, "square.ngc", "G0 X99\no<square> sub\nG0 X#1\no<deep> call [#1+1]\no<square> endsub "
	    "[#1*#1]\n");
	write_file(folder, "deep.ngc", "%\no<deep> sub\nG0 X#1\nG0 X[1/[#1-5]]\no<deep> endsub\n%\n");
	fputs("o<square> call [2]\nG0 X#<_value>\no<Square> call [4]\n", in);
	rewind(in);
	case_init(&c);
	c.diag.context = &c;
	c.config.read.includes = includes;
	c.config.read.include_count = 1;
	interp = interp_new(&c.config, &kinematics, &sink, &c.diag);
	ck_assert(!interp_run(interp, in, "p.nc"));
	interp_free(interp);
	fclose(in);
	ck_assert_str_eq(c.blocks.text, "square.ngc:3\ndeep.ngc:3\ndeep.ngc:4\np.nc:2\nsquare.ngc:3\ndeep.ngc:3\n");
	ck_assert_ptr_nonnull(strstr(c.messages.text, "/deep.ngc:4:7: error: division by zero\n"));
	ck_assert_ptr_nonnull(strstr(c.messages.text, "/square.ngc:4:1: note: o<deep> is called from here\n"));
	ck_assert_ptr_nonnull(strstr(c.messages.text, "p.nc:3:1: note: o<square> is called from here\n"));
	case_release(&c);
	write_file(folder, "open.ngc", "o<open> sub\nG0 X1\n");
	case_init(&c);
	c.config.read.includes = includes;
	c.config.read.include_count = 1;
	ck_assert(!case_run(&c, "o<open> call\n"));
	ck_assert_ptr_nonnull(strstr(c.messages.text,
				     "/open.ngc:2: error: the subprogram o<open> is not closed at the end of the file: "
				     "endsub is missing\np.nc:1:1: note: o<open> is called from here\n"));
	case_release(&c);
	remove_files(folder, names, COUNT(names));
}
END_TEST

/* ------------------------------------------------------------------ pipes */

/* The program through a pipe, written by another process. */
static bool run_piped(struct gcode_case *c, const char *program, size_t length)
{
	int ends[2];
	pid_t writer;
	FILE *in;
	bool good;

	ck_assert_int_eq(pipe(ends), 0);
	writer = fork();
	ck_assert_int_ge(writer, 0);
	if (writer == 0) {
		FILE *out = fdopen(ends[1], "w");

		close(ends[0]);
		fwrite(program, 1, length, out);
		fclose(out);
		_exit(0);
	}
	close(ends[1]);
	in = fdopen(ends[0], "r");
	good = case_run_stream(c, in);
	fclose(in);
	waitpid(writer, NULL, 0);
	return good;
}

/* A loop of so many bytes of comments, passed twice. */
static void make_loop(struct strbuf *program, size_t bytes)
{
	strbuf_addf(program, "o1 repeat [2]\nG91 G0 X1\n");
	while (program->length < bytes)
		strbuf_addf(program, "(a comment that does nothing but take room in this program)\n");
	strbuf_addf(program, "o1 endrepeat\nG0 X10\n");
}

START_TEST(loops_on_pipes)
{
	static const char *const moves = "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 12 0 0 0 0\n";
	struct strbuf small = {0}, large = {0};
	struct gcode_case c;

	make_loop(&small, (size_t)3 << 20);
	case_init(&c);
	ck_assert_msg(run_piped(&c, small.text, small.length), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(c.moves.text, moves);
	case_release(&c);
	/* A file can deliver what a pipe no longer can. */
	make_loop(&large, (size_t)20 << 20);
	case_init(&c);
	ck_assert(case_run(&c, large.text));
	ck_assert_str_eq(c.moves.text, moves);
	case_release(&c);
	case_init(&c);
	ck_assert(!run_piped(&c, large.text, large.length));
	ck_assert_msg(strstr(c.messages.text,
			     "error: a jump to line 2 of p.nc, which is no longer available in the pipe (the last 4 "
			     "MiB are kept); give the program as a file"),
		      "%s", c.messages.text);
	case_release(&c);
	strbuf_release(&small);
	strbuf_release(&large);
}
END_TEST

/* Loops over the borders of what the reader holds: lines of all lengths, and their count stays right. */
START_TEST(jumps_keep_lines)
{
	struct strbuf program = {0};
	struct gcode_case c;

	strbuf_addf(&program, "\xef\xbb\xbfo1 sub\nG0 X#<_line>\no1 endsub\n");
	for (int i = 0; i < 40000; i++)
		strbuf_addf(&program, "(%*s)\n", i % 37, "");
	strbuf_addf(&program, "o1 call\nG0 X#<_line>\n");
	case_init(&c);
	ck_assert_msg(case_run(&c, program.text), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(c.moves.text, "rapid 2 0 0 0 0\nrapid 40005 0 0 0 0\n");
	ck_assert_int_eq(c.lines, 40005);
	case_release(&c);
	strbuf_release(&program);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {ways,		    messages,	    nesting_is_bounded, endless_loops_end,
				      subprograms_in_files, loops_on_pipes, jumps_keep_lines};

	return RUN_TESTS("gcode_flow", tests);
}
