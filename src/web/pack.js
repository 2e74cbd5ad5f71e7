// @ts-check
// pack.js - unpacks the data of a report: text, zlib streams, tables of whole numbers, meshes (src/report/html/report_data.h).

import {MeshReader} from './mesh_reader.js';
import {unzigzag} from './numbers.js';

/** @typedef {import('./model.js').Mesh} Mesh */

const RESERVED = [0, 13, 14, 15, 26, 27, 60, 127];

/** Text with seven bits per character (src/report/format/seven_bit.h). @param {string} text */
export function sevenBit(text) {
	const bytes = new Uint8Array(2 * text.length);
	let filled = 0, bits = 0, held = 0;
	const put = (/** @type {number} */ group) => {
		bits = bits << 7 | group;
		held += 7;
		if (held >= 8) bytes[filled++] = bits >> (held -= 8);
	};
	for (let i = 0; i < text.length; i++) {
		const code = text.charCodeAt(i);
		if (code < 0x100) put(code);
		else put(RESERVED[code < 0x500 ? code - 0x100 >> 7 : code - 0x500]);
		if (code >= 0x100 && code < 0x500) put(code & 127);
	}
	return bytes.slice(0, filled);
}

/** @param {Uint8Array} bytes a zlib stream @returns {Promise<Uint8Array>} */
export async function inflate(bytes) {
	const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
	return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Columns of second differences; each byte of the numbers has a separate plane.
 * @param {Uint8Array} bytes inflated
 * @param {number} rows
 * @param {number[]} scale of each column
 * @returns {Float64Array[]} by column
 */
export function unpackTable(bytes, rows, scale) {
	const head = new DataView(bytes.buffer, bytes.byteOffset);
	let at = 9 * scale.length;
	return scale.map((unit, column) => {
		const planes = head.getUint8(9 * column);
		const out = new Float64Array(rows);
		let value = head.getFloat64(9 * column + 1, true), delta = 0;
		if (rows) out[0] = value * unit;
		for (let row = 1; row < rows; row++) {
			let z = 0;
			for (let plane = planes - 1; plane >= 0; plane--) z = z * 256 + bytes[at + plane * (rows - 1) + row - 1];
			delta += unzigzag(z);
			value += delta;
			out[row] = value * unit;
		}
		at += planes * Math.max(0, rows - 1);
		return out;
	});
}

/**
 * @param {Uint8Array} bytes
 * @param {{vertices: number, triangles: number, origin: number[], step: number[]}} head
 * @returns {Mesh}
 */
export function unpackMesh(bytes, {vertices, triangles, origin, step}) {
	const {points, corners} = new MeshReader(bytes, vertices, triangles).read();
	return {positions: Float32Array.from(points, (q, i) => origin[i % 3] + step[i % 3] * q), indices: corners};
}
