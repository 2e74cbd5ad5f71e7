// @ts-check
// turned.js - the mesh of a body that is told by its outline (src/report/html/report_data.h, TURNED).

/** @typedef {import('./model.js').Mesh} Mesh */

const UNIT = 0.001;

/**
 * @param {{facets: number, profile: number[], x: number[], y: number[], z: number[], origin: number[]}} head
 * @returns {Mesh}
 */
export function turnedMesh({facets, profile, x, y, z, origin}) {
	const rings = profile.length / 2;
	/** @type {number[]} */
	const positions = [], indices = [];
	const add = (/** @type {number} */ u, /** @type {number} */ v, /** @type {number} */ w) => {
		for (let k = 0; k < 3; k++) positions.push(origin[k] + u * x[k] + v * y[k] + w * z[k]);
	};
	for (let ring = 0; ring < rings; ring++) {
		const r = profile[2 * ring] * UNIT, height = profile[2 * ring + 1] * UNIT;
		for (let k = 0; k < facets; k++) add(r * Math.cos(2 * Math.PI * k / facets), r * Math.sin(2 * Math.PI * k / facets), height);
	}
	const top = rings * facets, bottom = top + 1;
	add(0, 0, profile[1] * UNIT);
	add(0, 0, profile[2 * rings - 1] * UNIT);
	for (let k = 0; k < facets; k++) {
		const next = (k + 1) % facets, last = (rings - 1) * facets;
		indices.push(top, k, next, bottom, last + next, last + k);
		for (let lower = facets; lower < top; lower += facets) {
			indices.push(lower - facets + k, lower + k, lower + next, lower - facets + k, lower + next, lower - facets + next);
		}
	}
	return {positions: Float32Array.from(positions), indices: Uint32Array.from(indices)};
}
