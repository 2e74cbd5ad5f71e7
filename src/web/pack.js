// @ts-check
// pack.js - unpacks the data of a report: zlib streams, tables of whole numbers, meshes (src/report/html/report_data.h).

/** @typedef {import('./model.js').Mesh} Mesh */

/** @param {string} text base64 of a zlib stream @returns {Promise<Uint8Array>} */
export async function inflate(text) {
	const packed = atob(text.trim());
	const bytes = new Uint8Array(packed.length);
	for (let i = 0; i < packed.length; i++) bytes[i] = packed.charCodeAt(i);
	const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
	return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {number} z @returns {number} 0, -1, 1, -2, 2 ... */
const unzigzag = (z) => z % 2 ? -(z + 1) / 2 : z / 2;

/**
 * Columns of second differences, each byte of the numbers in a plane of its own.
 *
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
 * Vertices as differences of 16 bits, corners as steps back among the vertices seen so far.
 *
 * @param {Uint8Array} bytes inflated
 * @param {{vertices: number, triangles: number, origin: number[], step: number[], index_bytes: number}} head
 * @returns {Mesh}
 */
export function unpackMesh(bytes, {vertices, triangles, origin, step, index_bytes: width}) {
	const positions = new Float32Array(3 * vertices);
	for (let k = 0; k < 3; k++) {
		const low = 2 * k * vertices, high = low + vertices;
		let q = 0;
		for (let i = 0; i < vertices; i++) {
			q = q + unzigzag(bytes[low + i] + 256 * bytes[high + i]) & 65535;
			positions[3 * i + k] = origin[k] + step[k] * q;
		}
	}
	const corners = 3 * triangles, first = 6 * vertices;
	const indices = new Uint32Array(corners);
	let seen = 0;
	for (let i = 0; i < corners; i++) {
		let code = 0;
		for (let plane = width - 1; plane >= 0; plane--) code = code * 256 + bytes[first + plane * corners + i];
		indices[i] = seen - code;
		if (!code) seen++;
	}
	return {positions, indices};
}
