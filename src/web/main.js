// @ts-check
// main.js - shows the report that the page carries. If anything fails, its plain HTML stays.

import {App} from './app.js';
import {STYLE} from './style.js';
import {readReport} from './report.js';

async function main() {
	const plain = document.getElementById('plain');
	try {
		const sheet = new CSSStyleSheet();
		sheet.replaceSync(STYLE);
		const model = await readReport();
		document.adoptedStyleSheets = [sheet];
		const app = new App(model);
		app.show(document.body);
		document.body.classList.add('viewing');
		// For tests, and for use in the console.
		Object.assign(window, {fivecheck: app});
	} catch (e) {
		console.warn('The 3-D view is not shown:', e);
		document.body.classList.remove('viewing');
		document.adoptedStyleSheets = [];
		document.querySelector('.app')?.remove();
		if (plain) plain.hidden = false;
	}
	document.dispatchEvent(new Event('fivecheck-ready'));
}

main();
