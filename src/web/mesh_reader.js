// @ts-check
// mesh_reader.js - a mesh out of its code: a walk from triangle to triangle (src/report/html/report_data.h, MESHES).

import {lowerBound, unzigzag} from './numbers.js';
import {BitModels, numberModels, RangeDecoder} from './range_decoder.js';

/** The triangle or vertex on the other side of an edge. */
const NONE = 0, NEW = 1, BEFORE = 2, AFTER = 3, OLD = 4, BEYOND = 5;
/** The order of the questions. */
const CHOICES = [NEW, BEFORE, AFTER, NONE];
const MEMORY_BITS = 14;

export class MeshReader {
	/** @param {Uint8Array} bytes @param {number} vertices @param {number} triangles */
	constructor(bytes, vertices, triangles) {
		this.bits = new RangeDecoder(bytes);
		this.points = new Int32Array(3 * vertices);
		this.corners = new Uint32Array(3 * triangles);
		this.vertices = vertices;
		this.seen = this.filled = 0;
		/** Edges, as numbers, where the walk may continue. @type {Set<number>} */
		this.open = new Set();
		this.before = new Int32Array(vertices).fill(-1);
		this.after = new Int32Array(vertices).fill(-1);
		/** @type {number[]} */
		this.gates = [];
		this.history = 0;
		this.memory = new Int32Array(4 << MEMORY_BITS);
		this.hashes = [0, 0];
		/** @type {number[][]} */
		this.values = [[], [], []];
		this.models = {
			begins: new BitModels(3), beyond: new BitModels(BEYOND * 4 * BEYOND ** 3), again: new BitModels(8), equal: new BitModels(108), known: new BitModels(12),
			back: numberModels(2),
			rank: numberModels(3), residual: numberModels(3),
		};
	}

	read() {
		while (this.filled < this.corners.length) {
			this.begin();
			while (this.gates.length) {
				const opposite = this.pop(), b = this.pop(), a = this.pop();
				if (this.open.has(this.edge(a, b))) this.lookBeyond(a, b, opposite);
			}
		}
		return this;
	}

	pop() {
		return /** @type {number} */ (this.gates.pop());
	}

	/** @param {number} from @param {number} to */
	edge(from, to) {
		return from * this.vertices + to;
	}

	begin() {
		const {bits, models} = this;
		/** @type {number[]} */
		const corners = [];
		for (let k = 0; k < 3; k++) {
			const follows = k ? corners[k - 1] : this.seen - 1;
			corners.push(bits.bit(models.begins, k) ? this.vertex(k, follows, k === 2 ? corners[0] : -1, -1) : this.seen - 1 - bits.number(models.back, 0));
		}
		this.take(corners[0], corners[1], corners[2]);
	}

	/** @param {number} a @param {number} b @param {number} opposite */
	lookBeyond(a, b, opposite) {
		const before = this.before[a], after = this.after[b];
		const hasBefore = before >= 0 && before !== b && this.open.has(this.edge(before, a));
		const hasAfter = after >= 0 && after !== a && this.open.has(this.edge(b, after));
		const beyond = this.beyond(hasBefore, hasAfter);
		if (beyond === NONE) this.open.delete(this.edge(a, b));
		else if (beyond === NEW) this.take(a, b, this.vertex(2, b, a, opposite));
		else this.take(a, b, beyond === BEFORE ? before : beyond === AFTER ? after : this.seen - 1 - this.bits.number(this.models.back, 1));
	}

	/** @param {boolean} hasBefore @param {boolean} hasAfter */
	beyond(hasBefore, hasAfter) {
		let beyond = OLD;
		for (const choice of CHOICES) {
			if (choice === BEFORE && !hasBefore || choice === AFTER && !hasAfter) continue;
			if (!this.bits.bit(this.models.beyond, (4 * choice + 2 * Number(hasBefore) + Number(hasAfter)) * BEYOND ** 3 + this.history)) continue;
			beyond = choice;
			break;
		}
		this.history = (BEYOND * this.history + beyond) % BEYOND ** 3;
		return beyond;
	}

	/** @param {number} a @param {number} b @param {number} c */
	take(a, b, c) {
		this.corners[this.filled++] = a;
		this.corners[this.filled++] = b;
		this.corners[this.filled++] = c;
		this.lie(a, b);
		this.lie(b, c);
		this.lie(c, a);
		this.gates.push(b, a, c, a, c, b, c, b, a);
	}

	/**
	 * A triangle has this edge: it closes the edge, or opens its other side.
	 * @param {number} from @param {number} to
	 */
	lie(from, to) {
		if (this.open.delete(this.edge(from, to))) return;
		this.open.add(this.edge(to, from));
		this.after[to] = from;
		this.before[from] = to;
	}

	/**
	 * A new vertex; -1 represents a missing neighbour.
	 * @param {number} corner @param {number} follows @param {number} other @param {number} opposite @returns {number}
	 */
	vertex(corner, follows, other, opposite) {
		const {bits, memory, points, hashes} = this;
		const at = 3 * this.seen, near = 3 * follows;
		const slot = 4 * (Math.imul(Math.imul(31, hashes[0]) + hashes[1] | 0, 0x9e3779b1) >>> 32 - MEMORY_BITS);
		const run = memory[slot + 3];
		if (bits.bit(this.models.again, run)) {
			for (let k = 0; k < 3; k++) points[at + k] = (near < 0 ? 0 : points[near + k]) + memory[slot + k];
			memory[slot + 3] = Math.min(run + 1, 7);
		} else {
			this.inFull(corner, follows, other, opposite);
			memory[slot + 3] = 1;
		}
		for (let k = 0; k < 3; k++) memory[slot + k] = points[at + k] - (near < 0 ? 0 : points[near + k]);
		hashes[1] = hashes[0];
		hashes[0] = Math.imul(memory[slot], 73856093) ^ Math.imul(memory[slot + 1], 19349663) ^ Math.imul(memory[slot + 2], 83492791);
		return this.seen++;
	}

	/** @param {number} corner @param {number} follows @param {number} other @param {number} opposite */
	inFull(corner, follows, other, opposite) {
		const {bits, points} = this, {equal: models} = this.models;
		let equal = 0;
		for (let k = 0; k < 3; k++) {
			const model = 36 * corner + 12 * k + 3 * equal;
			const a = follows < 0 ? 0 : points[3 * follows + k], b = other < 0 ? a : points[3 * other + k], c = opposite < 0 ? a : points[3 * opposite + k];
			// Ask for each value only once.
			let value = a, same = bits.bit(models, model);
			if (!same && b !== a) value = b, same = bits.bit(models, model + 1);
			if (!same && c !== a && c !== b) value = c, same = bits.bit(models, model + 2);
			points[3 * this.seen + k] = same ? value : this.value(corner, k, equal, opposite < 0 ? a : a + b - c);
			equal = 2 * equal + same & 3;
		}
	}

	/** A coordinate that no neighbour has. @param {number} corner @param {number} k @param {number} equal @param {number} guess */
	value(corner, k, equal, guess) {
		const values = this.values[k];
		if (this.bits.bit(this.models.known, 4 * k + equal)) return values[lowerBound(values, guess) + unzigzag(this.bits.number(this.models.rank, corner))];
		const value = guess + unzigzag(this.bits.number(this.models.residual, corner));
		values.splice(lowerBound(values, value), 0, value);
		return value;
	}
}
