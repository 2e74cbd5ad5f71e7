// @ts-check
// scene.js - draws bodies with WebGL 2. It knows no findings and no time: it is told what stands where, and how it looks.

import {featureEdges} from './edges.js';
import {identity, multiply} from './vec.js';
import {PLAIN, SURFACE, VERTEX} from './shaders.js';

/** @typedef {import('./model.js').Mesh} Mesh */
/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {import('./camera.js').Camera} Camera */

/**
 * @typedef {Object} Item
 * @property {number} body	index of the mesh
 * @property {number[]} matrix
 * @property {Vec3} colour	red, green, blue from 0 to 1
 * @property {boolean} ghost	to be seen through
 *
 * @typedef {Object} Extra	lines and planes beside the bodies
 * @property {Float32Array} positions
 * @property {number[]} [matrix]
 * @property {Vec3} colour
 * @property {'lines'|'plane'|'triangles'} kind
 *
 * @typedef {Object} Look
 * @property {Vec3} edge	colour of edges
 * @property {[number, number, number, number]|null} cut	n . x > offset is not drawn
 * @property {number} size	everything is within this of the camera's target
 */

export class Scene {
	/** @param {HTMLCanvasElement} canvas @param {Mesh[]} meshes */
	constructor(canvas, meshes) {
		const gl = canvas.getContext('webgl2', {antialias: true, alpha: true, preserveDrawingBuffer: true});
		if (!gl) throw new Error('no WebGL 2');
		this.canvas = canvas;
		this.gl = gl;
		this.meshes = meshes;
		this.surface = this.program(VERTEX, SURFACE);
		this.plain = this.program(VERTEX, PLAIN);
		/** Made when a body is first drawn. @type {(ReturnType<Scene['upload']>|undefined)[]} */
		this.buffers = [];
		this.extra = gl.createBuffer();
		canvas.addEventListener('webglcontextlost', (e) => e.preventDefault());
		canvas.addEventListener('webglcontextrestored', () => {
			this.restore();
			canvas.dispatchEvent(new Event('restored'));
		});
	}

	/** The graphics card has lost all data. */
	restore() {
		this.surface = this.program(VERTEX, SURFACE);
		this.plain = this.program(VERTEX, PLAIN);
		this.buffers = [];
		this.extra = this.gl.createBuffer();
	}

