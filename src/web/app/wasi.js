// @ts-check
/**
 * wasi.js - an instance of the checker and the calls of WASI preview 1 that it makes; wasi_files.js has those for files.
 *
 * Nothing leaves the page: there is no network here, and there are no files except those of the run.
 */
import {E, WasiFiles} from './wasi_files.js';

const CLOCK_REALTIME = 0;

/** The program has ended. */
class Exit extends Error {
	/** @param {number} status */
	constructor(status) {
		super(`exit ${status}`);
		this.status = status;
	}
}

/** No loaded module has the required part; fivecheck(1) has no such status. */
export const LACKING = 4;

function lacking() {
	throw new Exit(LACKING);
}

/**
 * The modules of one build use names for shared objects that no other build has.
 * @param {WebAssembly.Module} part
 * @param {WebAssembly.Exports} first
 */
function addPart(part, first) {
	try {
		new WebAssembly.Instance(part, {first});
	} catch (error) {
		throw error instanceof WebAssembly.LinkError ?
			new Error('fivecheck.wasm and its parts are of different versions: load all of them again', {cause: error}) : error;
	}
}

/**
 * What a run is given and whom it tells; the first of `args` is the name of the program.
 * @typedef {import('./wasi_files.js').FileHost & {args: string[], environment?: Record<string, string>}} Host
 */

export class Wasi extends WasiFiles {
	/** @param {Host} host */
	constructor(host) {
		super(host);
		/** Each call of a session brings another one. */
		this.host = host;
		/** @type {WebAssembly.Instance | undefined} */
		this.instance = undefined;
		/** The program has ended, or has failed. */
		this.ended = false;
	}

	/**
	 * Makes an instance of the program; nothing runs yet. Its parts follow the first module, whose functions they
	 * call; their own functions replace those that stand for a missing part.
	 * @param {WebAssembly.Module[]} modules
	 */
	instantiate([first, ...parts]) {
		/** @type {Record<string, Record<string, Function>>} */
		const given = {};
		for (const { module: from, name } of WebAssembly.Module.imports(first)) {
			const call = /** @type {any} */ (this)[name];
			given[from] ??= {};
			given[from][name] = from !== 'wasi_snapshot_preview1' ? lacking : typeof call === 'function' ? call.bind(this) : () => E.NOSYS;
		}
		this.instance = new WebAssembly.Instance(first, /** @type {any} */ (given));
		for (const part of parts)
			addPart(part, this.instance.exports);
		this.memory = /** @type {WebAssembly.Memory} */ (this.instance.exports.memory);
	}

	/**
	 * Calls a function of the instance.
	 * @param {string} name
	 * @param {...number} args
	 * @returns {number} what it returned, or the exit status if the program has ended; then the instance is of no more use
	 */
	call(name, ...args) {
		try {
			return /** @type {any} */ (this.instance).exports[name](...args) ?? 0;
		} catch (error) {
			this.ended = true;
			if (error instanceof Exit)
				return error.status;
			throw error;
		}
	}

	/**
	 * Runs the program to its end.
	 * @param {WebAssembly.Module[]} modules
	 * @returns {number} the exit status
	 */
	run(modules) {
		this.instantiate(modules);
		return this.call('_start');
	}

	/**
	 * @param {number} at
	 * @param {string[]} texts
	 * @param {number} pointers
	 */
	putTexts(texts, pointers, at) {
		for (const text of texts) {
			const bytes = new TextEncoder().encode(text + '\0');
			this.view().setUint32(pointers, at, true);
			this.bytes(at, bytes.length).set(bytes);
			pointers += 4;
			at += bytes.length;
		}
		return E.SUCCESS;
	}

	/**
	 * @param {string[]} texts
	 * @param {number} count
	 * @param {number} size
	 */
	putSizes(texts, count, size) {
		this.view().setUint32(count, texts.length, true);
		this.view().setUint32(size, texts.reduce((sum, text) => sum + new TextEncoder().encode(text).length + 1, 0), true);
		return E.SUCCESS;
	}

	environment() {
		return Object.entries(this.host.environment ?? {}).map(([name, value]) => `${name}=${value}`);
	}

	/** @param {number} argv @param {number} buffer */
	args_get(argv, buffer) {
		return this.putTexts(this.host.args, argv, buffer);
	}

	/** @param {number} count @param {number} size */
	args_sizes_get(count, size) {
		return this.putSizes(this.host.args, count, size);
	}

	/** @param {number} pointers @param {number} buffer */
	environ_get(pointers, buffer) {
		return this.putTexts(this.environment(), pointers, buffer);
	}

	/** @param {number} count @param {number} size */
	environ_sizes_get(count, size) {
		return this.putSizes(this.environment(), count, size);
	}

	/** @param {number} clock @param {bigint} _precision @param {number} out */
	clock_time_get(clock, _precision, out) {
		const milliseconds = clock === CLOCK_REALTIME ? Date.now() : performance.now();
		this.view().setBigUint64(out, BigInt(Math.round(milliseconds * 1e6)), true);
		return E.SUCCESS;
	}

	/** @param {number} _clock @param {number} out */
	clock_res_get(_clock, out) {
		this.view().setBigUint64(out, 1000n, true);
		return E.SUCCESS;
	}

	/** @param {number} at @param {number} length */
	random_get(at, length) {
		crypto.getRandomValues(this.bytes(at, length));
		return E.SUCCESS;
	}

	/** @param {number} status */
	proc_exit(status) {
		throw new Exit(status);
	}

	sched_yield() {
		return E.SUCCESS;
	}
}
