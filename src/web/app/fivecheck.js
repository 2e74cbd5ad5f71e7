// @ts-check
/**
 * fivecheck.js - the checker for other programs in JavaScript: in a browser's worker, in node, in Deno. README.md has
 * an example.
 *
 * A run is one call that returns when it has ended; a page that must stay responsive makes it in a worker (client.js).
 * Nothing is sent anywhere.
 */
import {Files, FileNode} from './files.js';
import {LACKING, Wasi} from './wasi.js';

/** Exit statuses. The last one is not in fivecheck(1): a part of the checker was not loaded. */
export const STATUS = {CLEAR: 0, FOUND: 1, INCOMPLETE: 2, INTERNAL: 3, LACKING};

/**
 * One job.
 * @typedef {object} Job
 * @property {Files} files every file that the job needs
 * @property {string} machine the path of the machine file in `files`
 * @property {string} [setup]
 * @property {string[]} programs
 * @property {string[]} [options] of the command line, as `--all` or `--clearance=2`
 * @property {boolean} [report] write a report to look at
 * @property {(event: Record<string, any>) => void} [onEvent] each line of NDJSON as it comes (fivecheck(1), "ndjson")
 * @property {(message: string) => void} [onMessage] what the command line would say on standard error
 * @property {(part: number) => void} [onProgress] how much of all programs was read to be checked, 0 to 1
 */

/**
 * What a job came to.
 * @typedef {object} Result
 * @property {number} status see STATUS
 * @property {string} text the report in words, as the command line prints it
 * @property {Record<string, any>[]} events all lines of NDJSON
 * @property {string} messages
 * @property {Map<string, Uint8Array>} reports by the path of the program
 * @property {number} memory bytes that the checker took at most; files that were read or written are not among them
 */

/** The modules of the checker: the first one for every job, the others for special tasks (README.md). */
export const FIRST = 'fivecheck.wasm', MORE = 'fivecheck-more.wasm', PARTS = ['fivecheck-klartext.wasm', 'fivecheck-sinumerik.wasm', MORE];

const RESULTS = '/tmp/fivecheck';
/** The file from which the checker reads the script of reports (src/wasi/viewer.c). */
const VIEWER = `${RESULTS}/viewer.js`;

/** The job needs a part of the checker that was not loaded, or a report lacks viewer.js. */
export class PartLacking extends Error {
	constructor() {
		super('a part of the checker was not loaded: load all of PARTS, and for a report give the text of viewer.js');
	}
}

/** @param {number} status @returns {number} the status of a run that came to its end */
function statusOf(status) {
	if (status === STATUS.LACKING)
		throw new PartLacking();
	return status;
}

/** Where a module is, its bytes, or the module. @typedef {string | URL | BufferSource | WebAssembly.Module} Source */

