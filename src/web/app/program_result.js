// @ts-check
/**
 * program_result.js - a program's card on the page: progress, findings as they come, the verdict with its cautions, the
 * report.
 */
import {copyField} from './check_options.js';
import {isDoubt} from './cautions.js';
import {nameOf} from './job_files.js';
import {element} from './page.js';

/** The meaning of verdicts, and the exit status of each. @type {Record<string, {status: number, text: string}>} */
const VERDICTS = {
	clear: {status: 0, text: 'Clear: nothing hits anything, in continuous time.'},
	passed: {status: 0, text: 'Passed: samples found nothing. This is no proof.'},
	accepted: {status: 0, text: 'Accepted: all that was found is waived, or of a kind that does not fail. This is not clear.'},
	found: {status: 1, text: 'Found: the machine hits itself.'},
	incomplete: {status: 2, text: 'Incomplete: not everything could be checked.'},
};
const FINDINGS = new Set(['collision', 'clearance', 'limit', 'start-overlap', 'rapid-contact', 'gouge']), KINDS = FINDINGS.size;

export class ProgramResult {
	/** @param {string} path @param {boolean} open its report is shown at once @param {string} [job] of a job file */
	constructor(path, open, job) {
		this.path = path;
		this.open = open;
		/** Aborted when the card is removed: everything that it has open ends with it. */
		this.gone = new AbortController();
		this.progress = element('progress', {max: 1, value: 0, ariaLabel: `Progress of ${path}`});
		this.verdict = element('p', {className: 'verdict'}, 'checking …');
		this.findings = element('ul', {className: 'findings'});
		this.more = element('div', {});
		this.doubts = element('ul', {className: 'doubts'});
		/** The options of its check. @type {string[]} */
		this.used = [];
		this.card = element('article', {className: 'program', dataset: {path, ...(job ? {job} : {})}}, element(job ? 'h4' : 'h3', {}, nameOf(path)), this.verdict, this.doubts, this.progress,
			this.findings, this.more);
	}

	/** @param {number} part */
	onProgress(part) {
		/** @type {HTMLProgressElement} */ (this.progress).value = part;
	}

	/** @param {Record<string, any>} event */
	onEvent(event) {
		if (FINDINGS.has(event.kind))
			this.findings.append(element('li', {className: event.kind}, wordsOf(event, this.path)));
		if (event.kind === 'header')
			this.used = usedIn(event);
		if (event.kind !== 'program')
			return;
		for (const caution of event.cautions ?? [])
			isDoubt(caution) ? this.doubts.append(element('li', {className: 'message'}, caution)) : this.onMessage(caution);
		this.tell(event.verdict);
	}

	/**
	 * Shows the verdict. It is known before the report is written; if this fails, `show` reports the failure.
	 * @param {string} verdict
	 */
	tell(verdict) {
		this.card.dataset.verdict = verdict;
		this.verdict.textContent = VERDICTS[verdict].text;
		if (verdict === 'passed' && this.used[0] === 'method parse-only')
			this.verdict.textContent = 'Passed: within the axis limits. No collision was checked.';
		if (verdict === 'found' && !this.findings.querySelector('.collision'))
			this.verdict.textContent = 'Found: see below.';
	}

	/** A line of the checker's messages: a quoted block and its caret must be aligned. @param {string} message */
	onMessage(message) {
		const kind = /^\s/.test(message) ? ' quoted' : /(^|: )error: /.test(message) ? ' error' : '';
		if (message)
			this.findings.append(element('li', {className: `message${kind}`}, message));
	}

