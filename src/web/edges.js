// @ts-check
// edges.js - the edges of a mesh that a draughtsman would draw: borders, and where its faces meet at an angle.

/** @typedef {import('./model.js').Mesh} Mesh */

const SMOOTH = Math.cos(28 * Math.PI / 180);

/** @param {Mesh} mesh @returns {Uint32Array} two vertices for each edge */
export function featureEdges(mesh) {
	const {indices, positions} = mesh;
	const normals = faceNormals(mesh);
	let size = 16;
	while (size < indices.length * 2) size *= 2;
	// An open hash table of edges: its vertices and the first triangle, -2 after a second one.
	const low = new Int32Array(size).fill(-1), high = new Int32Array(size), face = new Int32Array(size);
	/** @type {number[]} */
	const out = [];
	for (let i = 0; i < indices.length; i++) {
		const t = i / 3 | 0;
		const u = indices[i], v = indices[i % 3 === 2 ? i - 2 : i + 1];
		const a = Math.min(u, v), b = Math.max(u, v);
		let slot = (Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b)) >>> 0 & size - 1;
		while (low[slot] >= 0 && (low[slot] !== a || high[slot] !== b)) slot = slot + 1 & size - 1;
		if (low[slot] < 0) {
			low[slot] = a;
			high[slot] = b;
			face[slot] = t;
		} else if (face[slot] >= 0) {
			const f = 3 * face[slot];
			const cos = normals[f] * normals[3 * t] + normals[f + 1] * normals[3 * t + 1] + normals[f + 2] * normals[3 * t + 2];
			if (cos < SMOOTH) out.push(a, b);
			face[slot] = -2;
		}
	}
	for (let slot = 0; slot < size; slot++) if (low[slot] >= 0 && face[slot] >= 0) out.push(low[slot], high[slot]);
	return positions.length ? Uint32Array.from(out) : new Uint32Array(0);
}

/** @param {Mesh} mesh @returns {Float32Array} a unit normal for each triangle */
function faceNormals({indices, positions: p}) {
	const normals = new Float32Array(indices.length);
	for (let i = 0; i < indices.length; i += 3) {
		const a = 3 * indices[i], b = 3 * indices[i + 1], c = 3 * indices[i + 2];
		const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
		const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
		const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
		const length = Math.hypot(x, y, z) || 1;
		normals[i] = x / length;
		normals[i + 1] = y / length;
		normals[i + 2] = z / length;
	}
	return normals;
}
