// @ts-check
// program_view.js - the lines of the program, as many as fit: the running block is marked, a click leads to a block.

import {grouped, h} from './elements.js';

/** @typedef {import('./state.js').State} State */

const ROW = 22;
/** Browsers do not lay out taller elements: a longer list scrolls in proportion. */
const TALLEST = 8e6;

export class ProgramView {
	/** @param {State} state */
	constructor(state) {
		this.state = state;
		this.model = state.model;
		this.file = 0;
		this.rows = h('div.rows', {role: 'listbox', 'aria-label': 'Program'});
		this.space = h('div.space');
		this.list = h('div.code', {tabindex: 0, role: 'group', 'aria-label': 'Lines of the program; arrow keys go from block to block'}, this.space, this.rows);
		this.files = /** @type {HTMLSelectElement} */ (h('select', {'aria-label': 'File', onchange: () => this.open(this.files.selectedIndex)}));
		this.note = h('p.note', {role: 'status'});
		const picker = /** @type {HTMLInputElement} */ (h('input', {type: 'file', hidden: true, onchange: () => {
			if (picker.files?.[0]) this.take(picker.files[0]);
			picker.value = '';
		}}));
		this.opener = h('button', {hidden: true, onclick: () => picker.click()}, 'Open the program file');
		this.element = h('div.program', {}, h('div.program-head', {}, this.files, this.note, this.opener, picker), this.list);
		this.first = 0;
		/** Findings of a line. @type {Map<number, number>} */
		this.found = new Map();
		/** Lines with an error. @type {Set<number | null>} */
		this.faulty = new Set();
		this.listen();
		this.open(0);
	}

	listen() {
		this.list.addEventListener('scroll', () => this.scrolled());
		this.list.addEventListener('wheel', (e) => {
			// In a scaled list a notch of the wheel would skip hundreds of lines.
			if (this.scale() === 1) return;
			e.preventDefault();
			this.scrollTo(this.first + Math.sign(e.deltaY) * Math.max(1, Math.round(Math.abs(e.deltaY) / ROW)));
		}, {passive: false});
		this.rows.addEventListener('click', (e) => {
			const row = /** @type {HTMLElement} */ (e.target).closest('[data-line]');
			if (row instanceof HTMLElement) this.state.showLine(this.file, Number(row.dataset.line));
		});
		this.list.addEventListener('keydown', (e) => {
			const by = /** @type {Object<string, number>} */ ({ArrowDown: 1, ArrowUp: -1, PageDown: 20, PageUp: -20})[e.key];
			if (!by) return;
			e.preventDefault();
			e.stopPropagation();
			this.state.step(by);
		});
		new ResizeObserver(() => {
			if (!this.list.clientHeight) return;
			this.scrollTo(this.first);
			this.follow();
		}).observe(this.list);
		this.state.watch((what) => {
			if (what === 'time') this.follow();
			if (what === 'read') this.showRead();
		});
	}

	/** @param {number} file */
	open(file) {
		this.show(file);
		this.follow();
	}

	/** Shows another file from its first line on. @param {number} file */
	show(file) {
		this.file = file;
		this.first = 0;
		this.files.replaceChildren(...this.model.sources.map((source, i) => h('option', {selected: i === file}, source.name)));
		this.files.hidden = this.model.sources.length < 2;
		this.found.clear();
		this.model.findings.forEach((finding, i) => {
			if (finding.file === this.source()?.name && !this.found.has(finding.line)) this.found.set(finding.line, i);
		});
		this.faulty = new Set(this.model.errors.filter(({file: name, line}) => name === this.source()?.name && line).map(({line}) => line));
		this.space.style.height = `${Math.min(TALLEST, this.lines() * ROW)}px`;
		this.tellMissing();
	}

	/** A line that the user wants to read. */
	showRead() {
		const {file, line} = this.state.read;
		if (file !== this.file) this.show(file);
		this.scrollTo(line - 1 - (this.visible() >> 1));
	}

	source() {
		return this.model.sources[this.file];
	}

	lines() {
		return this.source()?.lines || 0;
	}

	scale() {
		return Math.max(1, this.lines() * ROW / TALLEST);
	}