	/**
	 * @param {import('./fivecheck.js').Result} result
	 * @param {string} command that gives the same verdict
	 * @param {Blob | undefined} report
	 */
	show(result, command, report) {
		this.progress.remove();
		// The shown verdict stays if the exit status agrees.
		const told = this.card.dataset.verdict ?? 'clear', status = Math.min(result.status, 2);
		this.tell(this.card.dataset.verdict && VERDICTS[told].status === status ? told : ['incomplete', 'found', 'incomplete'][status]);
		if (this.doubts.childElementCount)
			this.doubts.before(element('p', {className: 'doubt'}, 'Doubts about what this verdict takes for granted:'));
		if (this.used.length && status < 2)
			this.more.append(element('p', {className: 'used'}, `Checked with ${this.used.join(', ')}.`));
		this.more.append(copyField('The same on the command line', command));
		this.more.append(element('details', {}, element('summary', {}, 'The verdict in words'), element('pre', {className: 'words', tabIndex: 0}, result.text)));
		if (report)
			this.showReport(report);
	}

	/** @param {Blob} report */
	showReport(report) {
		const frame = /** @type {HTMLIFrameElement} */ (element('iframe', {title: `Report of ${this.path}`, src: 'report.html', className: 'report'}));
		frame.setAttribute('sandbox', 'allow-scripts');
		const url = URL.createObjectURL(report), {signal} = this.gone;
		const save = element('a', {className: 'button save', href: url, download: nameOf(this.path).replace(/\.[^.]*$/, '') + '.html'}, 'Save the report');
		const show = element('button', {type: 'button', className: 'show'}, 'Show the report');
		show.addEventListener('click', () => {
			show.remove();
			this.more.append(frame);
		});
		addEventListener('message', async ({source, data}) => {
			if (source === frame.contentWindow && data === 'report-frame-ready')
				frame.contentWindow?.postMessage(await report.text(), '*');
			if (source === frame.contentWindow && data === 'report-shown')
				document.dispatchEvent(new Event('report-shown'));
		}, {signal});
		signal.addEventListener('abort', () => URL.revokeObjectURL(url));
		this.more.append(element('p', {className: 'row'}, save, ...(this.open ? [] : [show])), ...(this.open ? [frame] : []));
	}

	/** The card is removed: its report can no longer be saved or shown. */
	release() {
		this.gone.abort();
	}

	/** A verdict that was shown stays. */
	cancel() {
		if (this.card.dataset.verdict)
			this.progress.remove();
		else
			this.fail('Cancelled: nothing is known of this program.');
	}

	/** @param {string} text */
	fail(text) {
		this.progress.remove();
		this.card.dataset.verdict = 'incomplete';
		this.verdict.textContent = text;
	}
}

/**
 * The conditions of a verdict besides the files, in words.
 * @param {Record<string, any>} header the first event of a run
 */
function usedIn({method, step, tolerance, stock_tolerance: stock, clearance, all, dialect, block_delete: skips, duplicates, include, max_blocks: most, fail_on: fails}) {
	return [`method ${method}`, ...(method === 'certified' || method === 'parse-only' ? [] : [`step ${step} s`]), `dialect ${dialect}`, `clearance ${clearance} mm`, `tolerance ${tolerance} mm`, `stock tolerance ${stock} mm`,
		...(all ? ['all findings'] : []), ...(skips ? ['blocks that begin with / skipped'] : []), ...(duplicates === 'last' ? ['the last of two like words'] : []),
		...include.map((/** @type {string} */ folder) => `subprograms in ${folder}`), ...(most ? [`at most ${most} blocks in loops and subprograms`] : []),
		...(fails.length === KINDS ? [] : [`fail-on ${fails.join(', ') || 'none'}`])];
}

/**
 * A finding in words.
 * @param {Record<string, any>} event
 * @param {string} path of the program, which may call others
 */
function wordsOf(event, path) {
	const axes = Object.entries(event.axes ?? {}).map(([axis, value]) => `${axis} ${Number(value).toFixed(3)}`).join(', ');
	const what = event.b ? `${event.a} and ${event.b}` : event.a ?? '';
	return `${event.file === path ? 'Line' : `${event.file}, line`} ${event.line}: ${event.kind}${what ? `: ${what}` : ''} (${axes})`;
}