	/** @param {string} vertex @param {string} fragment */
	program(vertex, fragment) {
		const gl = this.gl;
		const program = /** @type {WebGLProgram} */ (gl.createProgram());
		for (const [type, text] of /** @type {[number, string][]} */ ([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]])) {
			const shader = /** @type {WebGLShader} */ (gl.createShader(type));
			gl.shaderSource(shader, text);
			gl.compileShader(shader);
			gl.attachShader(program, shader);
		}
		gl.bindAttribLocation(program, 0, 'position');
		gl.linkProgram(program);
		if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program) || 'shader');
		/** @type {Object<string, WebGLUniformLocation|null>} */
		const at = {};
		for (const name of ['model', 'camera', 'colour', 'cut', 'eye', 'alpha', 'grid']) at[name] = gl.getUniformLocation(program, name);
		return {program, at};
	}

	/** @param {Mesh} mesh */
	upload(mesh) {
		const gl = this.gl;
		const fill = (/** @type {number} */ target, /** @type {Float32Array|Uint32Array} */ data) => {
			const buffer = gl.createBuffer();
			gl.bindBuffer(target, buffer);
			gl.bufferData(target, data, gl.STATIC_DRAW);
			return buffer;
		};
		const edges = featureEdges(mesh);
		return {
			positions: fill(gl.ARRAY_BUFFER, mesh.positions),
			triangles: fill(gl.ELEMENT_ARRAY_BUFFER, mesh.indices),
			edges: fill(gl.ELEMENT_ARRAY_BUFFER, edges),
			edgeCount: edges.length,
		};
	}

	/** Follows the size of the canvas on the page. */
	resize() {
		const ratio = Math.min(devicePixelRatio || 1, 2);
		const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
		const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
		if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, {width, height});
	}

	/** @param {Camera} camera @param {Item[]} items @param {Extra[]} extras @param {Look} look */
	draw(camera, items, extras, look) {
		const gl = this.gl;
		this.resize();
		const {width, height} = this.canvas;
		gl.viewport(0, 0, width, height);
		gl.clearColor(0, 0, 0, 0);
		gl.depthMask(true);
		gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
		gl.enable(gl.DEPTH_TEST);
		gl.depthFunc(gl.LEQUAL);
		const toClip = multiply(camera.projection(width / height, look.size), camera.view());
		for (const {program, at} of [this.surface, this.plain]) {
			gl.useProgram(program);
			gl.uniformMatrix4fv(at.camera, false, toClip);
			gl.uniform4fv(at.cut, look.cut || [0, 0, 0, 1]);
			gl.uniform3fv(at.eye, camera.eye());
		}
		gl.disable(gl.BLEND);
		for (const item of items) if (!item.ghost) this.drawBody(item, look);
		gl.enable(gl.BLEND);
		gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
		gl.depthMask(false);
		for (const item of items) if (item.ghost) this.drawGhost(item, look);
		for (const extra of extras) this.drawExtra(extra);
	}

	/** @param {number} body */
	bind(body) {
		const gl = this.gl;
		const b = this.buffers[body] ||= this.upload(this.meshes[body]);
		gl.bindBuffer(gl.ARRAY_BUFFER, b.positions);
		gl.enableVertexAttribArray(0);
		gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
		return b;
	}

	/** @param {ReturnType<Scene['program']>} pen @param {number[]} matrix @param {Vec3} colour @param {number} alpha @param {number} grid */
	use(pen, matrix, colour, alpha, grid = 0) {
		const gl = this.gl;
		gl.useProgram(pen.program);
		gl.uniformMatrix4fv(pen.at.model, false, matrix);
		gl.uniform4f(pen.at.colour, colour[0], colour[1], colour[2], 1);
		gl.uniform1f(pen.at.alpha, alpha);
		if (pen.at.grid) gl.uniform1f(pen.at.grid, grid);
	}

	/** @param {Item} item @param {Look} look */
	drawBody(item, look) {
		const gl = this.gl;
		const b = this.bind(item.body);
		gl.enable(gl.POLYGON_OFFSET_FILL);
		gl.polygonOffset(1, 1);
		this.use(this.surface, item.matrix, item.colour, 1);
		gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, b.triangles);
		gl.drawElements(gl.TRIANGLES, this.meshes[item.body].indices.length, gl.UNSIGNED_INT, 0);
		gl.disable(gl.POLYGON_OFFSET_FILL);
		this.use(this.plain, item.matrix, look.edge, 1);
		gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, b.edges);
		gl.drawElements(gl.LINES, b.edgeCount, gl.UNSIGNED_INT, 0);
	}

	/** @param {Item} item @param {Look} look */
	drawGhost(item, look) {
		const gl = this.gl;
		const b = this.bind(item.body);
		this.use(this.plain, item.matrix, look.edge, 0.16);
		gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, b.edges);
		gl.drawElements(gl.LINES, b.edgeCount, gl.UNSIGNED_INT, 0);
	}

	/** @param {Extra} extra */
	drawExtra(extra) {
		const gl = this.gl;
		gl.bindBuffer(gl.ARRAY_BUFFER, this.extra);
		gl.bufferData(gl.ARRAY_BUFFER, extra.positions, gl.STREAM_DRAW);
		gl.enableVertexAttribArray(0);
		gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
		const plane = extra.kind === 'plane';
		this.use(this.plain, extra.matrix || identity(), extra.colour, plane ? 0.22 : 0.9, plane ? 5 : 0);
		if (extra.kind === 'triangles') {
			// They are in the surfaces that were drawn before.
			gl.enable(gl.POLYGON_OFFSET_FILL);
			gl.polygonOffset(-2, -4);
		}
		gl.drawArrays(extra.kind === 'lines' ? gl.LINES : gl.TRIANGLES, 0, extra.positions.length / 3);
		gl.disable(gl.POLYGON_OFFSET_FILL);
	}
}
