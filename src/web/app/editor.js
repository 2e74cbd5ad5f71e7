// @ts-check
/**
 * editor.js - a few blocks that are checked at every key; errors and findings are shown at their lines.
 *
 * The proof of a clear program is quick; to find the first instant of a deep collision takes longer. So a second
 * session tests samples meanwhile: its findings are shown until the proof is complete. If it finds nothing, this means
 * nothing.
 */
import {isDoubt} from './cautions.js';
import {STATUS} from './fivecheck.js';
import {element} from './page.js';
import {Newest} from './session_client.js';

/** @typedef {{line: number, column: number, kind: 'error' | 'finding' | 'warning', text: string, event?: Record<string, any>}} Remark */

const NAME = 'program.nc';
/** An endless loop, which may occur while the program is being written, must not keep the machine busy. */
const BOUND = '--max-blocks=100000';
const FINDINGS = new Set(['collision', 'clearance', 'limit', 'start-overlap', 'rapid-contact', 'gouge']);
const VERDICTS = ['clear', 'found', 'incomplete', 'incomplete'];
const SAMPLED = 'Found by samples; the proof follows.';
const WORDS = {clear: 'Clear: nothing hits anything, in continuous time.', found: 'Found.', incomplete: 'Incomplete: not everything could be checked.'};

/**
 * The messages of a check, by line.
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
	const cautions = events.find(({kind}) => kind === 'program')?.cautions ?? [];
	// Warnings are shown at their lines already.
	const doubts = cautions.filter((/** @type {string} */ caution) => isDoubt(caution) && !/^\d+ warnings?\b/.test(caution));
	return [...remarks.sort((a, b) => a.line - b.line), ...doubts.map((/** @type {string} */ text) => ({line: 0, column: 0, kind: /** @type {const} */ ('warning'), text}))];
}

/** @typedef {{number: number, at: number, text: string}} Typed a key: its number, when, and the text since then */

export class Editor {
	/**
	 * @param {import('./session_client.js').SessionClient} session
	 * @param {import('./session_client.js').SessionClient} scout the same machine, for the samples
	 * @param {string} text
	 * @param {(event: Record<string, any>) => void} look the user wants to see a finding
	 */
	constructor(session, scout, text, look) {
		this.session = session;
		this.scout = scout;
		this.look = look;
		/** ms from the last key to its first verdict. */
		this.took = 0;
		/** ms from the last key to the proved verdict. */
		this.proved = 0;
		this.keys = 0;
		/** The number of the key whose verdict is shown. */
		this.shown = 0;
		this.text = /** @type {HTMLTextAreaElement} */ (element('textarea', {value: text, spellcheck: false, id: 'blocks', wrap: 'off', autocapitalize: 'off'}));
		this.text.setAttribute('aria-describedby', 'remarks');
		this.gutter = element('div', {className: 'gutter', ariaHidden: 'true'});
		this.verdict = element('p', {className: 'verdict', role: 'status'}, 'loading the machine …');
		this.remarks = element('ul', {id: 'remarks', className: 'remarks'});
		this.newest = new Newest((/** @type {Typed} */ typed) => this.check(typed));
		this.newestSample = new Newest((/** @type {Typed} */ typed) => this.sample(typed));
		this.text.addEventListener('input', () => this.typed());
		this.text.addEventListener('scroll', () => this.gutter.scrollTop = this.text.scrollTop);
		this.element = element('div', {className: 'editor'}, element('label', {htmlFor: 'blocks'}, 'Program'),
			element('div', {className: 'sheet'}, this.gutter, this.text), this.verdict, this.remarks);
	}

	typed() {
		const typed = {number: ++this.keys, at: performance.now(), text: this.text.value};
		/* The verdict of the text before is not valid for this one. */
		if (this.verdict.dataset.verdict === 'clear') {
			delete this.verdict.dataset.verdict;
			this.verdict.textContent = 'Checking …';
		}
		this.newestSample.put(typed);
		return this.newest.put(typed);
	}

	/** @param {Typed} typed */
	async sample(typed) {
		const result = await this.scout.check({name: NAME, text: typed.text, options: ['--method=conventional', '--step=0.05', BOUND]}).catch(() => undefined);
		if (result?.status === STATUS.FOUND && typed.number === this.keys && typed.number > this.shown) {
			this.show(result, typed, SAMPLED);
			document.dispatchEvent(new Event('sampled'));
		}
	}

	/** @param {Typed} typed */
	async check(typed) {
		try {
			const result = await this.session.check({name: NAME, text: typed.text, options: [BOUND]});
			/* Show the result only if it is about the current text; that of a later key follows. */
			if (typed.number === this.keys) {
				this.show(result, typed);
				this.proved = performance.now() - typed.at;
			}
		} catch (error) {
			this.verdict.dataset.verdict = 'incomplete';
			this.verdict.textContent = String(error);
		}
		document.dispatchEvent(new Event('edited'));
	}

	/** @param {import('./fivecheck.js').Result} result @param {Typed} typed @param {string} [words] in place of the verdict's */
	show(result, typed, words) {
		const remarks = remarksOf(result), verdict = /** @type {keyof typeof WORDS} */ (VERDICTS[result.status]);
		this.gutter.replaceChildren(...this.text.value.split('\n').map((_, i) => {
			const here = remarks.filter(({line}) => line === i + 1);
			const worst = here.some(({kind}) => kind !== 'warning') ? 'bad' : here.length ? 'doubt' : '';
			return element('div', {className: worst}, `${here.length ? '●' : ''} ${i + 1}`);
		}));
		this.gutter.scrollTop = this.text.scrollTop;
		this.remarks.replaceChildren(...remarks.map((remark) => this.remark(remark)));
		if (typed.number > this.shown)
			this.took = performance.now() - typed.at;
		this.shown = typed.number;
		this.verdict.dataset.verdict = verdict;
		this.verdict.textContent = `${words ?? WORDS[verdict]} (${this.took.toFixed(0)} ms)`;
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
