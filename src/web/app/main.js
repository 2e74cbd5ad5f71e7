// @ts-check
/** main.js - the page: the files of the job, the check, its findings and reports, and the form for a machine. */
import {Cancelled, Client} from './client.js';
import {readNumber, watchNumbers} from './fields.js';
import {exampleFile, inOrder, isDrawing, jobFile, missingFiles, sameBytes, withLibraries, withMeshes} from './job_files.js';
import {MachineForm} from './machine_form.js';
import {byId, element} from './page.js';
import {ProgramResult} from './program_result.js';
import {SetupForm} from './setup_form.js';

/** @typedef {import('./job_files.js').JobFile} JobFile */

/** So many reports are shown at once, the others when asked for: a browser draws only some pictures at a time. */
const FIRST_REPORTS = 4;
/** What each example shows. */
const EXAMPLES = /** @type {Record<string, string>} */ ({'ac-trunnion': 'an impeller on a table that tilts and turns',
	'b-head-c-table': 'a turbine blade, head and table turn', 'cb-head': 'a structural part, a head that tilts and turns'});

class Page {
	constructor() {
		/** @type {JobFile[]} */
		this.files = [];
		this.client = new Client(new URL('.', import.meta.url));
		this.running = 0;
		/** @type {Map<string, Blob>} by the path of the program */
		this.reports = new Map();
		/** @type {Map<string, number>} bytes that the check of a program took */
		this.memory = new Map();
		/** @param {[string, Blob][]} found */
		const add = (found) => void this.add(found);
		this.form = new MachineForm(/** @type {HTMLFormElement} */ (byId('machine-form')), this.client, add, (xml) => this.useFile('machine.xml', xml));
		this.setup = new SetupForm(/** @type {HTMLFormElement} */ (byId('setup-form')), add, (xml) => this.useFile('setup.xml', xml));
		watchNumbers(byId('options'));
		this.openForms();
		byId('check').addEventListener('click', () => this.check());
		byId('cancel').addEventListener('click', () => this.client.cancel());
		byId('empty').addEventListener('click', () => this.setFiles([]));
		byId('options').addEventListener('change', () => this.outdate());
		byId('options').addEventListener('submit', (event) => event.preventDefault());
		for (const id of ['choose', 'choose-folder']) {
			const input = /** @type {HTMLInputElement} */ (byId(id));
			input.addEventListener('change', () => {
				this.add([...(input.files ?? [])].map((file) => [file.webkitRelativePath || file.name, file]));
				input.value = '';
			});
		}
		this.takeDrops();
		this.showButtons();
		this.offerExamples();
	}

	/** A link to a form opens it. */
	openForms() {
		document.addEventListener('click', ({target}) => {
			const id = target instanceof HTMLAnchorElement ? target.hash.slice(1) : '', form = id && byId(id).closest('section')?.querySelector('details');
			if (form)
				form.open = true;
		});
	}

	takeDrops() {
		const drop = byId('drop');
		addEventListener('dragover', (event) => {
			event.preventDefault();
			drop.classList.add('over');
		});
		addEventListener('dragleave', () => drop.classList.remove('over'));
		addEventListener('drop', async (event) => {
			event.preventDefault();
			drop.classList.remove('over');
			const entries = [...(event.dataTransfer?.items ?? [])].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
			this.add((await Promise.all(entries.map((entry) => filesBelow(entry)))).flat());
		});
	}

	async offerExamples() {
		const examples = await (await fetch('examples/index.json')).json();
		for (const [name, paths] of Object.entries(examples)) {
			const button = element('button', {type: 'button', dataset: {example: name}}, name, element('small', {}, EXAMPLES[name] ?? ''));
			button.addEventListener('click', () => this.openExample(paths));
			byId('examples').append(button);
		}
		document.dispatchEvent(new Event('fivecheck-ready'));
	}

	/** @param {string[]} paths */
	async openExample(paths) {
		this.setFiles([]);
		try {
			this.setFiles(await Promise.all(paths.map(exampleFile)));
		} catch (error) {
			byId('job').replaceChildren(element('span', {className: 'lack'}, String(error)));
		}
		document.dispatchEvent(new Event('example-open'));
	}

	/** @param {[string, Blob][]} found */
	async add(found) {
		const files = await Promise.all(found.map(([path, blob]) => jobFile(path, blob)));
		const once = files.some(({role}) => role === 'machine') ? 'machine' : '', paths = new Set(files.map(({path}) => path));
		const setup = files.some(({role}) => role === 'setup');
		const replaced = await Promise.all(files.filter(({role}) => role === 'mesh').map(async ({path, blob}) => {
			const old = this.files.find((file) => file.path === path);
			return old && !await sameBytes(old.blob, blob) ? [path] : [];
		}));
		this.setFiles([...this.files.filter((file) => !paths.has(file.path) && file.role !== once && !(setup && file.role === 'setup')), ...files], replaced.flat());
	}

	/** A file that a form wrote. @param {string} name @param {string} xml */
	async useFile(name, xml) {
		await this.add([[name, new Blob([xml], {type: 'application/xml'})]]);
		byId('files').scrollIntoView();
	}

	/** @param {JobFile[]} files @param {string[]} replaced meshes that took the place of others of the same name */
	setFiles(files, replaced = []) {
		this.files = inOrder(withLibraries(files));
		this.outdate();
		this.setup.propose(this.of('machine')[0]?.text ?? '', this.of('program').map(({text}) => text));
		byId('file-list').replaceChildren(...this.files.map((file) => element('li', {dataset: {role: file.role}},
			element('span', {className: 'role'}, file.role), element('span', {}, file.path), this.removeButton(file))));
		byId('empty').hidden = files.length === 0;
		this.showLacks(replaced);
		this.showButtons();
		document.dispatchEvent(new Event('files-shown'));
	}

