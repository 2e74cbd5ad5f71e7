/* test_gcode_klartext_bad_frame.c - what is wrong with datum shifts, tilted planes, TCPM and M-functions of moves: the exact messages. */
#include "klartext_case.h"

static const struct klartext_fault faults[] = {
	{"FUNCTION MODE MILL \"HEAD2\"\n",
	 "p.nc:2:20: error: FUNCTION MODE MILL with another kinematics is not supported: leave its name out, and "
	 "check the program with the machine file of these kinematics"},
	{"LBL 1\nFUNCTION COUNT REPEAT LBL 1\n",
	 "p.nc:3:10: error: FUNCTION COUNT REPEAT: how often it jumps the counter of the control says; to check the program, "
	 "write CALL LBL ... REP 1 in its place"},
	{"L M128\nTOOL CALL 1 Z\n",
	 "p.nc:3:11: error: TOOL CALL while M128 is in force: the manual wants M129 first"},
	{"CYCL DEF 7.1 X+5\n",
	 "p.nc:2:10: error: CYCL DEF 7.1, but no 7.0 has begun the cycle"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X\n",
	 "p.nc:3:14: error: DATUM SHIFT needs an axis and a value here"},
	{"CYCL DEF 7.0 DATUM SHIFT X+5\n",
	 "p.nc:2:27: error: a value behind the name of a cycle: values stand in the lines .1 and on"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 Y+5\nCYCL DEF 7.0\nCYCL DEF 7.1\n",
	 "p.nc:5:10: error: a line without values while a datum shift is in force: whether it cancels that is not known "
	 "here; write X+0, Y+0 and Z+0"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 C+5\nCYCL DEF 7.0\nCYCL DEF 7.1\n",
	 "p.nc:5:10: error: a line without values while a datum shift is in force: whether it cancels that is not known "
	 "here; write X+0, Y+0 and Z+0"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\nCYCL DEF 10.0\nCYCL DEF 10.1\n",
	 "p.nc:5:10: error: a line without values while a rotation is in force: whether it cancels that is not known here; "
	 "write ROT+0"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2\nCYCL DEF 26.0\nCYCL DEF 26.1\n",
	 "p.nc:5:10: error: a line without values while a scaling is in force: whether it cancels that is not known here; "
	 "write a factor of 1 for each axis"},
	{"CC X+0 Y+0\nCYCL DEF 7.0\nCYCL DEF 7.1 X+10\nLP PR+10 PA+0 FMAX\n",
	 "p.nc:5:4: error: X of CC was given before a change of coordinates: whether the centre has moved with them is not "
	 "known here; write CC again, with all its coordinates"},
	{"CC X+5 Y+0\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nCC Y+5\n",
	 "p.nc:5:4: error: X of CC was given before a change of coordinates: whether the centre has moved with them is not "
	 "known here; write CC again, with all its coordinates"},
	{"CC X+0 Y+0\nLP PR+30 PA+0 FMAX\nCC X+10 Y+0\nLP PA+90 FMAX\n",
	 "p.nc:5:4: error: the tool has moved, or CC has changed, since the last PR and PA: from where PR counts is not known "
	 "here; write PR and PA as absolute values"},
	{"CC X+0 Y+0\nLP PR+30 PA+0 FMAX\nL Y+10 FMAX\nLP PR+30 IPA+90 FMAX\n",
	 "p.nc:5:4: error: the tool has moved, or CC has changed, since the last PR and PA: from where PA counts is not known "
	 "here; write PR and PA as absolute values"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 #5\n",
	 "p.nc:3:14: error: the setup has no row 5 of the datum table: add <work_offset name=\"#5\" X=\"\" Y=\"\" Z=\"\"/> "
	 "with its values"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 #1.5\n",
	 "p.nc:3:14: error: a row of the datum table is a whole number from 0 to 9999, alone in its line"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 #1 X+5\n",
	 "p.nc:3:14: error: a row of the datum table is a whole number from 0 to 9999, alone in its line"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 B+5\n",
	 "p.nc:3:14: error: the machine has no B axis"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\n",
	 "p.nc:5:14: error: a datum shift while a mirror image, a rotation or a scaling is in force: "
	 "whether it is turned with them is not known here; shift the datum first"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n",
	 "p.nc:5:10: error: a mirror image and a rotation at a time: their order is not known here; "
	 "cancel one of them first"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 C\n",
	 "p.nc:3:14: error: a mirror image of C is not supported"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X+5\n",
	 "p.nc:3:14: error: MIRROR IMAGE needs axes without values here"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 X+5\n",
	 "p.nc:3:15: error: ROTATION needs ROT and an angle here"},
	{"CYCL DEF 11.0\nCYCL DEF 11.1 SCL 0.5\n",
	 "p.nc:3:15: error: a machine parameter says whether SCALING changes Z, too: set cycle_11_axes=\"plane\" "
	 "or \"all\" in the machine file's <controller>, or give the factors of X, Y and Z by CYCL DEF 26"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2\nCYCL DEF 11.0\nCYCL DEF 11.1 SCL 1\n",
	 "p.nc:5:10: error: CYCL DEF 11 while CYCL DEF 26 scales: cancel that first"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2\nCYCL DEF 26.0\nCYCL DEF 26.1 X1\n",
	 "p.nc:5:15: error: an axis is scaled that this CYCL DEF 26 does not name: whether it stays so is not known here; name "
	 "it, too"},
	{"CYCL DEF 11.0\nCYCL DEF 11.1 SCL 0\n",
	 "p.nc:3:15: error: a scaling factor must be more than 0 and less than 100"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 A2\n",
	 "p.nc:3:15: error: AXIS-SPECIFIC SCALING needs X, Y, Z or CCX, CCY, CCZ with a value here"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2\nF100\nL X+5\nCC X+0 Y+0\nC X+0 Y+5 DR+\n",
	 "p.nc:7:3: error: a circle while the factors of its plane's axes differ would be an ellipse"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n",
	 "p.nc:5:10: error: a rotation and factors that differ in X and Y at a time: their order is not "
	 "known here; cancel one of them first"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45 ABST50\n",
	 "p.nc:3:10: error: a set-up clearance of CYCL DEF 19 needs F beside it"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45\nL X+1 FMAX\n",
	 "p.nc:4:3: error: PLANE ... STAY needs the rotary axes at A45 C0: a move of linear axes before they stand there is "
	 "not supported; turn them there first, or write TURN"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45 B+0 C+0\nCYCL DEF 19.0\nCYCL DEF 19.1\nCYCL DEF 19.0\nCYCL DEF 19.1 B+0 C+0\n",
	 "p.nc:7:10: error: CYCL DEF 19 without A behind PLANE or an empty CYCL DEF 19: which angle it keeps is not known "
	 "here; name A, B and C"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nCYCL DEF 19.0\nCYCL DEF 19.1 A-45 C+0\n",
	 "p.nc:4:10: error: CYCL DEF 19 without B behind PLANE or an empty CYCL DEF 19: which angle it keeps is not known "
	 "here; name A, B and C"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45 B+0 C+0\nCYCL DEF 19.2 F1000 ABST50\n",
	 "p.nc:4:10: error: CYCL DEF 19 without angles has neither F nor a set-up clearance"},
	{"CYCL DEF 247 Q339=5\n",
	 "p.nc:2:14: error: the setup defines no work offset G54.1 P5: add <work_offset name=\"G54.1 "
	 "P5\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
	{"CYCL DEF 247 Q339=301\n",
	 "p.nc:2:14: error: presets from 0 to 300 are supported, as G54 and G54.1 P1 to P300 of the setup"},
	{"CYCL DEF 247 Q339=0\n",
	 "p.nc:2:14: error: the setup defines no work offset G54: add <work_offset name=\"G54\" X=\"\" Y=\"\" Z=\"\"/> with "
	 "its values"},
	{"CYCL DEF 247 Q338=1\n",
	 "p.nc:2:10: error: DATUM SETTING needs Q339, the number of the preset"},
	{"CYCL DEF 247\nL X+1 FMAX\n",
	 "p.nc:2:10: error: DATUM SETTING needs Q339, the number of the preset"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\nCYCL DEF 247 Q339=1\n",
	 "p.nc:4:14: error: a preset while a mirror image, a rotation, a scaling or a shift in a tilted plane is in "
	 "force: which of them it cancels is not known here; cancel them first"},
	{"CYCL DEF 9.0\nCYCL DEF 9.1 DWELL -1\n",
	 "p.nc:3:10: error: a dwell cannot be negative"},
	{"PLANE FOO\n",
	 "p.nc:2:7: error: PLANE needs SPATIAL, PROJECTED, AXIAL, EULER, VECTOR, POINTS, RELATIVE or RESET"},
	{"PLANE SPATIAL SPA+5 TURN\n",
	 "p.nc:2:21: error: SPB is needed here"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0\n",
	 "p.nc:2:7: error: PLANE needs MOVE, TURN or STAY: what the rotary axes do"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN\n",
	 "p.nc:2:7: error: PLANE ... TURN and MOVE need F or FMAX"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX SYM\n",
	 "p.nc:2:43: error: this is no word of PLANE"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN STAY\n",
	 "p.nc:2:38: error: another word of this PLANE excludes this one"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX SEQ+ SEQ-\n",
	 "p.nc:2:48: error: another word of this PLANE excludes this one"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX SEQ- SYM+\n",
	 "p.nc:2:48: error: another word of this PLANE excludes this one"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX TABLE ROT COORD ROT\n",
	 "p.nc:2:53: error: another word of this PLANE excludes this one"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 STAY STAY\n",
	 "p.nc:2:38: error: another word of this PLANE excludes this one"},
	{"L X+1 M3 M5\n",
	 "p.nc:2:10: error: M3 and M5 in one block"},
	{"L X+1 F1 M128 M129\n",
	 "p.nc:2:15: error: M128 and M129 in one block"},
	{"L X+1 M127 M126\n",
	 "p.nc:2:12: error: M127 and M126 in one block"},
	{"CR X+9 R+9 DR+ DR-\n",
	 "p.nc:2:16: error: DR stands twice in the block"},
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL X+1 A+1 A+2 F100\n",
	 "p.nc:3:11: error: A stands twice in the block"},
	{"LN X+1 NX+0 NY+0 NZ+1 NZ+0.5 F100\n",
	 "p.nc:2:23: error: NZ stands twice in the block"},
	{"LN X+1 TX+0 TX+1 F100\n",
	 "p.nc:2:13: error: TX stands twice in the block"},
	{"CYCL DEF 247 Q339=1 Q339=2\n",
	 "p.nc:2:21: error: Q339 stands twice in the cycle, already in line 2"},
	{"FUNCTION TCPM F TCP AXIS POS AXIS SPAT\n",
	 "p.nc:2:30: error: AXIS stands twice in the block"},
	{"FUNCTION TCPM AXIS POS PATHCTRL AXIS PATHCTRL VECTOR\n",
	 "p.nc:2:38: error: PATHCTRL stands twice in the block"},
	{"TRANS DATUM AXIS X+1 X+2\n",
	 "p.nc:2:22: error: X stands twice in the cycle, already in line 2"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5 ROT+6\n",
	 "p.nc:3:21: error: ROT stands twice in the cycle, already in line 3"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 STAY MB50\n",
	 "p.nc:2:7: error: MB of PLANE needs TURN or MOVE"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN MB50 FMAX\n",
	 "p.nc:2:7: error: MB of PLANE where no rotary axis has to turn: it is not known whether the tool "
	 "retracts: set plane_retract=\"always\" or \"turning\" in the machine file's <controller>, or write M140 "
	 "in a block before"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN MB-50 FMAX\n",
	 "p.nc:2:40: error: the way of MB cannot be negative"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX HELLO\n",
	 "p.nc:2:43: error: this is no word of PLANE"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX SEQ-\n",
	 "p.nc:2:7: error: no position of the rotary axes within their limits has the tool stand on "
	 "this plane with this SEQ"},
	{"PLANE PROJECTED PROPR+5 PROMIN+5 ROT+0 TURN FMAX\n",
	 "p.nc:2:17: error: PLANE PROJECTED with PROPR other than 0: to which side it counts is not known here; write the plane "
	 "as PLANE SPATIAL or PLANE VECTOR"},
	{"PLANE PROJECTED PROPR+0 PROMIN+90 ROT+0 TURN FMAX\n",
	 "p.nc:2:17: error: PROMIN is between -90 and 90 degrees"},
	{"PLANE PROJECTED PROPR+0 PROMIN+5 TURN FMAX\n",
	 "p.nc:2:34: error: ROT is needed here"},
	{"PLANE AXIAL B+5 STAY\n",
	 "p.nc:2:13: error: the machine has no B axis"},
	{"PLANE AXIAL A+30 STAY\nL A+Q120 FMAX\n",
	 "p.nc:3:5: error: Q120 is a value of the control that is not known here: write the value in its place"},
	{"PLANE AXIAL STAY\n",
	 "p.nc:2:13: error: PLANE AXIAL needs A, B or C"},
	{"PLANE AXIAL IB+5 STAY\n",
	 "p.nc:2:13: error: the machine has no B axis"},
	{"L C+10 FMAX\nPLANE AXIAL A+30 STAY\n",
	 "p.nc:3:7: error: C is not named here and stands at 10: what it does is not known here; name it, too"},
	{"PLANE AXIAL A+30 STAY\nL X+1 FMAX\n",
	 "p.nc:3:3: error: PLANE ... STAY needs the rotary axes at A30 C0: a move of linear axes before they stand there is "
	 "not supported; turn them there first, or write TURN"},
	{"PLANE VECTOR BX+0 BY+0 BZ+1 NX+0 NY+0 NZ+1 TURN FMAX\n",
	 "p.nc:2:14: error: the base vector must not be parallel to the normal"},
	{"PLANE VECTOR BX+0 BY+0 BZ+0 NX+0 NY+0 NZ+1 TURN FMAX\n",
	 "p.nc:2:14: error: a vector of length 0 has no direction"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX\n",
	 "p.nc:2:7: error: any angle of C suits this plane: a parameter of the control decides whether the table "
	 "turns or only the coordinates: set plane_rotation=\"coordinates\" or \"table\" in the machine file's "
	 "<controller>, or write COORD ROT or TABLE ROT in PLANE"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A+0 B+0 C+30\n",
	 "p.nc:3:10: error: any angle of C suits this plane: a parameter of the control decides whether the table "
	 "turns or only the coordinates: set plane_rotation=\"coordinates\" or \"table\" in the machine file's "
	 "<controller>, or write COORD ROT or TABLE ROT in PLANE"},
	/*
	 * Posts cancel the shift and the plane in this order; it is not known whether that also cancels the shift from
	 * before the plane.
	 */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nPLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0\n"
	 "PLANE RESET STAY\nL Y+1 Z+2 FMAX\nL X-7 R0 FMAX M91\nL X+1 FMAX\n",
	 "p.nc:10:3: error: the datum of X was shifted before a tilted plane, and in it again: whether the first shift "
	 "counts behind the plane is not known here; set shift_behind_plane=\"keeps\" or \"cancelled\" in the machine file's "
	 "<controller>, write CYCL DEF 7 with X again, or end the plane before the shift"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 Y+10\nPLANE SPATIAL SPA-90 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 Y+0\n"
	 "PLANE RESET STAY\nCC X+0 Y+0\nLP PR+10 PA+0 FMAX\n",
	 "p.nc:9:4: error: the datum of Y was shifted before a tilted plane, and in it again: whether the first shift "
	 "counts behind the plane is not known here; set shift_behind_plane=\"keeps\" or \"cancelled\" in the machine file's "
	 "<controller>, write CYCL DEF 7 with Y again, or end the plane before the shift"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+180 TURN FMAX TABLE ROT\n",
	 "p.nc:2:7: error: half a turn of C: either way is as short; set half_turn=\"positive\" or \"negative\" of this axis "
	 "in the machine file"},
	{"L C+5 FMAX\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX\n",
	 "p.nc:3:7: error: any angle of C suits this plane, and it stands at 5: whether the control leaves it "
	 "there or turns it to 0 depends on its generation: set swivel_pole=\"stays\" or \"zero\" in the machine "
	 "file's <controller>, or turn C to 0 in a block before"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL X+1 FMAX\n",
	 "p.nc:3:3: error: PLANE ... STAY needs the rotary axes at A30 C0: a move of linear axes before they stand there is "
	 "not supported; turn them there first, or write TURN"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL A+30 X+1 FMAX\n",
	 "p.nc:3:3: error: PLANE ... STAY needs the rotary axes at A30 C0: a move of linear axes before they stand there is "
	 "not supported; turn them there first, or write TURN"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL M128\n",
	 "p.nc:3:3: error: M128 before the rotary axes stand where PLANE ... STAY needs them"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL A+5 FMAX\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first, or M128"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL A+5 FMAX M91\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first"},
	{"L M128\nPLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\n",
	 "p.nc:3:7: error: PLANE while M128 is in force is not supported; M129 first"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n"
	 "PLANE RESET STAY\n",
	 "p.nc:5:7: error: PLANE while a mirror image, a rotation, a scaling or a shift of tilted "
	 "coordinates is in force: cancel it first, the last one first"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 247 Q339=1\nL X+1 FMAX\n",
	 "p.nc:4:3: error: CYCL DEF 247 has selected a preset in a tilted plane: whether the plane "
	 "stays tilted is not known here; write PLANE RESET first"},
	{"PLANE RELATIVE A+5 TURN FMAX\n",
	 "p.nc:2:16: error: PLANE RELATIVE needs SPA, SPB or SPC"},
	{"L C+270 FMAX\nPLANE RESET TURN FMAX\n",
	 "p.nc:3:7: error: whether PLANE RESET turns C to 0 or to a whole turn is not known here; turn "
	 "it in a block before"},
	{"M128\nL X+1 FMAX M91\n",
	 "p.nc:3:12: error: M91 while M128 is in force: the manual wants M129 first"},
	{"M140\n",
	 "p.nc:2:1: error: M140 needs MB and a way, or MB MAX"},
	{"M140 MB-5\n",
	 "p.nc:2:1: error: the way of M140 cannot be negative"},
	{"L X+1 M140 MB MAX FMAX\n",
	 "p.nc:2:7: error: M140 beside axis words: which comes first is not known here; write two blocks"},
	{"L C+720 FMAX\nM94\n",
	 "p.nc:3:1: error: M94 where C stands a turn or more away from 0 is not supported"},
	{"M138 A\nL X+1 FMAX\n",
	 "p.nc:2:1: error: M138 that leaves C out is not supported"},
	{"M94 B\n",
	 "p.nc:2:5: error: the machine has no B axis"},
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL X+1 A+5 C+0 FMAX\n",
	 "p.nc:3:3: error: the first block behind AXIS SPAT needs all of A, B and C: B is missing"},
	{"FUNCTION RESET TCPM X+5\n",
	 "p.nc:2:21: error: the block should end here"},
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL IA+5 FMAX\n",
	 "p.nc:3:3: error: an increment of a spatial angle (AXIS SPAT) is not supported"},
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nF100\nCR X+5 R+10 DR+ A+5\n",
	 "p.nc:4:4: error: a spatial angle (AXIS SPAT) in a circle or in polar coordinates is not supported"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL X+1 C+20 F100\n",
	 "p.nc:3:3: error: PATHCTRL VECTOR brings C to 0 degrees, and the block to 20: what the control does then is not "
	 "known here; write PATHCTRL AXIS"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL X+1 A+91 F100\n",
	 "p.nc:3:3: error: a turn of the tool by more than 90 degrees with PATHCTRL VECTOR is not supported; write PATHCTRL "
	 "AXIS"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nTOOL CALL 1 Z S1\n",
	 "p.nc:3:11: error: TOOL CALL while M128 is in force: the manual wants M129 first"},
	{"TOOL CALL 1 Z S1\nFUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL X+1 A+5 RL F100\n",
	 "p.nc:4:3: error: radius compensation with PATHCTRL VECTOR is not supported; post the path of the tool's centre with "
	 "R0"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL WEG\n",
	 "p.nc:2:30: error: PATHCTRL of TCPM is AXIS or VECTOR"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS F\n",
	 "p.nc:2:44: error: F of TCPM is TCP, CONT, MAX or a feed rate"},
	{"FUNCTION TCPM\n",
	 "p.nc:2:14: error: FUNCTION TCPM needs AXIS POS or SPAT, and PATHCTRL AXIS or VECTOR"},
	{"FUNCTION TCPM AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n",
	 "p.nc:2:38: error: REFPNT other than TIP-TIP is not supported"},
	{"FUNCTION MODE TURN\n",
	 "p.nc:2:10: error: this FUNCTION is not supported; TCPM, RESET TCPM and MODE MILL are"},
	{"FUNCTION TCPM FOO\n",
	 "p.nc:2:15: error: this is no word of FUNCTION TCPM"},
	{"FUNCTION TCPM F FOO\n",
	 "p.nc:2:15: error: F of TCPM is TCP, CONT, MAX or a feed rate"},
	{"LN X+1 TX+0 TY+0 TZ+1 F100\n",
	 "p.nc:2:4: error: TX, TY and TZ turn the rotary axes while M128 or TCPM is in force only; write it before"},
	{"M128\nLN X+1 TX+0 TY+0 TZ+0.9 F100\n",
	 "p.nc:3:4: error: TX, TY and TZ have to be a vector of length 1"},
	{"M128\nLN X+1 A+5 TX+0 TY+0 TZ+1 F100\n",
	 "p.nc:3:4: error: TX, TY and TZ beside words of rotary axes"},
	{"TOOL CALL 1 Z DL+1\nLN X+1 NX+0 NY+0 NZ+1 F100\n",
	 "p.nc:3:4: error: LN with an oversize of the tool (DL, DR, DR2 of TOOL CALL): "
	 "three-dimensional compensation is not supported"},
	{"LN X+1 NQ+0 F100\n",
	 "p.nc:2:8: error: NX, NY or NZ is needed here"},
	{"CYCL DEF 7 DATUM SHIFT\n",
	 "p.nc:2:10: error: CYCL DEF 7 is written in lines 7.0, 7.1 and on"},
	{"TRANS DATUM TABLE\n",
	 "p.nc:2:18: error: TRANS DATUM TABLE needs TABLINE and a row"},
	{"TRANS DATUM TABLE TABLINE7\n",
	 "p.nc:2:26: error: the setup has no row 7 of the datum table: add <work_offset name=\"#7\" X=\"\" Y=\"\" Z=\"\"/> "
	 "with its values"},
	{"TRANS DATUM X+5\n", "p.nc:2:13: error: TRANS DATUM needs AXIS, TABLE or RESET"},
	{"TOOL CALL 7.1 Z S100\n",
	 "p.nc:2:11: error: the setup defines no tool named \"7.1\": add <tool number=\"\" name=\"7.1\" length=\"\"/> with what "
	 "it is made of"},
	{"TRANS SCALE SCL2\n",
	 "p.nc:2:13: error: a machine parameter says whether SCALING changes Z, too: set cycle_11_axes=\"plane\" "
	 "or \"all\" in the machine file's <controller>, or give the factors of X, Y and Z by CYCL DEF 26"},
	{"TRANS SIZE\n",
	 "p.nc:2:7: error: TRANS needs DATUM, MIRROR, ROTATION or SCALE"},
	{"TRANS DATUM AXIS X+5\nPRESET SELECT #1 KEEP TRANS\n",
	 "p.nc:3:8: error: KEEP TRANS while a datum shift is in force is not supported: write TRANS DATUM RESET first, and the "
	 "shift again behind the preset"},
	{"TRANS MIRROR X\n",
	 "p.nc:2:14: error: TRANS MIRROR needs AXIS and the letters of axes"},
	{"TRANS MIRROR AXIS X+5\n",
	 "p.nc:2:19: error: MIRROR IMAGE needs axes without values here"},
	{"TRANS MIRROR AXIS X\nTRANS MIRROR AXIS Y\n",
	 "p.nc:3:7: error: TRANS MIRROR without X, which is mirrored: whether it stays so is not known here; write "
	 "TRANS MIRROR RESET first"},
	{"TRANS ROTATION 5\n",
	 "p.nc:2:16: error: ROTATION needs ROT and an angle here"},
	{"TRANS MIRROR AXIS X\nTRANS ROTATION ROT+5\n",
	 "p.nc:3:7: error: a mirror image and a rotation at a time: their order is not known here; cancel one of them "
	 "first"},
	{"PRESET CORR X+1\n",
	 "p.nc:2:8: error: PRESET other than PRESET SELECT changes the preset table, which is not known here"},
	{"PRESET SELECT 1\n",
	 "p.nc:2:15: error: PRESET SELECT needs # and the number of the preset"},
	{"PRESET SELECT #1 KEEP WP\n",
	 "p.nc:2:23: error: KEEP needs TRANS"},
	{"TRANS ROTATION ROT+5\nPRESET SELECT #1 KEEP TRANS\n",
	 "p.nc:3:16: error: a preset while a mirror image, a rotation, a scaling or a shift in a tilted plane is in force: which of "
	 "them it cancels is not known here; cancel them first"},
	{"TRANS DATUM AXIS X+5\nTRANS DATUM AXIS Y+5\n",
	 "p.nc:3:7: error: TRANS DATUM without X, which is shifted: whether the shift stays is not known here; write X, too"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL C+360 FMAX\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first, or M128"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL M128\nL A+10 FMAX\nM129\nL X+1 FMAX\n",
	 "p.nc:6:3: error: PLANE ... STAY needs the rotary axes at A30 C0: a move of linear axes before they stand there is "
	 "not supported; turn them there first, or write TURN"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nL IX+1 FMAX\n",
	 "p.nc:4:3: error: an increment of X after a change of coordinates or a move that was not programmed in "
	 "them: from where the control counts is not known here; give X as an absolute coordinate first, or set "
	 "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from where the axis "
	 "stands"},
	{"M140 MB50\nL IZ-1 FMAX\n",
	 "p.nc:3:3: error: an increment of Z after a change of coordinates or a move that was not programmed in "
	 "them: from where the control counts is not known here; give Z as an absolute coordinate first, or set "
	 "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from where the axis "
	 "stands"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCC IX+5 IY+0\n",
	 "p.nc:4:4: error: an increment of X after a change of coordinates or a move that was not programmed in "
	 "them: from where the control counts is not known here; give X as an absolute coordinate first, or set "
	 "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from where the axis "
	 "stands"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCC\n",
	 "p.nc:4:3: error: an increment of X after a change of coordinates or a move that was not programmed in "
	 "them: from where the control counts is not known here; give X as an absolute coordinate first, or set "
	 "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from where the axis "
	 "stands"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 Y+10\nCC X+0 Y+0\nLP IPR+5 PA+0 FMAX\n",
	 "p.nc:5:4: error: an increment of Y after a change of coordinates or a move that was not programmed in "
	 "them: from where the control counts is not known here; give Y as an absolute coordinate first, or set "
	 "increments_after_shift=\"stay\" in the machine file's <controller> if it counts from where the axis "
	 "stands"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 C+10\nL IC+5 FMAX\n",
	 "p.nc:4:3: error: an increment of C after its datum was shifted: from where the control counts is not "
	 "known here; give C as an absolute coordinate first, or set increments_after_shift=\"stay\" in the "
	 "machine file's <controller> if it counts from where the axis stands"},
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
	return run_suite("gcode_klartext_bad_frame", tcase);
}
