// @ts-check
// stage.js - the picture of the machine: the camera and its gestures, which body looks how, picking, section, measure.

import {between, Camera, copyOf, differs, STANDARD_VIEWS} from './camera.js';
import {h} from './elements.js';
import {watchGestures} from './gestures.js';
import {Overlay} from './overlay.js';
import {PlacedBodies} from './placed_bodies.js';
import {mix, sceneColour} from './palette.js';
import {planeAt, planeExtra} from './proof.js';
import {Scene} from './scene.js';
import {toolTrace, whereItWorks} from './tool_path.js';
import {add, dot, norm, place, placeBack, scale, sub, unit} from './vec.js';
import {bestDirection, inTheWay, normalOf} from './viewpoint.js';

/** @typedef {import('./model.js').Vec3} Vec3 */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./placed_bodies.js').Hit} Hit */

/** ms: the duration of a flight of the camera. */
const FLIGHT = 450;
/** s: a finding's colours are shown this long before and after it while the time runs. */
const NEAR = 0.05;

export class Stage {
	/** @param {State} state */
	constructor(state) {
		this.state = state;
		this.model = state.model;
		this.placed = new PlacedBodies(this.model);
		this.camera = new Camera();
		this.overlay = new Overlay();
		this.canvas = /** @type {HTMLCanvasElement} */ (h('canvas', {
			tabindex: 0, role: 'img', 'aria-label': 'The machine in 3-D. Arrow keys turn it, with Shift they move it, + and - zoom.',
		}));
		this.element = h('div.stage', {}, this.canvas, this.overlay.drawing, this.overlay.labels);
		this.scene = new Scene(this.canvas, this.model.bodies.map((body) => body.mesh));
		this.selected = -1;
		this.xray = true;
		this.proof = false;
		/** Without a hit, show the path of the tool. */
		this.trace = !this.model.findings.length;
		this.measuring = false;
		/** In the frame of a link, so that they move with it. @type {{link: number, point: Vec3}[]} */
		this.measure = [];
		/** @type {{axis: number, at: number, sign: number}|null} */
		this.section = null;
		/** @type {Set<number>} */
		this.ghosts = new Set();
		/** @type {(() => void)[]} */
		this.onselect = [];
		this.requested = false;
		/** Made when it is first shown. @type {import('./tool_path.js').Trace|null|undefined} */
		this.traced = undefined;
		this.listen();
		this.size = 1.2 * this.placed.around(this.placed.bodies.map((_, i) => i)).radius + 200;
	}

