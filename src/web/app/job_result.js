// @ts-check
/** job_result.js - the part of the page with the programs of one job of a job file, and the verdict on all of them. */
import {element} from './page.js';

/** From the best to the worst; the worst is the verdict of the job. */
const VERDICTS = ['clear', 'passed', 'accepted', 'found', 'incomplete'];

export class JobResult {
	/** @param {string} name @param {number} count of its programs */
	constructor(name, count) {
		this.name = name;
		this.count = count;
		/** @type {string[]} */
		this.told = [];
		this.title = element('h3', {}, `Job ${name}: checking \u2026`);
		this.part = element('section', {className: 'job', dataset: {job: name}, ariaLabel: `Job ${name}`}, this.title);
	}

	/** @param {string} verdict of one of its programs */
	tell(verdict) {
		this.told.push(verdict);
		if (this.told.length < this.count)
			return;
		const worst = VERDICTS[Math.max(...this.told.map((each) => VERDICTS.indexOf(each)))], those = this.told.filter((each) => each === worst).length;
		this.part.dataset.verdict = worst;
		this.title.textContent = `Job ${this.name}: ${worst}${this.count > 1 ? ` (${those} of ${this.count} programs)` : ''}`;
	}
}
