/* test_gcode_klartext_bad_string.c - what is wrong with string parameters and functions of strings: the exact messages. */
#include "klartext_case.h"

static const struct klartext_fault faults[] = {
	{"QS1 = \"A\"\nQ1 = QS1 + 1\n",
	 "p.nc:3:6: error: a string (QS) in a formula is not supported"},
	{"QS1 = QS2\n",
	 "p.nc:2:7: error: QS2 has no value that is known here; if the control holds one from before, set "
	 "<variable name=\"QS2\" value=\"\"/> in the machine file's <controller>"},
	{"QS2 = \"ABC\"\nQS1 = SUBSTR ( SRC_QS2 BEG1 LEN3 )\n",
	 "p.nc:3:32: error: a place inside of the string is a whole number from 0 to 2"},
	{"QS1 = \"\303\204B\"\nQ1 = STRLEN ( SRC_QS1 )\n",
	 "p.nc:3:13: error: STRLEN: the places in \"\303\204B\" are only known if all letters are of ASCII"},
	{"QS1 = \"\304B\"\nQS1 = SUBSTR ( SRC_QS1 BEG0 LEN1 )\n",
	 "p.nc:3:14: error: SUBSTR: the places in \"\304B\" are only known if all letters are of ASCII"},
	{"QS1 = TOCHAR ( DAT+123456789.123 DECIMALS9 )\n",
	 "p.nc:2:14: error: TOCHAR: 123456789.123 is too large, or has more decimals than 9"},
	{"QS1 = TOCHAR ( DAT+1.25 DECIMALS1 )\n",
	 "p.nc:2:14: error: TOCHAR: 1.25 is too large, or has more decimals than 1"},
	{"QS1 = \"A\"\nQS2 = \"b\"\nQ1 = STRCOMP ( SRC_QS1 SEA_QS2 )\n",
	 "p.nc:4:6: error: STRCOMP: which of the two texts comes first is not known here"},
	{"QS1 = \"X\" || SYSSTR ( ID10321 NR0 )\nFN 16: F-PRINT A.A / A.TXT\nQ1 = STRLEN ( SRC_QS1 )\n",
	 "p.nc:4:19: error: QS1 has no value that is known here"},
	{"QS1 = \"A\" || \n",
	 "p.nc:2:14: error: a string is a text in quotation marks, QS, SUBSTR, TOCHAR, SYSSTR, or several of them joined by "
	 "||"},
	{"QS1 \"A\"\n",
	 "p.nc:2:5: error: '=' is needed here"},
	{"QS1 = \"A\" + 5\n",
	 "p.nc:2:11: error: the block should end here"},
	{"QS2000 = \"A\"\n",
	 "p.nc:2:3: error: the number of QS is a whole number from 0 to 1999"},
	{"DECLARE QS1\n",
	 "p.nc:2:9: error: DECLARE needs STRING"},
	{"DECLARE STRING Q1 = \"A\"\n",
	 "p.nc:2:16: error: a string parameter, QS and its number, is needed here"},
	{"DECLARE STRING QS1 = \"A\"\nQ1 = TONUMB ( SRC_QS1 )\n",
	 "p.nc:3:13: error: \"A\" is no number"},
	{"Q1 = TONUMB ( QS1 )\n",
	 "p.nc:2:15: error: TONUMB needs SRC_QS and a number here"},
	{"Q1 = TONUMB SRC_QS1\n",
	 "p.nc:2:13: error: TONUMB needs ( SRC_QS and a number )"},
	{"QS1 = \"A\"\nFN 28: TABREAD QS2 = 5/\"X\"\nQS3 = QS1\n",
	 "p.nc:4:7: error: QS1 has no value that is known here"},
	{"QS1 = \"GHOST\"\nTOOL CALL QS1 Z S100\n",
	 "p.nc:3:11: error: the setup defines no tool named \"GHOST\": add <tool number=\"\" name=\"GHOST\" length=\"\"/> with "
	 "what it is made of"},
	{"QS1 = \"" "0123456789012345678901234567890123456789012345678901234567890123456789" "\"\nQS2 = QS1 || QS1\n",
	 "p.nc:3:1: error: a string of more than 127 characters is not supported"},
};

START_TEST(fault_table)
{
	klartext_expect_fault(&faults[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("bad");

	tcase_add_loop_test(tcase, fault_table, 0, COUNT(faults));
	return run_suite("gcode_klartext_bad_string", tcase);
}