	listen() {
		this.state.watch((what) => {
			if (what !== 'playing') this.change();
		});
		new ResizeObserver(() => this.change()).observe(this.canvas);
		this.canvas.addEventListener('restored', () => this.change());
		matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.change());
		watchGestures(this.canvas, {
			turn: (dx, dy) => this.by(() => this.camera.orbit(dx * 0.008, dy * 0.008)),
			move: (dx, dy) => this.by(() => this.camera.pan(dx, dy, this.canvas.clientHeight)),
			zoom: (factor, x, y) => this.by(() => this.zoomAt(factor, x, y)),
			tap: (x, y) => this.tap(x, y),
			twice: (x, y) => {
				const hit = this.pick(x, y);
				if (hit) this.fly({target: hit.point, distance: this.camera.distance * 0.6});
			},
		});
		this.canvas.addEventListener('keydown', (e) => {
			const step = /** @type {Object<string, [number, number]>} */ ({ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]})[e.key];
			if (step) {
				this.by(() => e.shiftKey ? this.camera.pan(40 * step[0], 40 * step[1], this.canvas.clientHeight)
					: this.camera.orbit(0.1 * step[0], 0.1 * step[1]));
			} else if (e.key === '+' || e.key === '-') this.by(() => this.camera.zoom(e.key === '+' ? 0.85 : 1 / 0.85));
			else return;
			e.preventDefault();
			e.stopPropagation();
		});
	}

	/** Changes the camera by hand; this ends a flight. @param {() => void} change */
	by(change) {
		this.flight = null;
		change();
		this.change();
	}

	/** @param {number} factor @param {number} x @param {number} y */
	zoomAt(factor, x, y) {
		const mm = this.camera.millimetres(this.canvas.clientHeight) * (1 - factor);
		const dx = x - this.canvas.clientWidth / 2, dy = y - this.canvas.clientHeight / 2;
		this.camera.target = add(this.camera.target, add(scale(this.camera.right(), dx * mm), scale(this.camera.up(), -dy * mm)));
		this.camera.zoom(factor);
	}

	/** Draws again, once, before the next frame. */
	change() {
		if (this.requested) return;
		this.requested = true;
		requestAnimationFrame((now) => {
			this.requested = false;
			this.advance(now);
			this.draw();
		});
	}

	/** @param {number} now */
	advance(now) {
		if (!this.flight) return;
		this.flight.start ??= now;
		const s = Math.min(1, (now - this.flight.start) / FLIGHT);
		this.camera = between(this.flight.from, this.flight.to, s * s * (3 - 2 * s));
		if (s >= 1) this.flight = null;
		else this.change();
	}

	/** @param {Partial<Camera>} goal @param {boolean} [atOnce] */
	fly(goal, atOnce) {
		const to = Object.assign(copyOf(this.camera), goal);
		if (atOnce || matchMedia('(prefers-reduced-motion: reduce)').matches) this.camera = to;
		else if (differs(this.camera, to)) this.flight = {from: copyOf(this.camera), to, start: /** @type {number|undefined} */ (undefined)};
		this.change();
	}

	aspect() {
		return (this.canvas.clientWidth || 1) / (this.canvas.clientHeight || 1);
	}

	/** @param {string} name of STANDARD_VIEWS */
	standard(name) {
		const [yaw, pitch] = STANDARD_VIEWS[name];
		this.fly({yaw, pitch});
	}

	fit() {
		const goal = copyOf(this.camera);
		const {centre, radius} = this.placed.around(this.placed.all());
		goal.fit(centre, radius * 0.8, this.aspect());
		this.fly(goal);
	}

	/** The finding that is shown now. */
	finding() {
		const {time, finding, model} = this.state;
		if (finding >= 0) return model.findings[finding];
		return model.findings.find((f) => Math.abs(f.time - time) < NEAR) || null;
	}

	/** The plane that is shown. */
	plane() {
		return this.proof ? planeAt(this.model, this.state.time, this.placed) : null;
	}

	/**
	 * The bodies that are important now, and the point to look at.
	 * @returns {{bodies: number[], point: Vec3, radius: number}}
	 */
	focus() {
		const plane = this.plane();
		if (plane) return {bodies: plane.bodies, point: plane.point, radius: Math.max(0.05 * this.size, 2 * plane.size)};
		const finding = this.finding() || (this.state.stopAt < Infinity ? this.model.findings[this.state.lastFinding] : null);
		if (finding && finding.point) {
			const bodies = finding.bodies || [];
			const sizes = bodies.map((i) => this.placed.sphere(i).radius);
			return {bodies, point: finding.point, radius: Math.max(0.05 * this.size, Math.min(400, 2.5 * Math.min(...sizes)))};
		}
		const carried = finding ? this.placed.all().filter((body) => this.carriedBy(finding, body)) : [];
		if (carried.length) {
			const {centre, radius} = this.placed.around(carried);
			return {bodies: carried, point: centre, radius: radius * 1.6};
		}
		const role = (/** @type {string[]} */ roles) => this.placed.all().filter((i) => roles.includes(this.placed.bodies[i].role));
		const tool = role(['cutter', 'shank', 'holder']), work = role(['part', 'stock', 'fixture']);
		const bodies = [...tool, ...work];
		const {centre, radius} = this.placed.around(work.length ? work : bodies.length ? bodies : this.placed.all());
		return {bodies, point: tool.length ? this.placed.sphere(tool[tool.length - 1]).centre : centre, radius: Math.max(30, radius * 1.6)};
	}

	/** Moves the camera to a view of the contact, or of the work. @param {boolean} [atOnce] */
	lookAtFocus(atOnce) {
		this.place();
		const finding = this.finding();
		const goal = copyOf(this.camera);
		const {bodies, point, radius} = this.focus();
		const plane = this.plane();
		if (plane || (finding?.point && bodies.length === 2)) {
			goal.lookFrom(bestDirection(this.placed, point, bodies, plane ? plane.normal : normalOf(finding?.triangles?.[0])));
			goal.fit(point, radius, this.aspect());
		} else {
			[goal.yaw, goal.pitch] = STANDARD_VIEWS.corner;
			const work = this.workArea() ?? this.placed.around(bodies.length ? bodies : this.placed.all());
			// A small tool without a part would fill the view, and show nothing useful.
			goal.fit(work.centre, Math.max(work.radius, 0.1 * this.size), this.aspect());
		}
		this.fly(goal, atOnce);
	}

	/** Without a finding: around the path of the tool. */
	workArea() {
		const trace = this.model.findings.length ? null : this.way();
		if (!trace) return null;
		const {centre, radius} = whereItWorks(trace);
		return {centre: place(this.placed.links[trace.link], centre), radius: 1.3 * radius};
	}

	place() {
		const {pose} = this.state;
		this.placed.moveTo(pose.values, pose.tool);
	}

	/** @param {number} x @param {number} y */
	pick(x, y) {
		const {origin, direction} = this.camera.ray(x, y, this.canvas.clientWidth, this.canvas.clientHeight);
		const solid = this.placed.all().filter((body) => !this.ghosts.has(body));
		const cut = this.cut();
		if (!cut) return this.placed.hit(origin, direction, 1e6, solid);
		// Begin where the ray enters the remaining part of the section.
		const n = /** @type {Vec3} */ (cut.slice(0, 3));
		const above = dot(n, origin) - cut[3], falling = -dot(n, direction);
		const skip = above > 0 ? (falling > 0 ? above / falling : 1e6) : 0;
		return this.placed.hit(add(origin, scale(direction, skip)), direction, 1e6, solid);
	}

	/** @param {number} x @param {number} y */
	tap(x, y) {
		const hit = this.pick(x, y);
		if (this.measuring) {
			if (!hit) return;
			if (this.measure.length === 2) this.measure = [];
			const link = this.placed.bodies[hit.body].link;
			this.measure.push({link, point: placeBack(this.placed.links[link], this.snap(hit))});
		} else this.select(hit ? hit.body : -1);
		this.change();
		for (const listener of this.onselect) listener();
	}

	/**
	 * The corner of the triangle that was hit if it is within a few pixels, else the point.
	 * @param {Hit} hit @returns {Vec3}
	 */
	snap(hit) {
		const {indices, positions} = this.placed.bodies[hit.body].mesh;
		const w = this.canvas.clientWidth, tall = this.canvas.clientHeight;
		const seen = this.camera.project(hit.point, w, tall);
		for (let k = 0; k < 3; k++) {
			const v = 3 * indices[3 * hit.triangle + k];
			const corner = place(this.placed.matrix(hit.body), [positions[v], positions[v + 1], positions[v + 2]]);
			const at = this.camera.project(corner, w, tall);
			if (Math.hypot(at[0] - seen[0], at[1] - seen[1]) < 9) return corner;
		}
		return hit.point;
	}

	/** @param {number} body -1: none */
	select(body) {
		this.selected = body;
		this.change();
		for (const listener of this.onselect) listener();
	}

	/** @param {'hide'|'isolate'|'all'} what */
	showBodies(what) {
		const {hidden, bodies} = this.placed;
		if (what === 'all') hidden.clear();
		else if (this.selected < 0) return;
		else if (what === 'hide') hidden.add(this.selected);
		else bodies.forEach((_, i) => i === this.selected ? hidden.delete(i) : hidden.add(i));
		this.select(-1);
	}

	/** The part with n . x <= offset is kept. @returns {[number, number, number, number]|null} */
	cut() {
		if (!this.section) return null;
		const {axis, at, sign} = this.section;
		/** @type {[number, number, number, number]} */
		const cut = [0, 0, 0, sign * at];
		cut[axis] = sign;
		return cut;
	}

	/** The range of the section's position: the extent of the bodies. @param {number} axis */
	extent(axis) {
		const {centre, radius} = this.placed.around(this.placed.all());
		return {min: centre[axis] - radius, max: centre[axis] + radius};
	}

	/**
	 * Does the axis that exceeds its travel carry the body?
	 * @param {import('./model.js').Finding} finding @param {number} body
	 */
	carriedBy(finding, body) {
		const axis = this.model.axes.findIndex(({letter}) => letter === finding.axis);
		return finding.kind === 'limit' && this.placed.bodies[body].link === axis + 1;
	}

	/** @param {number} body @param {import('./model.js').Finding|null} finding @param {[number, number]|undefined} apart by the plane @returns {import('./scene.js').Item} */
	item(body, finding, apart) {
		const {role, link} = this.placed.bodies[body];
		const side = finding?.bodies ? ['a', 'b'][finding.bodies.indexOf(body)] : finding && this.carriedBy(finding, body) ? 'a' : null;
		const known = ['part', 'fixture', 'holder', 'shank', 'cutter'].includes(role);
		const colour = sceneColour(body === this.selected ? 'selected' : side ? `contact-${side}` : known ? role : link ? 'moving' : 'base');
		const proved = apart?.includes(body);
		if (proved) return {body, matrix: this.placed.matrix(body), colour: sceneColour(apart?.[0] === body ? 'proof-a' : 'proof-b'), ghost: false};
		const faint = (finding || apart) && !side && body !== this.selected;
		return {body, matrix: this.placed.matrix(body), colour: faint ? mix(colour, sceneColour('faint'), 0.5) : colour, ghost: this.ghosts.has(body)};
	}

	draw() {
		this.place();
		const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
		if (!width || !height) return;
		const finding = this.finding();
		const focus = this.focus(), plane = this.plane();
		this.ghosts = this.xray ? inTheWay(this.placed, this.camera.eye(), focus.point, focus.radius * 0.25, focus.bodies) : new Set();
		this.ghosts.delete(this.selected);
		const items = this.placed.all().map((body) => this.item(body, finding, plane?.bodies));
		const extras = plane ? [planeExtra(plane, sceneColour('plane'))] : [];
		if (this.trace) extras.push(...this.traceLines());
		// The triangles are at these places only at the finding.
		if (this.state.finding >= 0 && finding?.triangles) {
			extras.push({kind: 'triangles', positions: Float32Array.from(finding.triangles.flat(2)), colour: sceneColour('mark')});
		}
		this.scene.draw(this.camera, items, extras,
			{edge: sceneColour('edge'), cut: this.cut(), size: this.size + norm(sub(this.camera.target, focus.point))});
		this.annotate(plane ? null : finding, width, height);
		if (plane) {
			const [x, y] = this.camera.project(plane.point, width, height);
			this.name(plane.bodies[0], 'proof-a', x, y);
			this.name(plane.bodies[1], 'proof-b', x, y);
		}
	}

	/** The path of the tool. */
	way() {
		return this.traced === undefined ? this.traced = toolTrace(this.model) : this.traced;
	}

	/** @returns {import('./scene.js').Extra[]} */
	traceLines() {
		const trace = this.way();
		if (!trace) return [];
		const matrix = this.placed.links[trace.link];
		return [
			{kind: 'lines', positions: trace.rapid, matrix, colour: sceneColour('rapid')},
			{kind: 'lines', positions: trace.feed, matrix, colour: sceneColour('feed')},
		];
	}

	/** @param {import('./model.js').Finding|null} finding @param {number} width @param {number} height */
	annotate(finding, width, height) {
		this.overlay.clear(width, height);
		this.overlay.triad(this.camera);
		const see = (/** @type {Vec3} */ p) => this.camera.project(p, width, height);
		if (finding && finding.point) {
			const [x, y, depth] = see(finding.point);
			if (depth > 0) {
				if (finding.bodies) {
					this.name(finding.bodies[0], 'a', x, y);
					this.name(finding.bodies[1], 'b', x, y);
				}
				this.overlay.ring(x, y);
			}
		}
		const ends = this.measure.map(({link, point}) => place(this.placed.links[link], point));
		const seen = ends.map(see);
		seen.forEach(([x, y]) => this.overlay.dot('measure-end', x, y));
		if (ends.length === 2) {
			this.overlay.line('measure', seen[0], seen[1]);
			const d = sub(ends[1], ends[0]);
			const parts = d.map((v, k) => `${'XYZ'[k]} ${Math.abs(v).toFixed(2)}`).join('  ');
			this.overlay.label('measure-label', `${norm(d).toFixed(2)} mm   (${parts})`, (seen[0][0] + seen[1][0]) / 2, (seen[0][1] + seen[1][1]) / 2 - 18);
		}
	}

	/**
	 * The name of a body in contact, with a line to a visible place of the body.
	 * @param {number} body @param {'a'|'b'|'proof-a'|'proof-b'} side @param {number} x of the ring @param {number} y
	 */
	name(body, side, x, y) {
		const {width, height} = this.overlay;
		const anchor = this.anchor(body, x, y, width, height);
		if (!anchor) return;
		const length = Math.hypot(anchor[0] - x, anchor[1] - y) || 1;
		const out = Math.min(90, width * 0.17);
		const right = anchor[0] > x || (anchor[0] === x && side.endsWith('b'));
		const to = [anchor[0] + (right ? out : -out), anchor[1] + (anchor[1] - y) / length * 30];
		// The label may be elsewhere, to stay within the picture; the line ends at it.
		const {left, top, right: end, bottom} = this.overlay.label(`name-${side}`, this.placed.bodies[body].name, to[0], to[1]);
		this.overlay.line(`leader leader-${side}`, anchor, [(left + end) / 2, (top + bottom) / 2]);
		this.overlay.dot('anchor', anchor[0], anchor[1], 3.5);
	}

	/**
	 * A visible place of a body, beside the ring: among some of its vertices.
	 * @param {number} body @param {number} x @param {number} y @param {number} width @param {number} height
	 */
	anchor(body, x, y, width, height) {
		const {positions} = this.placed.bodies[body].mesh;
		const eye = this.camera.eye(), wanted = Math.min(110, width * 0.2);
		const step = 3 * Math.max(1, Math.floor(positions.length / 3 / 250));
		/** @type {{at: Vec3, seen: Vec3, cost: number}[]} */
		const beside = [];
		/** For a small body, all of which may be within the ring. */
		const within = /** @type {typeof beside} */ ([]);
		for (let v = 0; v < positions.length; v += step) {
			const at = place(this.placed.matrix(body), [positions[v], positions[v + 1], positions[v + 2]]);
			const seen = this.camera.project(at, width, height);
			const away = Math.hypot(seen[0] - x, seen[1] - y);
			if (seen[2] <= 0 || seen[0] < 20 || seen[0] > width - 20 || seen[1] < 40 || seen[1] > height - 40) continue;
			(away < 36 ? within : beside).push({at, seen, cost: Math.abs(away - wanted)});
		}
		const solid = this.placed.all().filter((other) => !this.ghosts.has(other));
		for (const found of [beside, within]) {
			found.sort((p, q) => p.cost - q.cost);
			for (const {at, seen} of found.slice(0, 40)) {
				const to = sub(at, eye);
				const hit = this.placed.hit(eye, unit(to), norm(to) + 1, solid);
				if (hit && hit.body === body && hit.distance > norm(to) - 2) return seen;
			}
		}
		return null;
	}
}
