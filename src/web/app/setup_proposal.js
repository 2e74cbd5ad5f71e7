// @ts-check
/** setup_proposal.js - what a setup needs for a machine and its programs: axes, work offsets and tools. */

const AXES = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'];
/** If a program has more tools or offsets than this, the others are not proposed. */
const MOST = 40;

/** The axes in a machine file. @param {string} machine */
export function axesIn(machine) {
	const letters = [...machine.matchAll(/<axis\s[^>]*?\bname=["']([A-Z])["']/g)].map(([, letter]) => letter);
	return AXES.filter((axis) => letters.length === 0 ? 'XYZ'.includes(axis) : letters.includes(axis));
}

/** The programs without their comments. @param {string[]} programs */
function codeOf(programs) {
	return programs.map((text) => text.replace(/\([^)\n]*\)|;.*/g, ' ')).join('\n');
}

/** @param {RegExp} pattern with one group @param {string} code */
function found(pattern, code) {
	return [...new Set([...code.matchAll(pattern)].map(([, text]) => text))];
}

/**
 * The tools that programs call, by number or by name.
 * @param {string[]} programs
 * @returns {{number: string, name: string}[]}
 */
export function toolsIn(programs) {
	const code = codeOf(programs), numbers = found(/(?<![A-Z0-9_#<"])T(?:OOL CALL)?\s*=?\s*0*([1-9]\d*)(?![\d.]*[A-Z_])/gi, code).sort((a, b) => Number(a) - Number(b));
	const free = Math.max(0, ...numbers.map(Number)) + 1, names = found(/(?<![A-Z0-9_])T(?:OOL CALL)?\s*=?\s*"([^"\n]+)"/gi, code);
	return [...numbers.map((number) => ({number, name: ''})), ...names.map((name, i) => ({number: String(free + i), name}))].slice(0, MOST);
}

/**
 * The names of the work offsets that programs select; the usual one if there are none.
 * @param {string} machine @param {string[]} programs
 */
export function offsetsIn(machine, programs) {
	const code = codeOf(programs).toUpperCase(), dialect = machine.match(/\bdialect=["'](\w+)["']/)?.[1];
	const names = dialect === 'klartext' ? [...found(/Q339\s*=\s*\+?0*([1-9]\d*)/g, code).map((number) => `G54.1 P${number}`), ...found(/CYCL DEF 7\.1\s*(#\d+)/g, code)]
		: dialect === 'sinumerik' ? found(/(?<![A-Z0-9_])(G5[4-7]|G5(?:0[5-9]|[1-9]\d))(?![\d.])/g, code)
		: found(/(?<![A-Z0-9_])(G0*5[4-9](?:\.1\s*P\s*\d+|\.[1-3])?|G154\s*P\s*\d+)(?!\d)/g, code).map((name) => name.replace(/^G0+/, 'G').replace(/\s*P\s*/, ' P'));
	const usual = dialect === 'klartext' ? 'G54.1 P1' : 'G54';
	return (names.length ? [...new Set(names)] : [usual]).slice(0, MOST);
}
