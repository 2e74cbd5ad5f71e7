// @ts-check
/** verdict_list.js - how far the checks of very many programs are: a count of each verdict, and the list of all to save. */
import {element} from './page.js';

export class VerdictList {
	/** @param {number} count of the programs */
	constructor(count) {
		this.count = count;
		/** A line each: job, program, verdict. @type {string[]} */
		this.lines = [];
		/** @type {Map<string, number>} */
		this.counts = new Map();
		this.progress = /** @type {HTMLProgressElement} */ (element('progress', {max: count, value: 0, ariaLabel: 'Progress of all programs'}));
		// Each change of the counts is too much to be read out.
		this.words = element('p', {className: 'counts', ariaLive: 'off'});
		this.part = element('div', {className: 'verdict-list'}, this.words, this.progress,
			element('p', {}, 'The first programs have a card each, and the first of the others that are not clear; these come without a report.'));
		this.say();
	}

	say() {
		const counts = [...this.counts].map(([verdict, count]) => `${count} ${verdict}`).join(', ');
		this.words.textContent = `${this.lines.length} of ${this.count} programs checked${counts && `: ${counts}`}`;
		this.progress.value = this.lines.length;
	}

	/** @param {string} job @param {string} program @param {string} verdict */
	tell(job, program, verdict) {
		this.lines.push([job, program, verdict].map((word) => word.replace(/[\t\r\n]/g, ' ')).join('\t'));
		this.counts.set(verdict, (this.counts.get(verdict) ?? 0) + 1);
		this.say();
	}

	/** All are checked: the list can be saved. It has no address of its own that would have to be given back. */
	end() {
		const save = element('button', {type: 'button', className: 'save-list'}, 'Save the list of verdicts');
		save.addEventListener('click', () => {
			const url = URL.createObjectURL(new Blob([`job\tprogram\tverdict\n${this.lines.join('\n')}\n`], {type: 'text/tab-separated-values'}));
			element('a', {href: url, download: 'verdicts.tsv'}).click();
			setTimeout(() => URL.revokeObjectURL(url), 60000);
		});
		this.progress.remove();
		this.words.after(save);
	}
}
