// @ts-check
// marks.js - when tools change, and the names of operations: the comments of the program.

/** @typedef {import('./model.js').Mark} Mark */
/** @typedef {import('./path.js').ReportPath} ReportPath */

const MOST = 300;

/** @param {ReportPath} path @param {{number: number, name: string|null}[]} tools @returns {Mark[]} */
export function toolChanges(path, tools) {
	const times = path.levels.coarse[path.time], numbers = path.levels.coarse[path.tool];
	/** @type {Mark[]} */
	const marks = [];
	for (let row = 1; row < numbers.length && marks.length < MOST; row++) {
		if (row > 1 && numbers[row] === numbers[row - 1]) continue;
		const name = tools.find((tool) => tool.number === numbers[row])?.name;
		marks.push({time: times[row - 1], text: numbers[row] ? `T${numbers[row]}${name ? ` ${name}` : ''}` : 'no tool'});
	}
	return marks;
}

/** A block in parentheses, such as (M104 S205), is not the name of an operation. */
const CODE = /^([A-Z]\s*[-+]?\d*\.?\d+\s+)+[A-Z]\s*[-+]?\d*\.?\d+$/i;

/**
 * The text of a line that is only a comment, and not code in parentheses.
 * @param {string} line @returns {string|null}
 */
export function commentOf(line) {
	const text = line.trim().replace(/^N?\d+\s+/i, '');
	const match = /^\(([^()]*)\)$/.exec(text) || /^;+\s*(.*)$/.exec(text) || /^\*\s*-+\s*(.*)$/.exec(text);
	const words = match ? match[1].trim() : '';
	return /[a-z]/i.test(words) && !CODE.test(words) ? words : null;
}

/**
 * The first line of the last group of comments before a motion names the operation that follows.
 * @param {ReportPath} path
 * @param {import('./model.js').Source[]} sources
 * @returns {Mark[]}
 */
export function operations(path, sources) {
	/** @type {{line: number, text: string}[]} */
	const groups = [];
	for (const {first, lines} of sources[0]?.windows || []) {
		let inGroup = false;
		lines.forEach((line, i) => {
			const text = commentOf(line);
			if (text && !inGroup) groups.push({line: first + i, text});
			inGroup = text !== null;
		});
	}
	/** @type {Mark[]} */
	const marks = [];
	const times = path.levels.coarse[path.time], lines = path.levels.coarse[path.line], files = path.levels.coarse[path.file];
	let group = -1;
	for (let row = 1; row < lines.length && marks.length < MOST; row++) {
		if (files[row]) continue;
		const old = group;
		while (group + 1 < groups.length && groups[group + 1].line < lines[row]) group++;
		if (group !== old) marks.push({time: times[row - 1], text: groups[group].text});
	}
	return marks;
}
