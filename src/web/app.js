// @ts-check
// app.js - puts the views on the page around one state.

import {hintBar, playButtons, readOut, viewButtons} from './controls.js';
import {h} from './elements.js';
import {FindingsView} from './findings.js';
import {headerView} from './header.js';
import {helpView, watchKeys} from './keyboard.js';
import {ProgramView} from './program_view.js';
import {Stage} from './stage.js';
import {State} from './state.js';
import {pairsView, setupView, statisticsView} from './tables.js';
import {Timeline} from './timeline.js';

/** @typedef {import('./model.js').Model} Model */

export class App {
	/** Throws an error without WebGL 2. @param {Model} model */
	constructor(model) {
		this.state = new State(model);
		this.stage = new Stage(this.state);
		this.timeline = new Timeline(this.state);
		this.program = new ProgramView(this.state);
		this.findings = new FindingsView(this.state);
		const help = helpView();
		this.stage.element.append(readOut(this.state), viewButtons(this.stage), hintBar(this.stage));
		this.element = h('div.app', {'data-verdict': model.verdict},
			headerView(model, () => help.showModal()), this.stage.element,
			h('div.transport', {}, playButtons(this.state), this.timeline.element),
			h('div.side', {}, this.findings.element, tabs([
				['Program', this.program.element], ['Pairs', () => pairsView(model)], ['Setup', () => setupView(model)], ['Numbers', () => statisticsView(model)],
			])), help);
		watchKeys(this.state, this.stage, help);
		this.acceptFiles();
	}

	/** A program dropped anywhere on the page. */
	acceptFiles() {
		this.element.addEventListener('dragover', (e) => e.preventDefault());
		this.element.addEventListener('drop', (e) => {
			e.preventDefault();
			const file = e.dataTransfer?.files[0];
			if (file) this.program.take(file);
		});
	}

	/** @param {HTMLElement} parent */
	show(parent) {
		parent.append(this.element);
		if (this.state.model.findings.length) this.state.showFinding(0);
		// After an error, show where the check ended.
		else this.state.seek(this.state.model.errors.length ? this.state.model.path.duration : 0);
		this.stage.lookAtFocus(true);
		this.state.watch((what) => {
			// For another finding the camera moves there.
			if (what === 'look') this.stage.lookAtFocus();
			if (what === 'read') document.getElementById('tab-0')?.click();
		});
	}
}

/**
 * Pages that are made when they are first opened.
 * @param {[string, HTMLElement|(() => HTMLElement)][]} pages made when they are first opened
 */
function tabs(pages) {
	const id = (/** @type {number} */ i) => `tab-${i}`;
	/** @type {HTMLElement[]} */
	const panels = pages.map((_, i) => h(i ? 'div.panel' : 'div.panel.flush', {role: 'tabpanel', id: `${id(i)}-panel`, 'aria-labelledby': id(i), tabindex: -1}));
	const buttons = pages.map(([name], i) => h('button', {role: 'tab', id: id(i), 'aria-controls': `${id(i)}-panel`, onclick: () => open(i)}, name));
	const open = (/** @type {number} */ index) => {
		const [, content] = pages[index];
		if (!panels[index].firstChild) panels[index].append(typeof content === 'function' ? content() : content);
		panels.forEach((panel, i) => {
			panel.hidden = i !== index;
			buttons[i].setAttribute('aria-selected', String(i === index));
			buttons[i].tabIndex = i === index ? 0 : -1;
		});
	};
	const bar = h('div.tabs', {role: 'tablist', onkeydown: (/** @type {KeyboardEvent} */ e) => {
		const by = e.key === 'ArrowRight' ? 1 : e.key === 'ArrowLeft' ? -1 : 0;
		if (!by) return;
		e.preventDefault();
		e.stopPropagation();
		const next = (buttons.indexOf(/** @type {HTMLElement} */ (e.target)) + by + buttons.length) % buttons.length;
		open(next);
		buttons[next].focus();
	}}, ...buttons);
	open(0);
	return h('div.pages', {}, bar, ...panels);
}
