// @ts-check
/**
 * verdict_list.js - the progress of the checks of several programs: a count of each verdict, links to those that are
 * not clear, and, for very many programs, the list of all to save.
 */
import {nameOf} from './job_files.js';
import {element, reveal} from './page.js';

/** At most this many programs that are not clear have a button. */
const MOST_WAYS = 20;

export class VerdictList {
	/** @param {number} count of the programs @param {boolean} many not all have a card */
	constructor(count, many) {
		this.count = count;
		this.many = many;
		/** One line each: job, program, verdict. @type {string[]} */
		this.lines = [];
		/** @type {Map<string, number>} */
		this.counts = new Map();
		this.progress = /** @type {HTMLProgressElement} */ (element('progress', {max: count, value: 0, ariaLabel: 'Progress of all programs'}));
		// A screen reader should not read out each change of the counts.
		this.words = element('p', {className: 'counts', ariaLive: 'off'});
		this.ways = element('p', {className: 'row ways', hidden: true}, 'Not clear:');
		this.part = element('div', {className: 'verdict-list'}, this.words, this.progress, this.ways,
			...(many ? [element('p', {}, 'The first programs have a card each, and the first of the others that are not clear; these come without a report.')] : []));
		this.say();
	}

	say() {
		const counts = [...this.counts].map(([verdict, count]) => `${count} ${verdict}`).join(', ');
		this.words.textContent = `${this.lines.length} of ${this.count} programs checked${counts && `: ${counts}`}`;
		this.progress.value = this.lines.length;
	}

	/** @param {string} job @param {string} program @param {string} verdict @param {HTMLElement} [card] where the page says more */
	tell(job, program, verdict, card) {
		this.lines.push([job, program, verdict].map((word) => word.replace(/[\t\r\n]/g, ' ')).join('\t'));
		this.counts.set(verdict, (this.counts.get(verdict) ?? 0) + 1);
		this.say();
		if (card && verdict !== 'clear' && this.ways.childElementCount < MOST_WAYS)
			this.ways.append(this.wayTo(card, `${job && `${job}: `}${nameOf(program)}`));
		this.ways.hidden = this.ways.childElementCount === 0;
	}

	/** @param {HTMLElement} card @param {string} name */
	wayTo(card, name) {
		const button = element('button', {type: 'button'}, name);
		button.addEventListener('click', () => {
			card.tabIndex = -1;
			card.focus({preventScroll: true});
			reveal(card, 'start');
		});
		return button;
	}

	/** All are checked: for very many programs the list can be saved. */
	end() {
		this.progress.remove();
		if (!this.many)
			return;
		const save = element('button', {type: 'button', className: 'save-list'}, 'Save the list of verdicts');
		save.addEventListener('click', () => {
			const url = URL.createObjectURL(new Blob([`job\tprogram\tverdict\n${this.lines.join('\n')}\n`], {type: 'text/tab-separated-values'}));
			element('a', {href: url, download: 'verdicts.tsv'}).click();
			setTimeout(() => URL.revokeObjectURL(url), 60000);
		});
		this.words.after(save);
	}
}
