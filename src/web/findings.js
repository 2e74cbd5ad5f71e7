// @ts-check
// findings.js - the findings as cards: what meets what, in which block, where the axes stand.

import {duration, fixed, grouped, h} from './elements.js';

/** @typedef {import('./model.js').Finding} Finding */
/** @typedef {import('./model.js').Model} Model */
/** @typedef {import('./state.js').State} State */

/** @type {Object<string, string>} */
const KINDS = {
	collision: 'Collision', clearance: 'Too little clearance', limit: 'Axis limit', 'start-overlap': 'Overlap at the start',
	'rapid-contact': 'Contact while not cutting', gouge: 'Gouge',
};
/** s: times are rounded; this long before the end of a block it is still the current block. */
const BEFORE_END = 2e-5;
/** The number of cards that are made at once; the rest on request. */
const FIRST_CARDS = 50;

/** @type {Object<string, string>} */
const VERBS = {clearance: 'comes too near to', 'start-overlap': 'overlaps', 'rapid-contact': 'enters', gouge: 'cuts too deep into'};

/**
 * The bodies with their sides, the acting one first: the cutter, which the check names last.
 * @param {Finding} finding @returns {{name: string, side: string}[]}
 */
function actors({kind, a, b}) {
	const both = [{name: a ?? '', side: 'a'}, {name: b ?? '', side: 'b'}];
	return kind === 'gouge' || kind === 'rapid-contact' ? both.reverse() : both;
}

/** @param {Finding} finding */
const verbOf = ({kind}) => VERBS[kind] || 'meets';

/** @param {Finding} finding what meets what, in a few words */
export function findingTitle(finding) {
	if (finding.kind === 'limit') return `${finding.axis} ${finding.path_tolerance ? 'may leave' : 'leaves'} its travel`;
	return actors(finding).map(({name}) => name).join(` ${verbOf(finding)} `);
}

/** @param {Finding} finding */
export const kindName = (finding) => KINDS[finding.kind] || finding.kind;

/** The value of an axis as on a control: mm and degrees. @param {number} value */
export const axisValue = (value) => fixed(value, 3);

/** A length of the setup, as written there. @param {number} mm */
const shortest = (mm) => String(Number(mm.toFixed(6)));

/** The axes that move in the block of a finding. @param {Model} model @param {Finding} finding */
async function movesOf(model, finding) {
	const {path, axes} = model;
	const loading = path.load(finding.time);
	if (loading) await loading;
	const start = await path.blockEnd(finding.time, -1), end = await path.blockEnd(finding.time, 1);
	await Promise.all([path.load(start), path.load(end)]);
	const from = path.pose(start).values, to = path.pose(end).values;
	const all = model.readOut.map((letter) => axes.findIndex((axis) => axis.letter === letter)).map((i) => ({axis: axes[i], from: from[i], to: to[i]}));
	return all.filter((move) => Math.abs(move.to - move.from) > 0.0015);
}

/**
 * Suggestions that may help; they are not proved.
 * @param {Model} model @param {Finding} finding @param {{axis: import('./model.js').Axis}[]} moves
 */
function advice({bodies}, finding, moves) {
	const roles = (finding.bodies || []).map((i) => bodies[i].role);
	const turning = moves.filter(({axis}) => axis.rotary).map(({axis}) => axis.letter).join(' and ');
	const before = turning ? `before ${turning} ${turning.length > 1 ? 'turn' : 'turns'}` : 'before this block';
	if (finding.kind === 'limit') return 'shift the work offset or the part, or change the tool length, so that the axis stays within its travel.';
	if (finding.kind === 'start-overlap') return 'look at the setup: something stands in something else before anything moves.';
	if (finding.kind === 'gouge') return 'compare the cutter in the setup with the tool table, then the work offset; if both are right, the program leads the cutter too deep.';
	if (finding.kind === 'rapid-contact') return `retract the tool ${before}; where it is to cut, it must feed, with the spindle on.`;
	if (roles.some((role) => role === 'holder' || role === 'shank')) return `retract the tool farther ${before}, or let it stick out more.`;
	if (roles.includes('cutter')) return `retract the tool ${before}, or move what is in the cutter\u2019s way.`;
	return `retract ${before}, or take another way there.`;
}

/** Rounded up, so that the amount is enough. @param {number} mm */
const enough = (mm) => fixed(Math.ceil(mm * 1000 - 0.001) / 1000, 3);

/** A change of the setup in words. @param {{quantity: string, direction: string}} change @param {string} mm */
function changeText({quantity, direction}, mm) {
	const sign = direction === '+' ? '+' : '\u2212';
	return quantity === 'length' ? `the tool ${direction === '+' ? 'farther back' : 'farther forward'} by that (length offset ${sign}${mm} mm)`
		: `${quantity.toUpperCase()} of the work offset ${sign}${mm} mm`;
}