/** Compiles while loading, unless the server gives the module a wrong type. @param {Response} answer */
export async function compileAnswer(answer) {
	return answer.headers.get('Content-Type') === 'application/wasm' ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** @param {Source} source */
async function compiled(source) {
	if (source instanceof WebAssembly.Module)
		return source;
	return typeof source === 'string' || source instanceof URL ? compileAnswer(await fetch(source)) : WebAssembly.compile(source);
}

/** Splits bytes into whole lines. */
class Lines {
	/** @param {(line: string) => void} tell */
	constructor(tell) {
		this.tell = tell;
		this.decoder = new TextDecoder();
		this.rest = '';
	}

	/** @param {Uint8Array} bytes */
	add(bytes) {
		const lines = (this.rest + this.decoder.decode(bytes, {stream: true})).split('\n');
		this.rest = lines.pop() ?? '';
		lines.forEach(this.tell);
	}
}

export class Fivecheck {
	/** @param {WebAssembly.Module[]} modules @param {string} [viewer] see load */
	constructor(modules, viewer) {
		this.modules = modules;
		this.viewer = viewer;
	}

	/**
	 * @param {Source | Source[]} sources of fivecheck.wasm and of the parts that are needed, in this order
	 * @param {string} [viewer] the text of viewer.js, which reports need
	 */
	static async load(sources, viewer) {
		return new Fivecheck(await Promise.all([sources].flat().map(compiled)), viewer);
	}

	/**
	 * Runs a command line, as a shell would; paths are those of `files`, relative to its root.
	 * @param {string[]} args without the program's name
	 * @param {Files} files
	 * @param {{input?: Uint8Array, environment?: Record<string, string>, onOutput?: (fd: 1 | 2, bytes: Uint8Array) => void,
	 *	onRead?: (node: FileNode, offset: number) => void}} [more]
	 * @returns {{status: number, out: string, err: string, memory: number}} what it printed is there unless `onOutput` was given
	 */
	run(args, files, more = {}) {
		const decoders = [new TextDecoder(), new TextDecoder()], texts = ['', ''];
		/** @param {1 | 2} fd @param {Uint8Array} bytes */
		const keep = (fd, bytes) => {
			texts[fd - 1] += decoders[fd - 1].decode(bytes, {stream: true});
		};
		if (this.viewer)
			files.add(VIEWER, this.viewer);
		const wasi = new Wasi({args: ['fivecheck', ...args], files, onOutput: keep, ...more});
		const status = statusOf(wasi.run(this.modules));
		return {status, out: texts[0], err: texts[1], memory: wasi.memory.buffer.byteLength};
	}

	/**
	 * Checks programs.
	 * @param {Job} job
	 * @returns {Result}
	 */
	check(job) {
		if (job.report && !this.viewer)
			throw new PartLacking();
		return collect(job, (more) => this.run(argumentsOf(job), job.files, more));
	}

	/**
	 * A machine that stays loaded: for a program that is checked repeatedly, and for axes that are moved by hand.
	 * @param {Files} files
	 */
	session(files) {
		if (this.viewer)
			files.add(VIEWER, this.viewer);
		return new Session(this.modules, files);
	}

	/**
	 * Writes a machine file: `fivecheck init` with these arguments; needs MORE.
	 * @param {string[]} args
	 * @param {Files} [files]
	 */
	init(args, files = new Files()) {
		const {status, out, err} = this.run(['init', ...args], files);
		return {status, xml: out, messages: err};
	}
}

/**
 * Runs a job and collects what it prints.
 * @param {Job} job
 * @param {(host: {onOutput: (fd: 1 | 2, bytes: Uint8Array) => void, onRead?: (node: FileNode, offset: number) => void}) => {status: number, memory: number}} run
 * @returns {Result}
 */
function collect(job, run) {
	/** @type {Record<string, any>[]} */
	const events = [], progress = progressOf(job);
	let messages = '';
	const out = new Lines((line) => {
		const event = JSON.parse(line);
		events.push(event);
		job.onEvent?.(event);
	});
	const err = new Lines((line) => {
		messages += line + '\n';
		job.onMessage?.(line);
	});
	job.files.folder(RESULTS);
	const {status, memory} = run({
		onOutput: (fd, bytes) => (fd === 1 ? out : err).add(bytes),
		// The first line has digests of all files, which are read for this; the check begins after it.
		onRead: (node, offset) => events.length && progress?.(node, offset),
	});
	err.add(new TextEncoder().encode('\n'));
	return {status, text: textOf(job.files, `${RESULTS}/verdict.txt`), events, messages: messages.trimEnd(), reports: reportsOf(job), memory};
}

/** @param {Job} job */
function argumentsOf(job) {
	return ['--format=ndjson', `--format=text=${RESULTS}/verdict.txt`, '--progress=none', ...(job.options ?? []),
		...(job.report ? [`--report=${RESULTS}/report.html`] : []), ...(job.setup ? [`--setup=${job.setup}`] : []),
		'--', job.machine, ...job.programs];
}

/**
 * How near the bodies are while the axes stand still (a line of `session_pose`, src/report/pose_json.h).
 * @typedef {object} Pose
 * @property {Record<string, number>} axes mm and degrees
 * @property {number} tool
 * @property {number} pairs that must stay apart
 * @property {{a: string, b: string, distance: number, on_a: number[], on_b: number[]} | null} nearest of those that are apart
 * @property {[string, string][]} meets those that overlap
 * @property {[string, string][]} near those within their clearance
 * @property {[string, string][]} unknown those that could not be decided
 */

/** The instance has ended, so the session can no longer be used; usually there was no memory left. */
export class SessionEnded extends Error {}

export class Session {
	/**
	 * @param {WebAssembly.Module[]} modules
	 * @param {Files} files of all jobs; what is loaded of them is not read again
	 */
	constructor(modules, files) {
		this.files = files;
		this.wasi = new Wasi({args: [], files});
		this.wasi.instantiate(modules);
		this.handle = this.wasi.call('session_new');
	}

	/**
	 * @param {string} name
	 * @param {string[]} args
	 * @param {{onOutput: (fd: 1 | 2, bytes: Uint8Array) => void, onRead?: (node: FileNode, offset: number) => void}} more
	 */
	call(name, args, more) {
		if (this.wasi.ended)
			throw new SessionEnded('the session has ended');
		this.wasi.host = {args: ['fivecheck', ...args], files: this.files, ...more};
		const status = statusOf(this.wasi.call(name, this.handle));
		if (this.wasi.ended)
			throw new SessionEnded(`the checker has ended with the status ${status}`);
		return status;
	}

	/**
	 * Like Fivecheck.check. The first job loads the machine; a job with another machine, setup or clearance loads
	 * it again. Programs are read again each time.
	 * @param {Omit<Job, 'files'>} job
	 * @returns {Result}
	 */
	check(job) {
		const all = {...job, files: this.files};
		return collect(all, (more) => ({status: this.call('session_check', argumentsOf(all), more), memory: this.wasi.memory.buffer.byteLength}));
	}

	/**
	 * The distances of the bodies at one pose; call it after a check.
	 * @param {Record<string, number>} axes by letter, mm and degrees; the others stand at home
	 * @param {number} [tool] in the spindle
	 * @returns {Pose}
	 */
	pose(axes, tool = 0) {
		const decoders = [new TextDecoder(), new TextDecoder()], texts = ['', ''];
		const words = Object.entries(axes).map(([letter, value]) => `${letter}=${value}`);
		this.call('session_pose', [...words, `T=${tool}`], {
			onOutput: (fd, bytes) => texts[fd - 1] += decoders[fd - 1].decode(bytes, {stream: true}),
		});
		if (!texts[0])
			throw new Error(texts[1].trim());
		return JSON.parse(texts[0]);
	}
}

/** @param {Job} job */
function progressOf(job) {
	const nodes = job.programs.map((path) => job.files.find(path));
	const read = new Map(), told = job.onProgress;
	const total = nodes.reduce((sum, node) => sum + (node instanceof FileNode ? node.source.size : 0), 0);
	let last = 0;
	if (!told || !total)
		return undefined;
	return (/** @type {FileNode} */ node, /** @type {number} */ offset) => {
		if (!nodes.includes(node))
			return;
		read.set(node, Math.min(offset, node.source.size));
		const part = [...read.values()].reduce((sum, size) => sum + size, 0) / total;
		if (part - last >= 0.005 || (part >= 1 && last < 1)) {
			last = part;
			told(part);
		}
	};
}

/**
 * @param {Files} files
 * @param {string} path
 */
function textOf(files, path) {
	const bytes = files.contents(path);
	return bytes ? new TextDecoder().decode(bytes) : '';
}

/** @param {Job} job */
function reportsOf(job) {
	/** @type {Map<string, Uint8Array>} */
	const reports = new Map();
	const bytes = job.report ? job.files.contents(`${RESULTS}/report.html`) : undefined;
	if (bytes && job.programs.length === 1)
		reports.set(job.programs[0], bytes);
	return reports;
}
