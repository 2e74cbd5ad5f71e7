// @ts-check
// path.js - the path of a report: which pose at a time, which time for a line.

import {Levels, lowerBound} from './levels.js';

/** @typedef {import('./model.js').Pose} Pose */
/** @typedef {import('./levels.js').Columns} Columns */

/** Two times are one if they are nearer than this, s: half of what the report resolves. */
const SAME = 5e-6;

export class ReportPath {
	/** @param {Levels} levels @param {string[]} letters of the axes @param {number} end @param {number} checked */
	constructor(levels, letters, end, checked) {
		this.levels = levels;
		this.duration = end;
		this.checked = checked;
		this.axes = letters.map((letter) => levels.column(letter));
		[this.time, this.block, this.line, this.file, this.tool, this.motion] =
			['time', 'block', 'line', 'file', 'tool', 'class'].map((name) => levels.column(name));
	}

	/** @param {number} time @returns {Pose} */
	pose(time) {
		const {before, after, share} = this.levels.at(time);
		return {
			values: this.axes.map((axis) => before[axis] + (after[axis] - before[axis]) * share),
			block: after[this.block], line: after[this.line], file: after[this.file], tool: after[this.tool], motion: after[this.motion],
		};
	}

	/** @param {number} time */
	load(time) {
		return this.levels.missing(time);
	}

	/** The rows around a time: of the chunk where there is one. @param {number} time @returns {Promise<Columns>} */
	async rows(time) {
		const chunks = this.levels.around(time);
		return chunks.length ? this.levels.load(chunks[0]) : this.levels.coarse;
	}

	/** @param {number} time @param {number} by blocks @returns {Promise<number>} */
	async blockEnd(time, by) {
		for (let left = Math.abs(by); left > 0; left--) time = by > 0 ? await this.next(time) : await this.previous(time);
		return time;
	}

	/** Where the present block ends, or if that is now, where the next one does. @param {number} time */
	async next(time) {
		let at = time + SAME;
		for (;;) {
			const columns = await this.rows(at);
			const times = columns[this.time], blocks = columns[this.block];
			let row = lowerBound(times, at);
			if (row < times.length) {
				while (row + 1 < times.length && blocks[row + 1] === blocks[row]) row++;
				if (row + 1 < times.length) return times[row];
			}
			// The block goes on past these rows, or has not begun in them.
			const end = times[times.length - 1];
			if (end >= this.duration - SAME || end <= at) return Math.max(time, Math.min(end, this.duration));
			const beyond = await this.rows(end + 2 * SAME);
			if (row < times.length && beyond[this.block][lowerBound(beyond[this.time], end + 2 * SAME)] !== blocks[row]) return end;
			at = end + 2 * SAME;
		}
	}

	/** Where the block before the present one ended. @param {number} time */
	async previous(time) {
		let at = time;
		for (;;) {
			const columns = await this.rows(at);
			const times = columns[this.time], blocks = columns[this.block];
			let row = Math.min(lowerBound(times, at - SAME), times.length - 1);
			const block = blocks[row];
			while (row > 0 && (blocks[row] === block || times[row] > time - SAME)) row--;
			if (blocks[row] !== block && times[row] <= time - SAME) return times[row];
			if (times[0] <= SAME || times[0] >= at) return Math.min(times[0], time);
			at = times[0] - 2 * SAME;
		}
	}

	/** @param {number} file @param {number} line @returns {Promise<number>} -1: nothing moves up to there */
	async timeOf(file, line) {
		const row = this.search(this.levels.coarse, file, line);
		const times = this.levels.coarse[this.time];
		if (row < 0) return -1;
		// Finer rows lie between this coarse row and the next one.
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
