// @ts-check
/** main.js - the page: the files of the job, the check, its findings and reports, and the form for a machine. */
import {adviceOn} from './advice.js';
import {moreOptions, optionsIn} from './check_options.js';
import {Checks} from './checks.js';
import {Client} from './client.js';
import {takeDrops, unpacked} from './dropped.js';
import {watchNumbers} from './fields.js';
import {atHome, exampleFiles, examplesOf, inOrder, isClutter, jobFile, nameOf, sameBytes, twins, withLibraries} from './job_files.js';
import {MachineForm} from './machine_form.js';
import {keepOffline} from './offline.js';
import {byId, element, reveal} from './page.js';
import {SetupForm} from './setup_form.js';

/** @typedef {import('./job_files.js').JobFile} JobFile */

/** At most this many files have a separate row. */
const MOST_ROWS = 500;
/** What each example shows. */
const EXAMPLES = /** @type {Record<string, string>} */ ({'ac-trunnion': 'an impeller on a table that tilts and turns',
	'b-head-c-table': 'a turbine blade, head and table turn', 'cb-head': 'a structural part, a head that tilts and turns'});

class Page {
	constructor() {
		/** @type {JobFile[]} */
		this.files = [];
		this.client = new Client(new URL('.', import.meta.url));
		this.checks = new Checks(this.client, byId('results'));
		this.running = this.opening = false;
		/** @param {[string, Blob][]} found */
		const add = (found) => void this.add(found);
		this.form = new MachineForm(/** @type {HTMLFormElement} */ (byId('machine-form')), this.client, add, (xml) => this.useFile('machine.xml', xml));
		this.setup = new SetupForm(/** @type {HTMLFormElement} */ (byId('setup-form')), add, (xml) => this.useFile('setup.xml', xml));
		byId('more-options').append(...moreOptions());
		watchNumbers(byId('options'));
		this.openForms();
		byId('check').addEventListener('click', () => this.check());
		byId('cancel').addEventListener('click', () => this.checks.cancel());
		byId('empty').addEventListener('click', () => {
			this.setFiles([]);
			byId('choose').focus();
		});
		byId('options').addEventListener('change', () => {
			this.outdate();
			this.showButtons();
		});
		byId('options').addEventListener('submit', (event) => event.preventDefault());
		for (const id of ['choose', 'choose-folder']) {
			const input = /** @type {HTMLInputElement} */ (byId(id));
			input.addEventListener('change', () => {
				this.take([...(input.files ?? [])].map((file) => [file.webkitRelativePath || file.name, file]));
				input.value = '';
			});
		}
		takeDrops(byId('drop'), (found) => this.take(found));
		this.showButtons();
		this.offerExamples();
		keepOffline(() => this.opening || this.running);
	}

	/** A link to a form opens the form. */
	openForms() {
		document.addEventListener('click', ({target}) => {
			const id = target instanceof HTMLAnchorElement ? target.hash.slice(1) : '', form = id && byId(id).closest('section')?.querySelector('details');
			if (form)
				form.open = true;
		});
	}

	async offerExamples() {
		for (const name of await examplesOf(byId('examples'))) {
			const button = element('button', {type: 'button', dataset: {example: name}}, name, element('small', {}, EXAMPLES[name] ?? ''));
			button.addEventListener('click', () => this.openExample(name));
			byId('examples').append(button);
		}
		document.dispatchEvent(new Event('fivecheck-ready'));
	}

	/** @param {string} name */
	async openExample(name) {
		this.opening = true;
		this.client.prepare();
		this.setFiles([]);
		try {
			this.setFiles(await exampleFiles(name));
		} catch (error) {
			byId('job').replaceChildren(element('span', {className: 'lack'}, String(error)));
		}
		this.opening = false;
		byId('check').focus({preventScroll: true});
		reveal(byId('start'));
		document.dispatchEvent(new Event('example-open'));
	}

