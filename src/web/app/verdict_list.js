// @ts-check
/** verdict_list.js - how far the checks of several programs are: a count of each verdict, the way to what is not clear, and, of very many, the list of all to save. */
import {nameOf} from './job_files.js';
import {element, reveal} from './page.js';

/** To so many programs that are not clear there is a button. */
const MOST_WAYS = 20;

export class VerdictList {
	/** @param {number} count of the programs @param {boolean} many not all have a card */
	constructor(count, many) {
		this.count = count;
		this.many = many;
		/** A line each: job, program, verdict. @type {string[]} */
		this.lines = [];
		/** @type {Map<string, number>} */
		this.counts = new Map();
		this.progress = /** @type {HTMLProgressElement} */ (element('progress', {max: count, value: 0, ariaLabel: 'Progress of all programs'}));
		// Each change of the counts is too much to be read out.
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

	/** All are checked: of very many the list can be saved. */
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
