// @ts-check
/** learn.js - the page to learn with: axes moved by hand, blocks that are checked while they are written, the tour. */
import {Client} from './client.js';
import {takeDrops, unpacked} from './dropped.js';
import {Editor} from './editor.js';
import {FIRST_PROGRAMS} from './first_programs.js';
import {exampleFiles, examplesOf, isClutter, jobFile, missingFiles, withMeshes} from './job_files.js';
import {Jog} from './jog.js';
import {keepOffline} from './offline.js';
import {byId, element} from './page.js';
import {SessionClient} from './session_client.js';
import {showPairs, startTour} from './tour.js';
import {readReport} from './viewer/report.js';

/** @typedef {import('./job_files.js').JobFile} JobFile */
/** @typedef {import('./viewer/model.js').Model} Model */

/** Bytes of a program that can be checked at every key. */
const LONGEST = 100000;

/** The tools of a setup. @param {JobFile | undefined} setup @returns {{number: number, name: string}[]} */
function toolsOf(setup) {
	const found = setup ? new DOMParser().parseFromString(setup.text, 'application/xml').querySelectorAll('tool[number]') : [];
	return [...found].map((tool) => ({number: Number(tool.getAttribute('number')), name: tool.getAttribute('name') ?? ''}));
}

/**
 * A few blocks for any machine: a move to the start position, axis by axis.
 * @param {string} machine its file @param {Model} model @param {{number: number, name: string}[]} tools
 */