	/**
	 * Takes files that the user dropped or chose, and shows the possible actions.
	 * @param {[string, Blob][]} found
	 */
	async take(found) {
		await this.add(found);
		reveal(byId('start'));
	}

	/**
	 * Takes files in place of those with the same path. A machine, setup, job file or waivers replace the earlier
	 * ones of their kind, too; but a job file may refer to several.
	 * @param {[string, Blob][]} found
	 */
	async add(found) {
		this.client.prepare();
		const {files: dropped, faults} = await unpacked(found);
		const all = atHome(await Promise.all(dropped.filter(([path]) => !isClutter(path)).map(([path, blob]) => jobFile(path, blob))), this.files);
		const second = twins(all), files = all.filter((file) => !second.includes(file)), paths = new Set(files.map(({path}) => path));
		faults.push(...second.map(({path}) => `${path} came twice, from two places: the first is here. If it is the wrong one, drop the other alone.`));
		const lists = [...this.files, ...files].some(({role}) => role === 'jobs'), single = lists ? ['jobs'] : ['machine', 'setup', 'waivers'];
		const once = new Set(files.map(({role}) => role).filter((role) => single.includes(role)));
		const replaced = await Promise.all(files.filter(({role}) => role === 'mesh').map(async ({path, blob}) => {
			const old = this.files.find((file) => file.path === path);
			return old && !await sameBytes(old.blob, blob) ? [path] : [];
		}));
		this.setFiles([...this.files.filter((file) => !paths.has(file.path) && !once.has(file.role)), ...files], replaced.flat());
		byId('job').prepend(...[...faults, ...(dropped.length ? [] : ['There is no file in what was dropped.'])].map((text) => element('span', {className: 'lack'}, text)));
	}

	/** A file that a form wrote. @param {string} name @param {string} xml */
	async useFile(name, xml) {
		await this.add([[name, new Blob([xml], {type: 'application/xml'})]]);
		reveal(byId('start'));
	}

	/** @param {JobFile[]} files @param {string[]} replaced meshes that took the place of others of the same name */
	setFiles(files, replaced = []) {
		this.files = inOrder(withLibraries(files));
		this.outdate();
		this.setup.propose(this.of('machine')[0]?.text ?? '', this.of('program').map(({text}) => text), this.of('library').map(({path}) => nameOf(path)));
		const several = this.of('program').length > 1, rows = this.files.slice(0, MOST_ROWS).map((file) => element('li', {dataset: {role: file.role}},
			element('span', {className: 'role'}, file.role), element('span', {}, file.path), ...this.roleButton(file, several), this.removeButton(file)));
		byId('file-list').replaceChildren(...rows, ...(files.length > MOST_ROWS ? [element('li', {}, `and ${files.length - MOST_ROWS} others`)] : []));
		byId('empty').hidden = files.length === 0;
		this.showLacks(replaced);
		this.showButtons();
		document.dispatchEvent(new Event('files-shown'));
	}

	/** The shown results are about the earlier files and options. */
	outdate() {
		byId('outdated').hidden = byId('results').childElementCount === 0;
	}

	/** Of several programs, some may only be called by others. @param {JobFile} file @param {boolean} several */
	roleButton(file, several) {
		const {path, role} = file, alone = role === 'program', [label, text] = alone ? [`Use ${path} as a subprogram alone`, 'Subprogram'] : [`Check ${path} by itself`, 'Check it'];
		if (role !== 'subprogram' && !(alone && several))
			return [];
		const button = element('button', {type: 'button', title: label, ariaLabel: label}, text);
		button.addEventListener('click', () => {
			this.setFiles(this.files.map((other) => other === file ? {...file, role: /** @type {const} */ (alone ? 'subprogram' : 'program')} : other));
			byId('file-list').querySelectorAll('li').forEach((row, i) => this.files[i].path === path && row.querySelector('button')?.focus());
		});
		return [button];
	}

