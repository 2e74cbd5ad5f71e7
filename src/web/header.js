// @ts-check
// header.js - the verdict as a sentence, and what must be said beside it.

import {findingTitle, kindName} from './findings.js';
import {grouped, h} from './elements.js';

/** @typedef {import('./model.js').Model} Model */

/** The verdict in one sentence: the first finding if there is one. @param {Model} model */
export function headline(model) {
	const first = model.findings.find((finding) => !finding.accepted) || model.findings[0];
	if (first && model.verdict !== 'clear') return `${kindName(first)}: ${findingTitle(first)} in line ${grouped(first.line)}`;
	const [error] = model.errors;
	if (model.verdict === 'incomplete' && error?.line) return `Incomplete: an error in line ${grouped(error.line)}`;
	return {clear: 'Clear: the machine does not hit itself', passed: 'Passed', incomplete: 'Incomplete: this program is not proved'}[model.verdict] || model.verdict;
}

/** @param {Model} model @param {() => void} showHelp */
export function headerView(model, showHelp) {
	const kind = model.verdict === 'clear' ? 'good' : model.failing ? 'bad' : 'doubt';
	const {doubts} = model, remarks = model.cautions.filter((text) => !doubts.includes(text));
	return h(`header.${kind}`, {},
		h('div.verdict', {}, h('h1', {}, headline(model)), h('p', {}, model.sentence.startsWith(model.program) ? model.sentence : `${model.program}: ${model.sentence}`)),
		remarks.length ? h('details.cautions', {}, h('summary', {}, `${remarks.length} ${remarks.length === 1 ? 'remark' : 'remarks'}`), h('ul', {}, ...remarks.map((text) => h('li', {}, text)))) : null,
		h('div.header-buttons', {},
			h('button.print', {onclick: () => print()}, 'Print'),
			h('button', {onclick: showHelp, 'aria-label': 'Keys and help', title: 'Keys and help (?)'}, '?')),
		doubts.length ? doubtsView(doubts) : null);
}

/**
 * The assumptions of the verdict, and the doubts about them: the first of them is visible at once.
 * @param {string[]} doubts
 */
function doubtsView(doubts) {
	const many = doubts.length > 1;
	return h('details.doubts', {}, h('summary', {}, h('b', {}, many ? `${grouped(doubts.length)} doubts about what this verdict takes for granted. ` : 'A doubt about what this verdict takes for granted. '),
		h('span.first-doubt', {}, doubts[0])), h('ul', {}, ...doubts.map((text) => h('li', {}, text))));
}
