// @ts-check
/**
 * modules.js - the modules of the checker, of which a page loads those that its jobs need: fivecheck.wasm, with the
 * controls whose programs are ISO codes, and its parts.
 */
import {FIRST, PARTS, compileAnswer} from './fivecheck.js';

/** Character references and entities may hide a word from a search of the text. */
const HIDDEN = /&#|<!DOCTYPE/;

/**
 * The parts that a job needs in addition to the first module; all of them if this is uncertain.
 * @param {string} machine the text of its file @param {string} [setup] @param {string[]} [options]
 */
export function partsOf(machine, setup = '<setup', options = []) {
	const dialect = options.find((option) => option.startsWith('--dialect='));
	if (!/<machine\b/.test(machine) || HIDDEN.test(machine) || !/<setup\b/.test(setup) || HIDDEN.test(setup))
		return PARTS;
	const control = machine + dialect, any = dialect === '--dialect=auto';
	const wanted = [any || /klartext/i.test(control), any || /sinumerik/i.test(control), /<tools\b/.test(machine + setup) || options.some((option) => option.startsWith('--sensitivity='))];
	return PARTS.filter((_, i) => wanted[i]);
}

/** @param {string | Blob | undefined} file */
async function textOf(file) {
	return file instanceof Blob ? file.text() : file;
}

/**
 * The answer of the server.
 * @param {string | URL} address @param {string} name that a failure is told by
 * @returns {Promise<Response>} whose status is good
 */
export async function fetched(address, name) {
	const response = await fetch(address).catch(({message}) => {
		throw new Error(`${name} cannot be loaded: ${message}`);
	});
	if (!response.ok)
		throw new Error(`${name} cannot be loaded: the server answers ${response.status}`);
	return response;
}

export class Modules {
	/** @param {string | URL} folder the page's */
	constructor(folder) {
		this.folder = folder;
		/** @type {Map<string, Promise<WebAssembly.Module>>} */
		this.loaded = new Map();
		/** @type {Promise<string> | undefined} */
		this.script = undefined;
		this.load(FIRST);
	}

	/** @param {string} name */
	fetch(name) {
		return fetched(new URL(name, this.folder), name);
	}

	/** @param {string} name */
	async compile(name) {
		if (!globalThis.WebAssembly)
			throw new Error('This browser has no WebAssembly, or a setting of it forbids it here: allow it for this page, or take another browser');
		const answer = await this.fetch(name);
		return compileAnswer(answer).catch(({message}) => {
			throw new Error(`${name} cannot be loaded: ${message}. Load the page again; if that does not help, its server is at fault.`);
		});
	}

	/** Each module is loaded once, and again after a failure. @param {string} name */
	load(name) {
		const module = this.loaded.get(name) ?? this.compile(name);
		this.loaded.set(name, module);
		module.catch(() => this.loaded.delete(name));
		return module;
	}

	/** The modules for a job. @param {string | Blob | undefined} machine @param {string | Blob} [setup] @param {string[]} [options] */
	async of(machine, setup, options) {
		const parts = partsOf(await textOf(machine) ?? '', await textOf(setup), options);
		return Promise.all([FIRST, ...parts].map((name) => this.load(name)));
	}

	/** The script that reports carry. */
	viewer() {
		this.script ??= this.fetch('viewer.js').then((response) => response.text());
		this.script.catch(() => this.script = undefined);
		return this.script;
	}
}