function firstBlocks(machine, model, tools) {
	const home = model.path.pose(0).values.map((value, i) => `${model.axes[i].letter}${Number(value.toFixed(4))}`), [tool] = tools;
	if (/\bdialect=["']klartext["']/.test(machine))
		return `BEGIN PGM NEW MM\n${tool ? `TOOL CALL ${tool.number} Z S1000\n` : ''}${home.map((word) => `L ${word.replace(/^(.)(?!-)/, '$1+')} R0 FMAX M91\n`).join('')}END PGM NEW MM\n`;
	return `G21 G90 G94\n${tool ? `T${tool.number} M6\n` : ''}${home.map((word) => `G53 G0 ${word}\n`).join('')}M2\n`;
}

/**
 * The bodies of the machine with all tools, from a report that the checker writes; its data is put where the viewer
 * expects it.
 * @param {Uint8Array} report @returns {Promise<Model>}
 */
function modelOf(report) {
	const page = new TextDecoder().decode(report), data = page.matchAll(/<script type="text\/plain" id="(fivecheck-head|blob-\d+)">([^<]*)<\/script>/g);
	byId('model-data').replaceChildren(...[...data].map(([, id, textContent]) => element('script', {type: 'text/plain', id, textContent})));
	return readReport();
}

class LearnPage {
	constructor() {
		this.client = new Client(new URL('.', import.meta.url));
		/** @type {SessionClient | undefined} */
		this.session = undefined;
		/**
		 * The machine that is being loaded; the one before stays until it is loaded.
		 * @type {SessionClient | undefined}
		 */
		this.opening = undefined;
		/** Machines that are being loaded. */
		this.loading = 0;
		/** The same machine once more, for the editor. @type {SessionClient | undefined} */
		this.scout = undefined;
		/** @type {Jog | undefined} */
		this.jog = undefined;
		/** @type {Editor | undefined} */
		this.editor = undefined;
		/** @type {Model | undefined} */
		this.model = undefined;
		startTour(this.client, () => this.jog?.showPlane(true));
		this.offerExamples();
		keepOffline(() => this.loading > 0);
		const choose = /** @type {HTMLInputElement} */ (byId('choose'));
		choose.addEventListener('change', () => {
			this.told(this.take([...(choose.files ?? [])].map((file) => [file.name, file])));
			choose.value = '';
		});
		takeDrops(byId('machines'), (found) => this.told(this.take(found)));
	}

	/** Opens a machine of the user. @param {[string, Blob][]} found */
	async take(found) {
		const {files, faults} = await unpacked(found);
		if (faults.length)
			throw new Error(faults.join(' '));
		await this.open('', await Promise.all(files.filter(([path]) => !isClutter(path)).map(([path, blob]) => jobFile(path, blob))));
	}

	async offerExamples() {
		const examples = await examplesOf(byId('examples'));
		for (const name of examples) {
			const button = element('button', {type: 'button', dataset: {example: name}, ariaPressed: 'false'}, name);
			button.addEventListener('click', () => this.told(this.openExample(name)));
			byId('examples').append(button);
		}
		if (examples.length)
			await this.told(this.openExample(examples[0]));
		document.dispatchEvent(new Event('fivecheck-ready'));
	}

	/** An error that prevents opening a machine is shown in place of its name. @param {Promise<void>} opening */
	async told(opening) {
		const say = byId('machine-name'), before = this.model?.machine;
		this.loading++;
		await opening.catch(({message}) => say.textContent = `This machine cannot be shown: ${message.trim()}${before === undefined ? '' : `\nWhat stands below is ${before || 'the machine before'}.`}`);
		this.loading--;
	}

	/** @param {string} name */
	async openExample(name) {
		await this.open(name, (await exampleFiles(name)).filter(({role}) => role !== 'program'));
	}

	/** @param {string} name of the example, or '' @param {JobFile[]} files */
	async open(name, files) {
		const [machine, setup, program] = ['machine', 'setup', 'program'].map((wanted) => files.find(({role}) => role === wanted));
		const say = byId('machine-name'), missing = missingFiles(files);
		if (!machine)
			throw new Error('a machine file is missing');
		if (missing.length)
			throw new Error(`not here: ${missing.join(', ')}; choose these files together with the machine file`);
		say.textContent = 'Loading …';
		const modules = this.client.modules.of(machine.blob, setup?.blob), all = withMeshes(files), job = {machine: machine.path, setup: setup?.path};
		const session = this.opening = new SessionClient(modules, all, job);
		const tools = toolsOf(setup), start = `${tools.map(({number}) => `T${number} M6\n`).join('')}M2\n`;
		const {reports, messages} = await session.check({name: 'start.nc', text: start, options: ['--dialect=linuxcnc'], report: true});
		const report = reports.get('start.nc');
		if (session !== this.opening || !report)
			session.close();
		if (session !== this.opening)
			return;
		if (!report)
			throw new Error(messages);
		this.session?.close();
		this.scout?.close();
		this.session = session;
		this.scout = new SessionClient(modules, all, job);
		const model = await modelOf(report), text = program && program.blob.size <= LONGEST ? await program.blob.text() : FIRST_PROGRAMS[name]?.blocks ?? firstBlocks(machine.text, model, tools);
		byId('examples').querySelectorAll('button').forEach((button) => button.ariaPressed = String(button.dataset.example === name));
		byId('try').textContent = text === FIRST_PROGRAMS[name]?.blocks ? FIRST_PROGRAMS[name].change : '';
		await this.show(model, session, this.scout, tools, text, FIRST_PROGRAMS[name]?.start);
		if (program && program.blob.size > LONGEST)
			say.textContent = `${model.machine}. ${program.path} is too long for the editor: check it on the other page.`;
	}

	/** @param {Model} model @param {SessionClient} session @param {SessionClient} scout @param {{number: number, name: string}[]} tools @param {string} blocks @param {Record<string, number>} [start] where the axes stand first */
	async show(model, session, scout, tools, blocks, start) {
		this.model = model;
		byId('machine-name').textContent = model.machine;
		showPairs(model, (links) => this.jog?.showLinks(links));
		try {
			this.jog = new Jog(model, session, tools);
			this.jog.show(byId('jog'), start);
		} catch (error) {
			this.jog = undefined;
			byId('jog').textContent = `There is no picture here: ${error}`;
		}
		this.editor = new Editor(session, scout, blocks, (event) => this.jog?.showFinding(event));
		byId('editor').replaceChildren(this.editor.element);
		await this.editor.typed();
		document.dispatchEvent(new Event('machine-open'));
	}
}

Object.assign(window, {learnPage: new LearnPage()});
