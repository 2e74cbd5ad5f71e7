// @ts-check
// levels.js - a long table at two levels: a coarse one at hand, and chunks that are unpacked when they are looked at.

import {lowerBound} from './numbers.js';
import {unpackTable} from './pack.js';

/** The number of unpacked chunks that are kept. */
const KEPT = 24;

/**
 * @typedef {Object} Chunk
 * @property {number} blob
 * @property {number} first
 * @property {number} rows
 * @property {number} from	s
 * @property {number} to
 *
 * @typedef {Object} TableHead
 * @property {string[]} columns
 * @property {number[]} scale
 * @property {number} rows
 * @property {{blob: number, rows: number}|null} coarse	null: the chunks are few, and all are there
 * @property {Chunk[]} chunks
 * @property {boolean} complete
 *
 * @typedef {Float64Array[]} Columns
 */

/** The rows of all parts, one after the other. @param {Columns[]} parts @returns {Columns} */
export function joinColumns(parts) {
	return parts[0].map((_, column) => {
		const all = new Float64Array(parts.reduce((sum, part) => sum + part[0].length, 0));
		let at = 0;
		for (const part of parts) {
			all.set(part[column], at);
			at += part[column].length;
		}
		return all;
	});
}

export class Levels {
	/** @param {TableHead} head @param {(blob: number) => Promise<Uint8Array>} fetchBlob @param {Columns} coarse */
	constructor(head, fetchBlob, coarse) {
		this.head = head;
		this.fetchBlob = fetchBlob;
		this.coarse = coarse;
		this.ends = Float64Array.from(head.chunks, (chunk) => chunk.to);
		/** In the order of use. @type {Map<number, Columns>} */
		this.ready = new Map();
		/** @type {Map<number, Promise<Columns>>} */
		this.coming = new Map();
	}

	/** @param {TableHead} head @param {(blob: number) => Promise<Uint8Array>} fetchBlob */
	static async open(head, fetchBlob) {
		const unpack = async (/** @type {{blob: number, rows: number}} */ {blob, rows}) => unpackTable(await fetchBlob(blob), rows, head.scale);
		if (head.coarse) return new Levels(head, fetchBlob, await unpack(head.coarse));
		// A short table has only its few chunks.
		return new Levels({...head, chunks: []}, fetchBlob, joinColumns(await Promise.all(head.chunks.map(unpack))));
	}

	/** @param {string} name */
	column(name) {
		return this.head.columns.indexOf(name);
	}

	/** The chunks with a row at or around a time: none, one or two neighbours. @param {number} time */
	around(time) {
		const {chunks} = this.head;
		const next = lowerBound(this.ends, time);
		const chunk = chunks[next];
		if (!chunk) return [];
		if (time > chunk.from) return [next];
		const before = chunks[next - 1];
		if (before && before.first + before.rows === chunk.first) return [next - 1, next];
		return time === chunk.from ? [next] : [];
	}

	/** @param {number} index of a chunk @returns {Promise<Columns>} */
	load(index) {
		const ready = this.ready.get(index);
		if (ready) return Promise.resolve(ready);
		let coming = this.coming.get(index);
		if (!coming) {
			const {blob, rows} = this.head.chunks[index];
			coming = this.fetchBlob(blob).then((bytes) => {
				const columns = unpackTable(bytes, rows, this.head.scale);
				this.coming.delete(index);
				this.ready.set(index, columns);
				for (const old of this.ready.keys()) if (this.ready.size > KEPT) this.ready.delete(old);
				return columns;
			});
			this.coming.set(index, coming);
		}
		return coming;
	}

	/** The data that at() still needs. @param {number} time @returns {Promise<unknown>|null} */
	missing(time) {
		const wanted = this.around(time).filter((index) => !this.ready.has(index));
		return wanted.length ? Promise.all(wanted.map((index) => this.load(index))) : null;
	}

	/**
	 * The two rows around a time: the first row at or after it, and the row before that one.
	 * @param {number} time @returns {{before: number[], after: number[], share: number}}
	 */
	at(time) {
		const times = this.column('time');
		const chunks = this.around(time).map((index) => this.ready.get(index));
		/** @type {number[]} */
		let before, after;
		if (chunks.length === 2 && chunks[0] && chunks[1] && time > chunks[0][times][chunks[0][times].length - 1]) {
			before = chunks[0].map((column) => column[column.length - 1]);
			after = chunks[1].map((column) => column[0]);
		} else {
			const columns = chunks[0] || this.coarse;
			const row = Math.min(lowerBound(columns[times], time), columns[times].length - 1);
			after = columns.map((column) => column[row]);
			before = columns.map((column) => column[Math.max(0, row - 1)]);
		}
		const span = after[times] - before[times];
		return {before, after, share: span > 0 ? Math.max(0, Math.min(1, (time - before[times]) / span)) : 1};
	}
}