/** The change in mm that makes the program clear, if --sensitivity was used. @param {Model} model */
function cures({sensitivity}) {
	const cured = sensitivity.filter(({result, kind}) => result === 'turns' && kind === null).map((change) => {
		const mm = enough(change.turn), less = change.tried > 0 ? `; ${fixed(change.tried, 3)} mm is not enough` : '';
		return `Needs at least ${mm} mm: with ${changeText(change, mm)} nothing is found${less}.`;
	});
	const range = shortest(Math.max(0, ...sensitivity.map((change) => change.range)));
	return cured.length || !sensitivity.length ? cured : [`No change of the setup that was tried, up to ${range} mm, is enough (--sensitivity).`];
}

/** How to get this amount. @param {Model} model @param {Finding} finding */
function question({sensitivity, bodies}, {kind, bodies: two}) {
	if (sensitivity.length || kind === 'gouge' || kind === 'start-overlap') return [];
	const tool = (two || []).some((i) => ['holder', 'shank', 'cutter'].includes(bodies[i].role ?? ''));
	return [h('p.note.question', {}, 'How many mm are needed? Check again with ', h('code', {}, `--sensitivity=${tool ? '0,0,0,50' : '50,50,50,50'}`), '.')];
}

export class FindingsView {
	/** @param {State} state */
	constructor(state) {
		this.state = state;
		this.model = state.model;
		/** @type {HTMLElement[]} */
		this.cards = [];
		this.element = h('section.findings', {'aria-label': 'Findings'});
		this.element.append(...this.errors());
		this.add(0, FIRST_CARDS);
		if (!this.model.findings.length) this.element.append(this.nothing());
		state.watch((what) => {
			if (what !== 'playing') this.mark();
		});
	}

	/** The errors that ended the check early, each with its line. */
	errors() {
		const {errors, sources} = this.model;
		return errors.slice(0, FIRST_CARDS).map(({file, line, text}) => {
			const name = file ?? '', read = line && sources.some((source) => source.name === name);
			return h('article.card.doubt.error', {}, h('b', {}, line ? `Error in line ${grouped(line)}` : 'Error'), h('p', {}, read || !name ? text : `${name}: ${text}`),
				read ? h('div.actions', {}, h('button', {onclick: () => this.state.readLine(name, line)}, 'Show')) : null);
		});
	}

	nothing() {
		const {verdict, sentence} = this.model;
		const good = verdict === 'clear' || verdict === 'passed' || verdict === 'accepted';
		return h(`div.card.${good ? 'good' : 'doubt'}`, {}, h('b', {}, good ? 'Nothing was found' : 'No finding, but no proof either'),
			...(good ? this.smallest() : [h('p', {}, sentence)]));
	}

	/** The smallest distance of bodies, according to the proof. */
	smallest() {
		const {clearance, pairs, bodies, program, sentence} = this.model, smallest = clearance?.smallest;
		if (!clearance) return [h('p', {}, sentence)];
		const all = `No two bodies that must be kept apart come nearer to each other than ${fixed(clearance.bound, 3)} mm.`;
		if (!smallest) return [h('p', {}, all)];
		const {least, pair, file, line, time} = smallest, [a, b] = [pairs[pair].a, pairs[pair].b].map((body) => bodies[body].name);
		const measured = least > clearance.bound, where = `line ${grouped(line)}${file === program ? '' : ` of ${file}`}`;
		return [h('p', {}, `Smallest clearance ${measured ? 'that was measured' : 'that is proved'}: at least ${fixed(least, 3)} mm between ${a} and ${b}, in ${where}.`),
			measured ? h('p', {}, all) : null,
			h('div.actions', {}, h('button', {onclick: () => {
				this.state.pause();
				this.state.seek(time - BEFORE_END);
			}}, 'Show'))];
	}

	/** @param {number} from @param {number} to */
	add(from, to) {
		const {findings, leftOut} = this.model;
		for (let i = from; i < Math.min(to, findings.length); i++) {
			const card = this.card(findings[i], i);
			this.cards.push(card);
			this.element.append(card);
		}
		const left = findings.length - this.cards.length;
		if (left > 0) {
			const more = h('button.more', {onclick: () => {
				more.remove();
				this.add(this.cards.length, Infinity);
			}}, `Show ${grouped(left)} more`);
			this.element.append(more);
		} else if (leftOut) this.element.append(h('p.note', {}, `${grouped(leftOut)} more findings are not in this report.`));
	}

