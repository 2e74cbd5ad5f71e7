// @ts-check
/**
 * session_client.js - sends queries to a machine that stays loaded in a worker: checks of a program, clearances at a
 * pose.
 */

/** @typedef {import('./fivecheck.js').Result} Result */
/** @typedef {import('./fivecheck.js').Pose} Pose */

export class SessionClient {
	/**
	 * @param {Promise<WebAssembly.Module[]>} modules
	 * @param {[string, string | Blob][]} files
	 * @param {{machine: string, setup?: string}} job
	 */
	constructor(modules, files, job) {
		this.worker = new Worker(new URL('session_worker.js', import.meta.url), {type: 'module'});
		/** @type {Map<number, {resolve: (answer: any) => void, reject: (reason: Error) => void}>} */
		this.waiting = new Map();
		this.count = 0;
		this.worker.onmessage = ({data: {id, answer, failed}}) => {
			const {resolve, reject} = this.waiting.get(id) ?? {};
			this.waiting.delete(id);
			if (failed) reject?.(new Error(failed));
			else resolve?.(answer);
		};
		this.worker.onerror = ({message}) => this.fail(new Error(message || 'session_worker.js cannot be loaded, or has ended: load the page again'));
		this.opened = modules.then((compiled) => this.ask({open: {modules: compiled, files, job}}));
	}

	/** @param {Error} reason */
	fail(reason) {
		this.waiting.forEach(({reject}) => reject(reason));
		this.waiting.clear();
	}

	/** @param {Record<string, any>} question @returns {Promise<any>} */
	ask(question) {
		return new Promise((resolve, reject) => {
			this.waiting.set(++this.count, {resolve, reject});
			this.worker.postMessage({...question, id: this.count});
		});
	}

	/**
	 * @param {{name: string, text: string, options?: string[], report?: boolean}} program
	 * @returns {Promise<Result>}
	 */
	async check(program) {
		await this.opened;
		return this.ask({check: program});
	}

	/**
	 * @param {Record<string, number>} axes @param {number} tool
	 * @returns {Promise<Pose>}
	 */
	async pose(axes, tool) {
		await this.opened;
		return this.ask({pose: {axes, tool}});
	}

	close() {
		this.worker.terminate();
		this.fail(new Error('closed'));
	}
}

/**
 * Handles the newest of many requests: while one runs, only the last one of those that arrive is kept.
 * @template T
 */
export class Newest {
	/** @param {(request: T) => Promise<void>} carryOut */
	constructor(carryOut) {
		this.carryOut = carryOut;
		/** @type {T | undefined} */
		this.next = undefined;
		this.busy = false;
	}

	/** @param {T} request */
	async put(request) {
		this.next = request;
		if (this.busy)
			return;
		this.busy = true;
		while (this.next !== undefined) {
			const now = this.next;
			this.next = undefined;
			await this.carryOut(now);
		}
		this.busy = false;
	}
}
