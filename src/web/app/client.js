// @ts-check
/**
 * client.js - jobs of the checker in workers of their own: the page stays alive, and a job can be cancelled.
 */
import {FIRST} from './fivecheck.js';
import {Modules} from './modules.js';

/** @typedef {import('./fivecheck.js').Result} Result */
/**
 * Whom a job tells.
 * @typedef {object} Listener
 * @property {(event: Record<string, any>) => void} [onEvent]
 * @property {(message: string) => void} [onMessage]
 * @property {(part: number) => void} [onProgress]
 */

/** A job was cancelled. */
export class Cancelled extends Error {}

export class Client {
	/** @param {string | URL} folder with the modules */
	constructor(folder) {
		this.modules = new Modules(folder);
		/** @type {Set<(reason: Error) => void>} */
		this.running = new Set();
		/** @type {{start: () => void, cancel: (reason: Error) => void}[]} jobs that wait for a processor */
		this.waiting = [];
		/** The worker of the next job. @type {Worker | undefined} */
		this.spare = undefined;
		this.free = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 8) - 1);
	}

	newWorker() {
		return new Worker(new URL('worker.js', import.meta.url), {type: 'module'});
	}

	/** A check is likely to come: loads what each needs, as long as its files are not here. */
	prepare() {
		this.spare ??= this.newWorker();
		this.spare.onerror = () => this.spare = undefined;
		this.modules.viewer().catch(() => undefined);
	}

	/** Waits for a processor. */
	async begin() {
		if (this.free > 0)
			this.free--;
		else
			await new Promise((/** @type {(value?: unknown) => void} */ start, cancel) => this.waiting.push({start, cancel}));
	}

	end() {
		const next = this.waiting.shift();
		if (next)
			next.start();
		else
			this.free++;
	}

	/**
	 * @param {Record<string, any>} message
	 * @param {WebAssembly.Module[]} modules
	 * @param {Listener} listener
	 * @returns {Promise<any>}
	 */
	async post(message, modules, listener = {}) {
		await this.begin();
		const worker = this.spare ?? this.newWorker();
		this.spare = undefined;
		/** @type {((reason: Error) => void) | undefined} */
		let cancel;
		try {
			return await new Promise((resolve, reject) => {
				cancel = reject;
				this.running.add(reject);
				worker.onerror = (event) => reject(new Error(event.message || 'the worker has ended'));
				worker.onmessage = ({data}) => {
					if (data.event) listener.onEvent?.(data.event);
					if (data.message) listener.onMessage?.(data.message);
					if (data.progress) listener.onProgress?.(data.progress);
					if (data.done) resolve(data.done);
					if (data.failed) reject(new Error(data.failed));
				};
				worker.postMessage({...message, modules});
			});
		} finally {
			worker.terminate();
			if (cancel) this.running.delete(cancel);
			this.end();
		}
	}

	/**
	 * Checks one job: `Job` of fivecheck.js, with its files as pairs of a path and a File or a text.
	 * @param {Omit<import('./fivecheck.js').Job, 'files'> & {files: [string, string | Blob][]}} job
	 * @param {Listener} listener
	 * @returns {Promise<Result>}
	 */
	async check({files, ...job}, listener) {
		const [machine, setup] = [job.machine, job.setup].map((wanted) => files.find(([path]) => path === wanted)?.[1]);
		const [modules, viewer] = await Promise.all([this.modules.of(machine, setup, job.options), job.report ? this.modules.viewer() : undefined]);
		return this.post({files, job, viewer}, modules, listener);
	}

	/**
	 * Runs a command line.
	 * @param {string[]} args
	 * @param {[string, string | Blob][]} files
	 * @param {string[]} parts that it needs besides the first module
	 * @returns {Promise<{status: number, out: string, err: string}>}
	 */
	async run(args, files = [], parts = []) {
		return this.post({files, args}, await Promise.all([FIRST, ...parts].map((name) => this.modules.load(name))));
	}

	/** Ends all jobs that run, and those that wait. */
	cancel() {
		for (const reject of [...this.waiting.splice(0).map(({cancel}) => cancel), ...this.running])
			reject(new Cancelled('cancelled'));
	}
}