	/** @param {JobFile} file */
	removeButton(file) {
		const button = element('button', {type: 'button', title: `Remove ${file.path}`, ariaLabel: `Remove ${file.path}`}, '×');
		button.addEventListener('click', () => {
			const place = this.files.indexOf(file);
			this.setFiles(this.files.filter((other) => other !== file));
			// The focus moves to the same button of the next file.
			const rows = byId('file-list').children, next = rows[Math.min(place, rows.length - 1)]?.querySelector('button:last-of-type');
			/** @type {HTMLElement} */ (next ?? byId('choose')).focus();
		});
		return button;
	}

	/** @param {import('./job_files.js').Role} role */
	of(role) {
		return this.files.filter((file) => file.role === role);
	}

	/** What the files lack, and what to do about it; none of it prevents the check. @param {string[]} replaced */
	showLacks(replaced) {
		const lacks = adviceOn(this.files, replaced).map((text) => element('span', {className: 'lack'}, text)), machines = this.of('machine');
		if (machines.length && !this.of('jobs').length && !this.of('setup').length && !machines.some(({text}) => /<setup[\s>]/.test(text)))
			lacks.push(element('span', {className: 'lack'}, 'Without a setup no tool, fixture or part is checked, and a program finds no length of a tool. ',
				element('a', {href: '#setup-title'}, 'Write a setup'), '.'));
		byId('job').replaceChildren(...lacks);
	}

	/** Why these files cannot be checked, and what to do; or ''. */
	whyNot() {
		const others = this.of('other').map(({path}) => path);
		const twice = /** @type {const} */ (['jobs', 'machine', 'setup', 'waivers']).find((role) => this.of(role).length > 1);
		if (this.files.length === 0)
			return 'Open an example, or your own files, first.';
		if (twice && (twice === 'jobs' || !this.of('jobs').length))
			return `There is more than one ${{jobs: 'job file', machine: 'machine file', setup: 'setup', waivers: 'file of waivers'}[twice]}: remove all but one.`;
		if (this.of('jobs').length)
			return '';
		if (!this.of('machine').length)
			return `A machine file is missing: drop it, open an example, or write one below.${others.length ? ` There is no <machine> in ${others.join(', ')}.` : ''}`;
		return this.of('program').length ? '' : 'A program is missing: drop the NC program, too.';
	}

	/** The results are about the current files and options. */
	isChecked() {
		return byId('results').childElementCount > 0 && byId('outdated').hidden;
	}

	/** The object of a check. */
	ready() {
		const programs = this.of('program').map(({path}) => nameOf(path)), first = programs.slice(0, 3).join(', ');
		return this.of('jobs').length ? 'Ready to check the jobs of the job file.' : `Ready to check ${first}${programs.length > 3 ? ` and ${programs.length - 3} more` : ''}.`;
	}

	showButtons() {
		const why = this.whyNot();
		byId('why-not').textContent = why;
		byId('ready').textContent = why || this.running || this.isChecked() ? '' : this.ready();
		const check = /** @type {HTMLButtonElement} */ (byId('check')), cancel = byId('cancel'), focus = document.activeElement;
		check.disabled = why !== '' || this.running;
		cancel.hidden = !this.running;
		// A user who presses a button that is removed finds the other one under the same key.
		if (focus === check && check.disabled)
			cancel.focus();
		if (focus === cancel && cancel.hidden)
			check.focus();
	}

	optionsOf() {
		return optionsIn(new FormData(/** @type {HTMLFormElement} */ (byId('options'))));
	}

	/** Checks all programs, or all those of the job file. */
	async check() {
		byId('outdated').hidden = true;
		this.running = true;
		this.showButtons();
		await this.checks.start(this.files, this.optionsOf());
		this.running = false;
		this.showButtons();
		document.dispatchEvent(new Event('checked'));
	}
}

Object.assign(window, {fivecheckPage: new Page()});
