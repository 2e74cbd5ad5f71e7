// @ts-check
// timeline.js - the clearance over the time of the program, with findings, tools and operations; drag to any moment.

import {duration, fixed, h} from './elements.js';
import {cssColour} from './palette.js';
import {leastOf, Pyramid} from './pyramid.js';

/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./model.js').Mark} Mark */
/** @typedef {import('./state.js').State} State */

const BAND = 15;

export class Timeline {
	/** @param {State} state */
	constructor(state) {
		this.state = state;
		this.model = state.model;
		this.pyramid = this.model.clearance ? new Pyramid(this.model.clearance) : null;
		this.from = 0;
		this.to = this.model.path.duration || 1;
		this.canvas = /** @type {HTMLCanvasElement} */ (h('canvas', {
			tabindex: 0, role: 'slider', 'aria-label': 'Time in the program', 'aria-valuemin': 0, 'aria-valuemax': fixed(this.model.path.duration, 3),
			onkeydown: (/** @type {KeyboardEvent} */ e) => this.key(e),
		}));
		this.tip = h('div.tip', {hidden: true, 'aria-hidden': 'true'});
		this.element = h('div.timeline', {}, this.canvas, this.tip);
		this.pointers();
		state.watch((what) => {
			if (what === 'time') this.change();
		});
		new ResizeObserver(() => this.change()).observe(this.canvas);
		matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.change());
	}

	pointers() {
		const {canvas, state} = this;
		const at = (/** @type {MouseEvent} */ e) => e.clientX - canvas.getBoundingClientRect().left;
		/** @type {Map<number, number>} */
		const down = new Map();
		canvas.addEventListener('pointerdown', (e) => {
			canvas.setPointerCapture(e.pointerId);
			down.set(e.pointerId, at(e));
			state.pause();
			state.stopAt = Infinity;
			if (down.size === 1) this.goTo(at(e));
		});
		canvas.addEventListener('pointermove', (e) => {
			this.hint(at(e));
			if (!down.has(e.pointerId)) return;
			if (down.size === 1) {
				this.goTo(at(e));
				down.set(e.pointerId, at(e));
				return;
			}
			const [a, b] = [...down.values()];
			down.set(e.pointerId, at(e));
			const [c, d] = [...down.values()];
			this.zoom((Math.abs(a - b) || 1) / (Math.abs(c - d) || 1), (c + d) / 2);
		});
		for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (e) => down.delete(/** @type {PointerEvent} */ (e).pointerId));
		canvas.addEventListener('pointerleave', () => {
			this.tip.hidden = true;
		});
		canvas.addEventListener('wheel', (e) => {
			e.preventDefault();
			if (e.shiftKey || Math.abs(e.deltaX) > Math.abs(e.deltaY)) this.slide((e.deltaX || e.deltaY) / this.width() * (this.to - this.from));
			else this.zoom(Math.exp(e.deltaY * 0.002), at(e));
		}, {passive: false});
		canvas.addEventListener('dblclick', () => this.zoom(Infinity, 0));
	}

	/** @param {KeyboardEvent} e */
	key(e) {
		const step = e.shiftKey ? 1 : 0.1;
		const {state} = this;
		if (e.key === 'ArrowLeft') state.seek(state.time - step);
		else if (e.key === 'ArrowRight') state.seek(state.time + step);
		else if (e.key === 'Home') state.seek(0);
		else if (e.key === 'End') state.seek(this.model.path.duration);
		else if (e.key === '+' || e.key === '-') this.zoom(e.key === '+' ? 0.5 : 2, this.x(state.time));
		else return;
		e.preventDefault();
		e.stopPropagation();
	}

	width() {
		return this.canvas.clientWidth || 1;
	}

	/** @param {number} time */
	x(time) {
		return (time - this.from) / (this.to - this.from) * this.width();
	}

	/** @param {number} x */
	time(x) {
		return this.from + x / this.width() * (this.to - this.from);
	}

	/** Goes to a time; a finding's mark within a few pixels selects the finding itself. @param {number} x */
	goTo(x) {
		const near = this.model.findings.findIndex((f) => Math.abs(this.x(f.time) - x) < 4);
		if (near >= 0) this.state.showFinding(near);
		else this.state.seek(this.time(Math.max(0, Math.min(this.width(), x))));
	}

	/** @param {number} factor above 1: shows more @param {number} x what stays in its place */
	zoom(factor, x) {
		const all = this.model.path.duration || 1;
		const span = Math.max(Math.min(0.05, all), Math.min(all, (this.to - this.from) * factor));
		const fixedTime = this.time(x);
		this.from = Math.max(0, Math.min(all - span, fixedTime - x / this.width() * span));
		this.to = this.from + span;
		this.change();
	}

	/** @param {number} by seconds */
	slide(by) {
		const span = this.to - this.from;
		this.from = Math.max(0, Math.min((this.model.path.duration || 1) - span, this.from + by));
		this.to = this.from + span;
		this.change();
	}

	/** @param {number} x */
	hint(x) {
		const time = this.time(x);
		const {clearance, pairs, bodies} = this.model;
		let text = duration(Math.max(0, time));
		if (clearance && time <= clearance.times[clearance.times.length - 1]) {
			const i = leastOf(clearance, time);
			if (i >= 0) {
				const pair = pairs[clearance.pair[i]];
				text += clearance.least[i] >= clearance.cap ? `: more than ${clearance.cap} mm` : `: at least ${clearance.least[i].toFixed(2)} mm`;
				if (pair && clearance.least[i] < clearance.cap) text += ` (${bodies[pair.a].name} - ${bodies[pair.b].name})`;
			}
		}
		this.tip.textContent = text;
		this.tip.hidden = false;
		this.tip.style.left = `${Math.max(0, Math.min(this.width() - this.tip.offsetWidth, x - this.tip.offsetWidth / 2))}px`;
	}

	change() {
		if (this.requested) return;
		this.requested = true;
		requestAnimationFrame(() => {
			this.requested = false;
			this.draw();
		});
	}

	draw() {
		const {canvas, state} = this;
		const ratio = Math.min(devicePixelRatio || 1, 3);
		const w = this.width(), tall = canvas.clientHeight || 1;
		canvas.width = Math.round(w * ratio);
		canvas.height = Math.round(tall * ratio);
		const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
		pen.scale(ratio, ratio);
		pen.font = '11px system-ui, sans-serif';
		pen.textBaseline = 'middle';
		// From 0 at the bottom to the cap at the top, between the bands of operations and tools.
		this.bands(pen, this.model.operations, 0, ['band', 'band-2']);
		this.bands(pen, this.model.tools, tall - BAND, ['tool-1', 'tool-2']);
		this.curve(pen, BAND + 3, tall - BAND - 3);
		this.unchecked(pen, tall);
		this.uncheckedName(pen, tall / 2, this.scaleNames(pen, BAND + 3, tall - BAND - 3));
		for (const finding of this.model.findings) {
			const x = this.x(finding.time);
			if (x < -6 || x > w + 6) continue;
			pen.fillStyle = cssColour(finding.accepted ? 'accepted' : 'bad');
			pen.fillRect(x - 1, BAND, 2, tall - 2 * BAND);
			pen.beginPath();
			pen.moveTo(x - 6, BAND);
			pen.lineTo(x + 6, BAND);
			pen.lineTo(x, BAND + 9);
			pen.fill();
		}
		const x = this.x(state.time);
		pen.fillStyle = cssColour('ink');
		pen.fillRect(x - 0.75, 0, 1.5, tall);
		canvas.setAttribute('aria-valuenow', fixed(state.time, 3));
		canvas.setAttribute('aria-valuetext', `${duration(state.time)} of ${duration(this.model.path.duration)}`);
	}

	/** @param {CanvasRenderingContext2D} pen @param {Mark[]} marks @param {number} y @param {[string, string]} colours */
	bands(pen, marks, y, colours) {
		marks.forEach((mark, i) => {
			const left = Math.max(0, this.x(mark.time)), right = Math.min(this.width(), this.x(marks[i + 1]?.time ?? this.model.path.duration));
			if (right <= left) return;
			pen.fillStyle = cssColour(colours[i % 2]);
			pen.fillRect(left, y, right - left, BAND);
			if (right - left < 24) return;
			pen.save();
			pen.beginPath();
			pen.rect(left, y, right - left - 3, BAND);
			pen.clip();
			pen.fillStyle = cssColour('band-ink');
			pen.fillText(mark.text, left + 5, y + BAND / 2 + 0.5);
			pen.restore();
		});
	}

	/** The part that was read, but not checked. @param {CanvasRenderingContext2D} pen @param {number} tall */
	unchecked(pen, tall) {
		const left = Math.max(0, this.x(this.model.path.checked)), right = this.width();
		if (this.model.path.checked >= this.model.path.duration - 1e-4 || left >= right) return;
		pen.save();
		pen.beginPath();
		pen.rect(left, BAND, right - left, tall - 2 * BAND);
		pen.clip();
		pen.strokeStyle = cssColour('unchecked');
		pen.lineWidth = 1;
		pen.beginPath();
		for (let x = left - tall; x < right; x += 9) {
			pen.moveTo(x, tall);
			pen.lineTo(x + tall, 0);
		}
		pen.stroke();
		pen.restore();
	}

	/**
	 * The name, if there is room for it.
	 * @param {CanvasRenderingContext2D} pen @param {number} y @param {number} free where the names of the scale end
	 */
	uncheckedName(pen, y, free) {
		const {checked, duration: end} = this.model.path;
		if (checked >= end - 1e-4) return;
		const left = Math.max(free, this.x(checked)) + 8;
		const text = ['not checked: the check ended at the first finding', 'not checked'].find((it) => left + pen.measureText(it).width < this.width() - 4);
		pen.fillStyle = cssColour('muted');
		if (text) pen.fillText(text, left, y);
	}

	/** @param {CanvasRenderingContext2D} pen @param {number} top @param {number} bottom */
	curve(pen, top, bottom) {
		const {clearance} = this.model;
		pen.fillStyle = cssColour('muted');
		if (!clearance || !this.pyramid) {
			pen.fillText('clearance not measured', 6, (top + bottom) / 2);
			return;
		}
		// The unchecked part has no clearance.
		const w = Math.min(this.width(), this.x(clearance.times[clearance.times.length - 1]));
		const y = (/** @type {number} */ mm) => bottom - (bottom - top) * Math.min(1, mm / clearance.cap);
		pen.fillStyle = cssColour('clearance-fill');
		pen.strokeStyle = cssColour('clearance');
		pen.lineWidth = 1.5;
		pen.beginPath();
		const fill = new Path2D();
		fill.moveTo(0, bottom);
		for (let x = 0; x <= w; x++) {
			const range = this.pyramid.range(this.time(x - 0.5), this.time(x + 0.5));
			if (!range) continue;
			pen.lineTo(x, y(range[1]));
			pen.lineTo(x, y(range[0]));
			fill.lineTo(x, y(range[0]));
		}
		fill.lineTo(w, bottom);
		pen.fill(fill);
		pen.stroke();
	}

	/**
	 * The meaning of the largest and the smallest height; returns where the text ends.
	 * @param {CanvasRenderingContext2D} pen @param {number} top @param {number} bottom
	 */
	scaleNames(pen, top, bottom) {
		const {clearance} = this.model;
		if (!clearance) return 0;
		const most = `${clearance.cap} mm or more`;
		pen.lineWidth = 3;
		pen.strokeStyle = cssColour('panel');
		pen.fillStyle = cssColour('muted');
		for (const [text, place] of /** @type {[string, number][]} */ ([[most, top + 8], ['0 mm clearance', bottom - 6]])) {
			pen.strokeText(text, 5, place);
			pen.fillText(text, 5, place);
		}
		return 5 + pen.measureText('0 mm clearance').width;
	}
}