	/** Results that are shown are about the files and options as they were. */
	outdate() {
		byId('outdated').hidden = byId('results').childElementCount === 0;
	}

	/** @param {JobFile} file */
	removeButton(file) {
		const button = element('button', {type: 'button', title: `Remove ${file.path}`, ariaLabel: `Remove ${file.path}`}, '×');
		button.addEventListener('click', () => this.setFiles(this.files.filter((other) => other !== file)));
		return button;
	}

	/** @param {import('./job_files.js').Role} role */
	of(role) {
		return this.files.filter((file) => file.role === role);
	}

	/** What a check of these files would lack, and what to do about it; none of it keeps the check from being made. @param {string[]} replaced */
	showLacks(replaced) {
		const missing = missingFiles(this.files), lacks = [], drawings = this.files.filter(({path}) => isDrawing(path));
		if (drawings.length)
			lacks.push(element('span', {className: 'lack'}, `Bodies are read from STL, OBJ and PLY files: export ${drawings.map(({path}) => path).join(', ')} as STL from the CAD system.`));
		for (const path of replaced)
			lacks.push(element('span', {className: 'lack'}, `Another ${path} took the place of the one that was here: all bodies that name ${path} have its shape now. Rename one of the two if they are different bodies.`));
		for (const {path} of this.files.filter(({text}) => /<jobs[\s>]/.test(text)))
			lacks.push(element('span', {className: 'lack'}, `${path} is a list of jobs for the command line. Here a check is of one job: drop the machine file, the setup and the programs of one of them.`));
		if (missing.length)
			lacks.push(element('span', {className: 'lack'}, `Not here yet: ${missing.join(', ')}. Drop them, too.`));
		if (this.of('machine').length && !this.of('setup').length && !this.of('machine').some(({text}) => /<setup[\s>]/.test(text)))
			lacks.push(element('span', {className: 'lack'}, 'Without a setup no tool, fixture or part is checked, and a program finds no length of a tool. ',
				element('a', {href: '#setup-title'}, 'Write a setup'), '.'));
		byId('job').replaceChildren(...lacks);
	}

	showButtons() {
		const machines = this.of('machine').length, programs = this.of('program').length, others = this.of('other').map(({path}) => path);
		const why = machines === 0 ? `A machine file is missing.${others.length ? ` There is no <machine> in ${others.join(', ')}.` : ''}`
			: machines > 1 ? 'There is more than one machine file: remove all but one.' : programs === 0 ? 'A program is missing: drop the NC program, too.' : '';
		byId('why-not').textContent = this.files.length ? why : 'Open an example, or your own files, first.';
		const check = /** @type {HTMLButtonElement} */ (byId('check')), cancel = byId('cancel'), focus = document.activeElement;
		check.disabled = why !== '' || this.running > 0;
		cancel.hidden = this.running === 0;
		// Who presses a button that goes finds the other one under the same key.
		if (focus === check && check.disabled)
			cancel.focus();
		if (focus === cancel && cancel.hidden)
			check.focus();
	}

	optionsOf() {
		const data = new FormData(/** @type {HTMLFormElement} */ (byId('options')));
		const typed = String(data.get('clearance')), clearance = readNumber(typed).number || typed.trim() || 0;
		return [`--clearance=${clearance}`, `--method=${data.get('method')}`, ...(data.get('all') ? ['--all'] : [])];
	}

	/** Every program in a worker of its own. */
	async check() {
		const files = withMeshes(this.files), machine = this.of('machine')[0].path, setup = this.of('setup')[0]?.path;
		const options = this.optionsOf();
		byId('results').replaceChildren();
		byId('outdated').hidden = true;
		this.reports.clear();
		const checks = this.of('program').map(async ({path}, i) => {
			const result = new ProgramResult(path, i < FIRST_REPORTS);
			byId('results').append(result.card);
			this.running++;
			this.showButtons();
			try {
				const checked = await this.client.check({files, machine, setup, programs: [path], options, report: true}, result);
				const report = checked.reports.get(path), blob = report && new Blob([/** @type {any} */ (report)], {type: 'text/html'});
				result.show(checked, blob);
				this.memory.set(path, checked.memory);
				if (blob)
					this.reports.set(path, blob);
			} catch (error) {
				if (error instanceof Cancelled)
					result.cancel();
				else
					result.fail(String(error));
			}
			this.running--;
			this.showButtons();
		});
		await Promise.all(checks);
		document.dispatchEvent(new Event('checked'));
	}
}

/**
 * All files below a dropped entry.
 * @param {FileSystemEntry} entry
 * @returns {Promise<[string, Blob][]>}
 */
async function filesBelow(entry) {
	if (entry.isFile) {
		/** @type {File} */
		const file = await new Promise((done, failed) => /** @type {FileSystemFileEntry} */ (entry).file(done, failed));
		return [[entry.fullPath.replace(/^\//, ''), file]];
	}
	const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader(), all = [];
	for (;;) {
		/** @type {FileSystemEntry[]} */
		const some = await new Promise((done, failed) => reader.readEntries(done, failed));
		if (some.length === 0)
			break;
		all.push(...some);
	}
	return (await Promise.all(all.map(filesBelow))).flat();
}

Object.assign(window, {fivecheckPage: new Page()});
if ('serviceWorker' in navigator)
	navigator.serviceWorker.register('service_worker.js');
