// @ts-check
/**
 * first_programs.js - for each example a few clear blocks and a change that makes them collide; and the start position
 * of the machine, if it is not at home.
 */

/** @type {Record<string, {blocks: string, change: string, start?: Record<string, number>}>} */
export const FIRST_PROGRAMS = {
	'ac-trunnion': {
		blocks: `G21 G17 G40 G49 G61 G80 G90 G94
T1 M6
S12000 M3
G54
G0 A-30 C90
X0 Y60
G43 H1
Z150
G1 Z60 F3000
Y20 F800
G0 Z150
M2
`,
		change: 'Try Z20 in place of Z60 in line 9: the cutter meets the arbor below the impeller.',
	},
	'b-head-c-table': {
		blocks: `G21 G17 G40 G49 G61 G80 G90 G94
G53 G0 Z0
G53 X-400
T1 M6
S12000 M3
G54
G0 B65 C40
G43.4 H1
X73 Y63 Z400
Z250
G1 X24.877 Y21.524 Z219.464 F900
X23.903 Y22.166 Z219.037 C68 F3000
G0 X73 Y63 Z250
Z400
M2
`,
		change: 'Try Z20 in place of Z219.464 in line 11: the cutter meets the vise.',
		start: {X: -400},
	},
	'cb-head': {
		blocks: `G21 G17 G40 G49 G61 G80 G90 G94
G53 G0 Z0
T1 M6
S9000 M3
G54
G0 B9 C0
X150 Y0
G43.4 H1
X190 Z216
G1 X166.615 Z78 F1500
X166.076 Y10.913 C5.691 F2800
X164.448 Y21.736 C11.529
G0 X190 Z216
M2
`,
		change: 'Try Z0 in place of Z78 in line 10: the cutter meets the clamps.',
	},
};
