// @ts-check
// path.js - the path of a report: which pose at a time, which time for a line.

import {Levels} from './levels.js';
import {lowerBound} from './numbers.js';

/** @typedef {import('./model.js').Pose} Pose */
/** @typedef {import('./levels.js').Columns} Columns */

/** s: two times are equal if they differ by less; this is half of the report's resolution. */
const SAME = 5e-6;

export class ReportPath {
	/** @param {Levels} levels @param {string[]} letters of the axes @param {number} end @param {number} checked @param {import('./model.js').Modes[]} modes */
	constructor(levels, letters, end, checked, modes) {
		this.levels = levels;
		this.duration = end;
		this.checked = checked;
		this.axes = letters.map((letter) => levels.column(letter));
		this.time = levels.column('time');
		this.block = levels.column('block');
		this.line = levels.column('line');
		this.file = levels.column('file');
		this.tool = levels.column('tool');
		this.motion = levels.column('class');
		this.mode = levels.column('modes');
		this.feed = levels.column('feed');
		this.modes = modes;
	}

	/** @param {number} time @returns {Pose} */
	pose(time) {
		const {before, after, share} = this.levels.at(time);
		return {
			values: this.axes.map((axis) => before[axis] + (after[axis] - before[axis]) * share),
			block: after[this.block], line: after[this.line], file: after[this.file], tool: after[this.tool], motion: after[this.motion],
			feed: after[this.feed], modes: this.modes[after[this.mode]] ?? null,
		};
	}

	/** Times of rows. @param {number} most @returns {number[]} */
	instants(most) {
		const chunks = [...this.levels.ready.values()];
		const whole = this.levels.head.complete && chunks.length === this.levels.head.chunks.length && this.levels.head.rows <= most;
		const times = whole && chunks.length ? chunks.flatMap((columns) => [...columns[this.time]]) : [...this.levels.coarse[this.time]];
		return times.sort((a, b) => a - b);
	}

	/** @param {number} time */
	load(time) {
		return this.levels.missing(time);
	}

	/**
	 * Rows around a time; between two chunks those of the requested side.
	 * @param {number} time @param {'before'|'after'} side @returns {Promise<Columns>}
	 */
	async rows(time, side) {
		const chunks = this.levels.around(time);
		return chunks.length ? this.levels.load(side === 'after' ? chunks[chunks.length - 1] : chunks[0]) : this.levels.coarse;
	}

	/** @param {number} time @param {number} by blocks @returns {Promise<number>} */
	async blockEnd(time, by) {
		for (let left = Math.abs(by); left > 0; left--) time = by > 0 ? await this.next(time) : await this.previous(time);
		return time;
	}

	/** The end of the current block; at its end, that of the next one. @param {number} time */
	async next(time) {
		let end = time, block = -1;
		while (end < this.duration - SAME) {
			const columns = await this.rows(end + SAME, 'after');
			const times = columns[this.time], blocks = columns[this.block];
			let row = lowerBound(times, end + SAME);
			if (row === times.length || (block >= 0 && blocks[row] !== block)) break;
			block = blocks[row];
			while (row + 1 < times.length && blocks[row + 1] === block) row++;
			end = times[row];
			if (row + 1 < times.length) break;
		}
		return Math.min(end, this.duration);
	}

	/** The end of the block before the current one. @param {number} time */
	async previous(time) {
		let columns = await this.rows(time - SAME, 'after');
		let row = Math.min(lowerBound(columns[this.time], time - SAME), columns[this.time].length - 1);
		const block = columns[this.block][row];
		for (;;) {
			const times = columns[this.time], blocks = columns[this.block];
			while (row >= 0 && (blocks[row] === block || times[row] > time - SAME)) row--;
			if (row >= 0) return times[row];
			const first = times[0];
			columns = await this.rows(first - SAME, 'before');
			row = lowerBound(columns[this.time], first - SAME) - 1;
			if (row < 0) return Math.min(first, time);
		}
	}

	/** @param {number} file @param {number} line @returns {Promise<number>} -1: nothing moves up to there */
	async timeOf(file, line) {
		const row = this.search(this.levels.coarse, file, line);
		const times = this.levels.coarse[this.time];
		if (row < 0) return -1;
		// There are finer rows between this coarse row and the next one.
		let best = times[row];
		const until = times[Math.min(row + 1, times.length - 1)];
		for (let i = 0; i < this.levels.head.chunks.length; i++) {
			const chunk = this.levels.head.chunks[i];
			if (chunk.to < times[Math.max(0, row - 1)] || chunk.from > until) continue;
			const columns = await this.levels.load(i);
			const fine = this.search(columns, file, line);
			if (fine < 0) continue;
			best = columns[this.time][fine];
			if (columns[this.line][fine] === line) return best;
		}
		return best;
	}

	/** The last row of the first block of a line, else the last row before the first one past the line. @param {Columns} columns @param {number} file @param {number} line */
	search(columns, file, line) {
		const lines = columns[this.line], files = columns[this.file], blocks = columns[this.block];
		let before = -1;
		for (let row = 0; row < lines.length; row++) {
			if (files[row] !== file || !blocks[row]) continue;
			if (lines[row] === line) {
				while (row + 1 < lines.length && blocks[row + 1] === blocks[row]) row++;
				return row;
			}
			if (lines[row] < line && (before < 0 || lines[row] >= lines[before])) before = row;
		}
		return before;
	}
}
