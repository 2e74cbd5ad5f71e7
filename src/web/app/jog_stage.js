// @ts-check
/**
 * jog_stage.js - the picture of a machine whose axes are moved by hand: bodies that meet are red, the nearest bodies
 * are named.
 */
import {Stage} from './viewer/stage.js';
import {add, norm, scale, sub, unit} from './viewer/vec.js';

/** @typedef {import('./fivecheck.js').Pose} Pose */
/** @typedef {import('./viewer/model.js').Vec3} Vec3 */

export class JogStage extends Stage {
	/** @param {import('./viewer/state.js').State} state */
	constructor(state) {
		super(state);
		this.trace = false;
		this.proof = false;
		/** @type {Pose | null} */
		this.known = null;
		/** Two links that are shown separately from all others, or none. @type {number[]} */
		this.links = [];
	}

	/** @param {Pose | null} pose */
	tell(pose) {
		this.known = pose;
		this.change();
	}

	/** The bodies with this name that are on the machine now. @param {string} name */
	body(name) {
		return this.model.bodies.findIndex((body, i) => body.name === name && this.placed.shown(i));
	}

	/** The bodies that meet, in the form of a finding of the viewer. @returns {any} */
	finding() {
		const met = this.known?.meets[0] ?? this.known?.near[0];
		return met ? {kind: 'collision', bodies: met.map((name) => this.body(name)), point: null, triangles: null} : null;
	}

	/** The plane half-way between the nearest bodies. */
	plane() {
		const nearest = this.known?.nearest;
		if (!this.proof || !nearest || this.finding())
			return null;
		const a = /** @type {Vec3} */ (nearest.on_a), b = /** @type {Vec3} */ (nearest.on_b), bodies = [this.body(nearest.a), this.body(nearest.b)];
		const sizes = bodies.map((body) => this.placed.sphere(body).radius);
		return {bodies: /** @type {[number, number]} */ (bodies), point: scale(add(a, b), 0.5), normal: unit(sub(b, a)),
			size: Math.max(20, 1.2 * Math.min(...sizes))};
	}

	/**
	 * The plane would be seen edge-on from a camera along it; slightly rotated, it is visible.
	 * @param {boolean} [atOnce]
	 */
	lookAtFocus(atOnce) {
		super.lookAtFocus(atOnce || this.proof);
		if (this.proof)
			this.by(() => this.camera.orbit(0.5, 0.2));
	}

	/** All bodies that meet, or else the nearest ones: these are never faint. */
	involved() {
		const pairs = [...this.known?.meets ?? [], ...this.known?.near ?? []], nearest = this.known?.nearest;
		return (pairs.length ? pairs.flat() : nearest ? [nearest.a, nearest.b] : []).map((name) => this.body(name)).filter((body) => body >= 0);
	}

	/** Bodies that hide the contact are made faint; the camera stays where the user has put it. */
	focus() {
		const bodies = this.involved(), finding = this.finding();
		this.xray = !!finding || this.proof;
		const smallest = bodies.map((body) => this.placed.sphere(body)).sort((p, q) => p.radius - q.radius)[0];
		const {centre, radius} = smallest ?? this.placed.around(this.placed.all()), nearest = this.known?.nearest;
		if (finding || !nearest)
			return {bodies, point: centre, radius};
		const on_a = /** @type {Vec3} */ (nearest.on_a), on_b = /** @type {Vec3} */ (nearest.on_b);
		return {bodies, point: scale(add(on_a, on_b), 0.5), radius: Math.max(radius, norm(sub(on_b, on_a)))};
	}

	/** The one of the two shown links to which a body of the machine is fixed. @param {number} body */
	linkOf(body) {
		const {role, link} = this.model.bodies[body];
		return role === 'machine' ? this.links.indexOf(link) : -1;
	}

	/**
	 * All bodies that meet are red, not only one pair.
	 * @param {number} body @param {any} finding @param {[number, number] | undefined} apart
	 */
	item(body, finding, apart) {
		if (this.links.length) {
			const side = this.linkOf(body);
			return super.item(body, null, side === 0 ? [body, -1] : side === 1 ? [-1, body] : [-1, -1]);
		}
		const meets = finding && this.involved().includes(body);
		return super.item(body, meets ? {...finding, bodies: [body, -1]} : finding, apart);
	}

	/**
	 * The shortest line between the nearest bodies, with its length.
	 * @param {any} finding @param {number} width @param {number} height
	 */
	annotate(finding, width, height) {
		super.annotate(this.links.length ? null : finding, width, height);
		if (this.links.length) {
			this.nameLinks(width, height);
			return;
		}
		const nearest = this.known?.nearest;
		if (!nearest || finding)
			return;
		const a = /** @type {Vec3} */ (nearest.on_a), b = /** @type {Vec3} */ (nearest.on_b);
		const [from, to] = [a, b].map((point) => this.camera.project(point, width, height));
		this.overlay.line('measure', from, to);
		this.overlay.dot('measure-end', from[0], from[1]);
		this.overlay.dot('measure-end', to[0], to[1]);
		this.overlay.label('measure-label', `${norm(sub(b, a)).toFixed(3)} mm`, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2 - 18);
	}

	/** The name of the largest body of each shown link. @param {number} width @param {number} height */
	nameLinks(width, height) {
		const largest = this.links.map((_, side) => this.placed.all().filter((body) => this.linkOf(body) === side)
			.sort((p, q) => this.placed.sphere(q).radius - this.placed.sphere(p).radius)[0]);
		largest.forEach((body, side) => body !== undefined && this.name(body, `proof-${'ab'[side]}`, width / 2, height / 2));
	}
}