	visible() {
		return Math.ceil(this.list.clientHeight / ROW) + 1;
	}

	tellMissing() {
		const source = this.source();
		const known = source ? source.windows.reduce((sum, window) => sum + window.lines.length, 0) : 0;
		const why = known ? 'This report has the lines around the findings.' : 'This report has no program text.';
		const missing = source && (known < source.lines || !known);
		this.note.textContent = missing ? `${why} Open the program file, or drop it on this page, to read all of it: its SHA-256 is compared.` : '';
		this.opener.hidden = !missing;
	}

	/** @param {number} line @returns {string|null} null: not at hand */
	text(line) {
		for (const {first, lines} of this.source().windows) if (line >= first && line < first + lines.length) return lines[line - first];
		return null;
	}

	scrolled() {
		if (this.moving) {
			this.moving = false;
			return;
		}
		const most = this.list.scrollHeight - this.list.clientHeight;
		const share = most > 0 ? this.list.scrollTop / most : 0;
		this.first = this.scale() === 1 ? Math.floor(this.list.scrollTop / ROW) : Math.round(share * Math.max(0, this.lines() - this.visible() + 2));
		this.draw();
	}

	/** @param {number} first index of the line at the top */
	scrollTo(first) {
		const last = Math.max(0, this.lines() - this.visible() + 2);
		this.first = Math.max(0, Math.min(last, first));
		const most = this.list.scrollHeight - this.list.clientHeight;
		const top = Math.round(this.scale() === 1 ? Math.min(most, this.first * ROW) : this.first / (last || 1) * most);
		this.moving = Math.abs(this.list.scrollTop - top) >= 1;
		this.list.scrollTop = top;
		this.draw();
	}

	/** Keeps the current block visible. */
	follow() {
		const {line, file, block} = this.state.pose;
		if (block && file !== this.file) {
			this.open(file);
			return;
		}
		const rows = this.visible() - 2;
		if (block && (line - 1 < this.first + 1 || line > this.first + rows - 1)) this.scrollTo(line - 1 - (rows >> 1));
		else this.draw();
	}

	draw() {
		const {line: now, file, block} = this.state.pose;
		const here = block && file === this.file ? now : 0;
		/** @type {HTMLElement[]} */
		const rows = [];
		for (let line = this.first + 1; line <= Math.min(this.lines(), this.first + this.visible()); line++) rows.push(this.row(line, line === here));
		this.rows.replaceChildren(...rows);
		this.rows.style.transform = `translateY(${this.scale() === 1 ? this.first * ROW : this.list.scrollTop}px)`;
		this.list.style.setProperty('--digits', String(Math.max(4, grouped(this.lines()).length)));
	}

	/** @param {number} line @param {boolean} here */
	row(line, here) {
		const text = this.text(line);
		const finding = this.found.get(line);
		const {read} = this.state;
		const calls = read.line === line && read.file === this.file;
		const kind = `${calls ? '.read' : ''}${here ? '.here' : ''}${finding === undefined ? '' : '.found'}${this.faulty.has(line) ? '.faulty' : ''}${text === null ? '.absent' : ''}`;
		return h(`div.row${kind}`, {role: 'option', 'data-line': line, 'aria-selected': String(here)},
			h('span.number', {}, grouped(line)), h('span.text', {}, text === null ? '\u00b7\u00b7\u00b7' : text));
	}

	/** A file that the user adds: it is used if its digest is that of a file of the report. @param {File} file */
	async take(file) {
		const bytes = await file.arrayBuffer();
		const digest = [...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes))].map((b) => b.toString(16).padStart(2, '0')).join('');
		const source = this.model.sources.find(({sha256}) => sha256 === digest);
		if (!source) {
			this.note.textContent = `${file.name} is not a program of this report: its SHA-256 differs.`;
			return false;
		}
		const lines = new TextDecoder().decode(bytes).replace(/\n$/, '').split('\n');
		source.windows = [{first: 1, lines}];
		source.lines = Math.max(source.lines, lines.length);
		this.open(this.model.sources.indexOf(source));
		this.note.textContent = `${file.name}: the digest is right, all lines are shown.`;
		return true;
	}
}
