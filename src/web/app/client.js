// @ts-check
/**
 * client.js - runs jobs of the checker in separate workers: the page stays responsive, and a job can be cancelled.
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
		/**
		 * Jobs that wait for a processor.
		 * @type {{files: unknown, start: (worker?: Worker) => void, cancel: (reason: Error) => void}[]}
		 */
		this.waiting = [];
		/** The worker of the next job. @type {Worker | undefined} */
		this.spare = undefined;
		this.free = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 8) - 1);
	}

	newWorker() {
		return new Worker(new URL('worker.js', import.meta.url), {type: 'module'});
	}

	/** A check will probably follow: loads the parts that every check needs, while its files are not there yet. */
	prepare() {
		this.spare ??= this.newWorker();
		this.spare.onerror = () => this.spare = undefined;
		this.modules.viewer().catch(() => undefined);
	}

	/**
	 * Waits for a processor.
	 * @param {unknown} files of the job
	 * @returns {Promise<Worker | undefined>} that of the job before, if it has the same files
	 */
	async begin(files) {
		if (this.free > 0)
			this.free--;
		else
			return new Promise((start, cancel) => this.waiting.push({files, start, cancel}));
	}

	/**
	 * A processor is free; the worker continues with the next job if it has the same files.
	 * @param {unknown} files @param {Worker} [worker]
	 */
	end(files, worker) {
		const next = this.waiting.shift(), same = next && next.files === files;
		if (!same)
			worker?.terminate();
		if (next)
			next.start(same ? worker : undefined);
		else
			this.free++;
	}

	/**
	 * The result of the promise, unless the jobs are cancelled before.
	 * @template T
	 * @param {Promise<T>} promise
	 * @returns {Promise<T>}
	 */
	async unlessCancelled(promise) {
		/** @type {(reason: Error) => void} */
		let cancel = () => undefined;
		try {
			return await Promise.race([promise, new Promise((_, reject) => this.running.add(cancel = reject))]);
		} finally {
			this.running.delete(cancel);
		}
	}

	/**
	 * @param {Record<string, any> & {files: unknown}} message
	 * @param {WebAssembly.Module[]} modules
	 * @param {Listener} listener
	 * @returns {Promise<any>}
	 */
	async post(message, modules, listener = {}) {
		const {files, ...job} = message, known = await this.begin(files), worker = known ?? this.spare ?? this.newWorker();
		let good = false;
		if (worker === this.spare)
			this.spare = undefined;
		try {
			const done = await this.unlessCancelled(new Promise((resolve, reject) => {
				worker.onerror = (event) => reject(new Error(event.message || 'worker.js cannot be loaded, or has ended: load the page again'));
				worker.onmessage = ({data}) => {
					if (data.event) listener.onEvent?.(data.event);
					if (data.message) listener.onMessage?.(data.message);
					if (data.progress) listener.onProgress?.(data.progress);
					if (data.done) resolve(data.done);
					if (data.failed) reject(new Error(data.failed));
				};
				worker.postMessage({...job, ...(known ? {} : {files}), modules});
			}));
			good = true;
			return done;
		} finally {
			if (!good)
				worker.terminate();
			this.end(files, good ? worker : undefined);
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
		const [modules, viewer] = await this.unlessCancelled(Promise.all([this.modules.of(machine, setup, job.options), job.report ? this.modules.viewer() : undefined]));
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
		return this.post({files, args}, await this.unlessCancelled(Promise.all([FIRST, ...parts].map((name) => this.modules.load(name)))));
	}

	/** Ends all jobs: running ones, waiting ones, and those that still load their modules. */
	cancel() {
		for (const reject of [...this.waiting.splice(0).map(({cancel}) => cancel), ...this.running])
			reject(new Cancelled('cancelled'));
	}
}
