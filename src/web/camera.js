// @ts-check
// camera.js - a camera that turns about a point: z is up.

import {add, cross, dot, norm, scale, sub, unit} from './vec.js';

/** @typedef {import('./model.js').Vec3} Vec3 */

const FIELD = 30 * Math.PI / 180;
/** Directions from the target to the eye: yaw and pitch in radians. @type {Object<string, [number, number]>} */
export const STANDARD_VIEWS = {
	front: [0, 0], right: [Math.PI / 2, 0], back: [Math.PI, 0], left: [-Math.PI / 2, 0],
	top: [0, Math.PI / 2], corner: [0.6, 0.45],
};

export class Camera {
	constructor() {
		/** @type {Vec3} */
		this.target = [0, 0, 0];
		this.yaw = STANDARD_VIEWS.corner[0];
		this.pitch = STANDARD_VIEWS.corner[1];
		this.distance = 1000;
	}

	/** Unit vector from the target to the eye; yaw 0 looks from the front, -y. @returns {Vec3} */
	back() {
		const c = Math.cos(this.pitch);
		return [Math.sin(this.yaw) * c, -Math.cos(this.yaw) * c, Math.sin(this.pitch)];
	}

	/** @returns {Vec3} */
	right() {
		return [Math.cos(this.yaw), Math.sin(this.yaw), 0];
	}

	/** @returns {Vec3} */
	up() {
		return cross(this.back(), this.right());
	}

	/** @returns {Vec3} */
	eye() {
		return add(this.target, scale(this.back(), this.distance));
	}

	/** @param {Vec3} direction from the target to the eye */
	lookFrom(direction) {
		const d = unit(direction);
		this.pitch = Math.asin(Math.max(-1, Math.min(1, d[2])));
		if (Math.hypot(d[0], d[1]) > 1e-6) this.yaw = Math.atan2(d[0], -d[1]);
	}

	/** @param {number} dx radians @param {number} dy */
	orbit(dx, dy) {
		this.yaw -= dx;
		this.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.pitch + dy));
	}

	/** @param {number} dx pixels @param {number} dy @param {number} height of the view in pixels */
	pan(dx, dy, height) {
		const mm = this.millimetres(height);
		this.target = add(this.target, add(scale(this.right(), -dx * mm), scale(this.up(), dy * mm)));
	}

	/** The number of mm per pixel at the target. @param {number} height of the view in pixels */
	millimetres(height) {
		return 2 * this.distance * Math.tan(FIELD / 2) / height;
	}

	/** @param {number} factor below 1: nearer */
	zoom(factor) {
		this.distance = Math.max(2, Math.min(1e6, this.distance * factor));
	}

	/** Makes a sphere visible. @param {Vec3} centre @param {number} radius @param {number} aspect width / height */
	fit(centre, radius, aspect) {
		this.target = centre;
		this.distance = radius / Math.sin(FIELD / 2) / Math.min(1, aspect);
	}

	/** World to eye. @returns {number[]} */
	view() {
		const r = this.right(), u = this.up(), b = this.back(), e = this.eye();
		return [r[0], u[0], b[0], 0, r[1], u[1], b[1], 0, r[2], u[2], b[2], 0, -dot(r, e), -dot(u, e), -dot(b, e), 1];
	}

	/**
	 * Eye to clip; everything within `size` of the target is visible.
	 * @param {number} aspect @param {number} size @returns {number[]}
	 */
	projection(aspect, size) {
		const f = 1 / Math.tan(FIELD / 2);
		const far = this.distance + size, near = Math.max(this.distance - size, far / 4000);
		return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
	}

	/** @param {Vec3} p @param {number} width @param {number} height @returns {Vec3} pixels, and the distance in front of the eye */
	project(p, width, height) {
		const d = sub(p, this.eye());
		const depth = -dot(d, this.back());
		const f = height / 2 / Math.tan(FIELD / 2) / (Math.abs(depth) || 1e-9);
		return [width / 2 + dot(d, this.right()) * f, height / 2 - dot(d, this.up()) * f, depth];
	}

	/** The ray through a pixel. @param {number} x @param {number} y @param {number} width @param {number} height */
	ray(x, y, width, height) {
		const mm = 2 * Math.tan(FIELD / 2) / height;
		const sideways = add(scale(this.right(), (x - width / 2) * mm), scale(this.up(), (height / 2 - y) * mm));
		return {origin: this.eye(), direction: unit(sub(sideways, this.back()))};
	}
}

/**
 * A camera between two others, 0 to 1; it rotates the short way.
 * @param {Camera} from @param {Camera} to @param {number} s @returns {Camera}
 */
export function between(from, to, s) {
	const camera = new Camera();
	const turn = Math.atan2(Math.sin(to.yaw - from.yaw), Math.cos(to.yaw - from.yaw));
	camera.yaw = from.yaw + turn * s;
	camera.pitch = from.pitch + (to.pitch - from.pitch) * s;
	camera.target = add(from.target, scale(sub(to.target, from.target), s));
	camera.distance = from.distance * (to.distance / from.distance) ** s;
	return camera;
}

/** A copy. @param {Camera} camera */
export const copyOf = (camera) => between(camera, camera, 0);

/** Is there a difference of more than a pixel? @param {Camera} a @param {Camera} b */
export const differs = (a, b) =>
	Math.abs(a.yaw - b.yaw) + Math.abs(a.pitch - b.pitch) + norm(sub(a.target, b.target)) / a.distance +
	Math.abs(a.distance / b.distance - 1) > 1e-4;
