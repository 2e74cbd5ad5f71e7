// @ts-check
/** editor.js - a few blocks that are checked at every key: errors and findings stand at their lines. */
import {element} from './page.js';
import {Newest} from './session_client.js';

/** @typedef {{line: number, column: number, kind: 'error' | 'finding' | 'warning', text: string, event?: Record<string, any>}} Remark */

const NAME = 'program.nc';
const FINDINGS = new Set(['collision', 'clearance', 'limit', 'start-overlap', 'rapid-contact', 'gouge']);
const VERDICTS = ['clear', 'found', 'incomplete', 'incomplete'];
const WORDS = {clear: 'Clear: nothing hits anything, in continuous time.', found: 'Found.', incomplete: 'Incomplete: not everything could be checked.'};

/**
 * What a check says, by line.
 * @param {import('./fivecheck.js').Result} result
 * @returns {Remark[]}
 */
export function remarksOf({events, messages}) {
	/** @type {Remark[]} */
	const remarks = [];
	for (const line of messages.split('\n')) {
		const [, at, column, kind, text] = line.match(/^program\.nc:(\d+)(?::(\d+))?: (error|warning): (.*)$/) ?? [];
		if (at)
			remarks.push({line: Number(at), column: Number(column ?? 1), kind: /** @type {any} */ (kind), text});
		else if (/(^|: )error: /.test(line))
			remarks.push({line: 0, column: 0, kind: 'error', text: line.replace(/^.*?error: /, '')});
	}
	for (const event of events.filter(({kind}) => FINDINGS.has(kind))) {
		const what = event.b ? `${event.a} and ${event.b}` : event.axis ?? event.a ?? '';
		remarks.push({line: event.line, column: event.column || 1, kind: 'finding', text: `${event.kind}: ${what}, at ${(100 * event.fraction).toFixed(1)} % of the block`, event});
	}
	return remarks.sort((a, b) => a.line - b.line);
}

export class Editor {
	/**
	 * @param {import('./session_client.js').SessionClient} session
	 * @param {string} text
	 * @param {(event: Record<string, any>) => void} look the user wants to see a finding
	 */
	constructor(session, text, look) {
		this.session = session;
		this.look = look;
		/** ms from the last key to its verdict. */
		this.took = 0;
		this.text = /** @type {HTMLTextAreaElement} */ (element('textarea', {value: text, spellcheck: false, id: 'blocks', wrap: 'off', autocapitalize: 'off'}));
		this.text.setAttribute('aria-describedby', 'remarks');
		this.gutter = element('div', {className: 'gutter', ariaHidden: 'true'});
		this.verdict = element('p', {className: 'verdict', role: 'status'}, 'loading the machine …');
		this.remarks = element('ul', {id: 'remarks', className: 'remarks'});
		this.newest = new Newest((/** @type {number} */ typed) => this.check(typed));
		this.text.addEventListener('input', () => this.typed());
		this.text.addEventListener('scroll', () => this.gutter.scrollTop = this.text.scrollTop);
		this.element = element('div', {className: 'editor'}, element('label', {htmlFor: 'blocks'}, 'Program'),
			element('div', {className: 'sheet'}, this.gutter, this.text), this.verdict, this.remarks);
	}

	typed() {
		return this.newest.put(performance.now());
	}

	/** @param {number} typed when */
	async check(typed) {
		try {
			this.show(await this.session.check({name: NAME, text: this.text.value}), typed);
		} catch (error) {
			this.verdict.dataset.verdict = 'incomplete';
			this.verdict.textContent = String(error);
		}
		document.dispatchEvent(new Event('edited'));
	}

	/** @param {import('./fivecheck.js').Result} result @param {number} typed */
	show(result, typed) {
		const remarks = remarksOf(result), verdict = /** @type {keyof typeof WORDS} */ (VERDICTS[result.status]);
		this.gutter.replaceChildren(...this.text.value.split('\n').map((_, i) => {
			const here = remarks.filter(({line}) => line === i + 1);
			const worst = here.some(({kind}) => kind !== 'warning') ? 'bad' : here.length ? 'doubt' : '';
			return element('div', {className: worst}, `${here.length ? '●' : ''} ${i + 1}`);
		}));
		this.gutter.scrollTop = this.text.scrollTop;
		this.remarks.replaceChildren(...remarks.map((remark) => this.remark(remark)));
		this.took = performance.now() - typed;
		this.verdict.dataset.verdict = verdict;
		this.verdict.textContent = `${WORDS[verdict]} (${this.took.toFixed(0)} ms)`;
	}

	/** @param {Remark} remark */
	remark(remark) {
		const {line, kind, text, event} = remark;
		if (!line)
			return element('li', {className: kind}, text);
		const button = element('button', {type: 'button'}, `Line ${line}`);
		button.addEventListener('click', () => {
			this.goTo(remark);
			if (event)
				this.look(event);
		});
		return element('li', {className: kind}, button, ` ${text}`);
	}

	/** Puts the cursor at the place. @param {Remark} remark */
	goTo({line, column}) {
		const before = this.text.value.split('\n').slice(0, line - 1).reduce((sum, row) => sum + row.length + 1, 0);
		this.text.focus();
		this.text.setSelectionRange(before + column - 1, before + column - 1);
	}
}