	/** @param {Finding} finding @param {number} index */
	card(finding, index) {
		const {model, state} = this;
		const axes = model.readOut.filter((letter) => letter in finding.axes);
		const rows = [
			h('div.where', {}, h('code', {}, finding.block ?? ''), finding.kind === 'start-overlap' ? null : ` ${fixed(finding.fraction * 100, 1)} % through the block, at ${duration(finding.time)}`),
			h('dl.axes', {}, h('div.axes-name', {}, 'machine:'), ...axes.map((letter) => h('div', {}, h('dt', {}, letter), h('dd', {}, axisValue(finding.axes[letter]))))),
		];
		const moves = h('p.moves', {hidden: true});
		movesOf(model, finding).then((all) => {
			const text = all.map(({axis, from, to}) => `${axis.letter} ${axisValue(from)} \u2192 ${axisValue(to)}${axis.rotary ? '\u00b0' : ' mm'}`).join(', ');
			moves.append(text ? `This block moves ${text}. ` : '', h('b', {}, 'Try: '), advice(model, finding, all));
			moves.hidden = false;
		});
		return h(`article.card${finding.accepted ? '.accepted' : '.bad'}`, {'data-finding': index},
			h('button.title', {onclick: () => state.showFinding(index)},
				h('b', {}, ...titleParts(finding)),
				h('span.kind', {}, `${kindName(finding)} in line ${grouped(finding.line)}`)),
			...rows.slice(0, 1), moves, ...this.remarks(finding), ...(index ? [] : cures(model).map((text) => h('p.cure', {}, text))), rows[1],
			h('div.actions', {},
				h('button', {onclick: () => state.showFinding(index)}, 'Show'),
				h('button', {onclick: () => {
					state.showFinding(index);
					state.beforeFinding();
					state.toggle();
				}}, '\u25b6 from 2 s before')),
			...(finding.certain === undefined ? [] : [h('p.note', {}, certainty(finding.certain))]), ...(index ? [] : question(model, finding)));
	}

	/** @param {Finding} finding */
	remarks(finding) {
		const text = [];
		const pair = this.model.pairs.find(({a, b}) => finding.bodies && a === finding.bodies[0] && b === finding.bodies[1]);
		const required = finding.kind === 'clearance' && pair?.clearance;
		if (finding.kind === 'limit') text.push(`The block leads ${finding.axis} to ${axisValue(finding.target ?? 0)}; its limit is ${axisValue(finding.bound ?? 0)}: ${finding.path_tolerance ? 'up to ' : ''}${axisValue(finding.excess ?? 0)} too far.`);
		else if (finding.clearance && finding.clearance >= 0.0005) text.push(`${fixed(finding.clearance, 3)} mm apart here${required ? `; required: more than ${shortest(required)} mm` : ''}.`);
		else if (finding.allowed_depth) text.push(`The cutter may enter it ${shortest(finding.allowed_depth)} mm deep, and is deeper.`);
		if (finding.accepted) text.push(`Accepted: ${finding.reason || 'by --fail-on'}${finding.expires ? `, until ${finding.expires}` : ''}.`);
		return [this.callers(finding), ...text.map((line) => h('p', {}, line))];
	}

	/** The calls that led into the block's subprogram. @param {Finding} finding */
	callers(finding) {
		if (!finding.callers) return null;
		const place = (/** @type {{file: string, line: number}} */ {file, line}) => h('button.call', {onclick: () => this.state.readLine(file, line)}, `${file}:${line}`);
		return h('p.callers', {}, `In ${finding.file}, called from `, ...finding.callers.flatMap((call, i) => [i ? ' from ' : '', place(call)]));
	}

	mark() {
		this.cards.forEach((card, i) => {
			const now = i === this.state.finding;
			card.classList.toggle('now', now);
			card.setAttribute('aria-current', String(now));
			if (now) seen(card);
		});
	}
}

/**
 * Scrolls a card into view within its list; scrollIntoView would also scroll a page around the report.
 * @param {HTMLElement} card
 */
function seen(card) {
	const list = card.parentElement;
	if (!list) return;
	const [own, all] = [card, list].map((element) => element.getBoundingClientRect());
	list.scrollTop += Math.min(own.top - all.top, Math.max(0, own.bottom - all.bottom));
}

/** For a finding with the stock: is it certain for every stock that may remain? @param {boolean} certain */
function certainty(certain) {
	return certain ? 'Certain: they meet in this block where no cutter has been.' : 'Possible: all that they meet may have been cut, within the tolerances.';
}

/** The title, with the bodies in the colours of the picture. @param {Finding} finding */
function titleParts(finding) {
	if (!finding.a || !finding.b) return [findingTitle(finding)];
	const [first, second] = actors(finding);
	return [h(`span.swatch.swatch-${first.side}`), first.name, ` ${verbOf(finding)} `, h(`span.swatch.swatch-${second.side}`), second.name];
}
