// @ts-check
/**
 * modules.js - the two modules of the checker, of which a page loads what it needs: fivecheck-iso.wasm reads programs for
 * LinuxCNC, Fanuc and Haas; fivecheck.wasm has everything.
 */

/** What may hide a word from a look at the text: character references and entities. */
const HIDDEN = /&#|<!DOCTYPE/;

/**
 * Surely a job for the smaller module, which reads no programs of the other controls and no tool libraries?
 * @param {string} machine the text of its file @param {string} [setup]
 */
export function isIso(machine, setup = '<setup') {
	return /<machine\b/.test(machine) && !/sinumerik|klartext/i.test(machine) && !HIDDEN.test(machine)
		&& /<setup\b/.test(setup) && !/<tools\b/.test(setup) && !HIDDEN.test(setup);
}

/** @param {string | Blob | undefined} file */
async function textOf(file) {
	return file instanceof Blob ? file.text() : file;
}

export class Modules {
	/** @param {string | URL} folder the page's */
	constructor(folder) {
		this.folder = folder;
		this.iso = this.compile('fivecheck-iso.wasm');
		/** @type {Promise<WebAssembly.Module> | undefined} */
		this.all = undefined;
		/** @type {Promise<string> | undefined} */
		this.script = undefined;
	}

	/** @param {string} name */
	compile(name) {
		return WebAssembly.compileStreaming(fetch(new URL(name, this.folder)));
	}

	/** The module for a job with these files. @param {string | Blob | undefined} machine @param {string | Blob} [setup] */
	async of(machine, setup) {
		return isIso(await textOf(machine) ?? '', await textOf(setup)) ? this.iso : this.all ??= this.compile('fivecheck.wasm');
	}

	/** The script that reports carry. */
	viewer() {
		return this.script ??= fetch(new URL('viewer.js', this.folder)).then((response) => response.text());
	}
}
