// @ts-check
/** checks.js - the checks that the page makes: of all programs, or of all jobs of a job file; each has a card, unless there are very many. */
import {commandLine, copyField} from './check_options.js';
import {Cancelled} from './client.js';
import {PARTS} from './fivecheck.js';
import {inTheirFolder, unreadable, withMeshes} from './job_files.js';
import {jobsIn, messagesAt} from './job_list.js';
import {JobResult} from './job_result.js';
import {reveal} from './page.js';
import {ProgramResult} from './program_result.js';
import {VerdictList} from './verdict_list.js';

/** @typedef {import('./job_files.js').JobFile} JobFile */
/** @typedef {import('./job_list.js').ListedJob} ListedJob */
/** Programs that the command line takes together; `result` is there for a job of a job file. @typedef {{job: ListedJob, result?: JobResult, fault?: Promise<string>}} Group */
/** One check. @typedef {{group: Group, program: string, card?: ProgramResult}} Run */

/** At first only this many reports are shown, the others on request: a browser draws only a few pictures at a time. */
const FIRST_REPORTS = 4;
/**
 * At most this many programs have a card and a report; of the others, those that are not clear have a card, up to the
 * same number.
 */
const MOST_CARDS = 200;
/** At most this many checks are started at a time; the client decides which of them has a processor. */
const BEGUN = 16;
/** The first lines of a program, which show its control, are searched up to this number of bytes. */
const LOOK = 1 << 18;

export class Checks {
	/** @param {import('./client.js').Client} client @param {HTMLElement} place of the results */
	constructor(client, place) {
		this.client = client;
		this.place = place;
		/** @type {Map<string, Blob>} by the path of the program */
		this.reports = new Map();
		/** @type {Map<string, number>} bytes that the check of a program took */
		this.memory = new Map();
		/** @type {ProgramResult[]} */
		this.cards = [];
		this.cancelled = false;
	}

	/** Removes the results of earlier checks, and closes what they have open. */
	clear() {
		this.cards.splice(0).forEach((card) => card.release());
		this.place.replaceChildren();
		this.reports.clear();
		this.memory.clear();
		this.cancelled = false;
	}

	cancel() {
		this.cancelled = true;
		this.client.cancel();
	}

	/**
	 * Checks all programs, or all those of the job file. Each check is separate, in a worker.
	 * @param {JobFile[]} all @param {string[]} options
	 */
	async start(all, options) {
		const here = inTheirFolder(all), of = (/** @type {string} */ role) => here.filter((file) => file.role === role).map(({path}) => path);
		this.clear();
		this.files = withMeshes(here);
		this.options = options;
		const list = here.find(({role}) => role === 'jobs'), [machine, setup, waivers] = ['machine', 'setup', 'waivers'].map((role) => of(role)[0]);
		const jobs = list ? await this.jobsOf(list) : [{name: '', machine, setup, waivers, programs: of('program')}];
		const groups = jobs.map((job) => ({job, ...(list ? {result: new JobResult(job.name, job.programs.length)} : {})}));
		await this.checkAll(groups.flatMap((group) => group.job.programs.map((program) => ({group, program}))));
	}

	/**
	 * The jobs of a job file, as on the command line; none if the file has a fault.
	 * @param {JobFile} list
	 * @returns {Promise<ListedJob[]>}
	 */
	async jobsOf(list) {
		const whole = new ProgramResult(list.path, false);
		this.place.append(copyField('The same on the command line', commandLine(this.options ?? [], [list.path])), whole.card);
		try {
			const {err} = await this.client.run(['--depends', '--', list.path], this.files, PARTS), faults = messagesAt(err, list.path), listed = jobsIn(list);
			faults.forEach((line) => whole.onMessage(line));
			if (!faults.length && !listed.length)
				throw new Error('no job can be read');
			if (!faults.length) {
				whole.card.remove();
				return listed;
			}
			whole.fail('Incomplete: the job file is at fault, and no job was checked.');
		} catch (error) {
			whole.fail(error instanceof Cancelled ? 'Cancelled: no job was checked.' : String(error));
		}
		return [];
	}

	/** @param {Run[]} runs */
	async checkAll(runs) {
		const list = runs.length > 1 ? new VerdictList(runs.length, runs.length > MOST_CARDS) : undefined, waiting = runs.values();
		if (list)
			this.place.append(list.part);
		runs.slice(0, MOST_CARDS).forEach((run, i) => this.show(run, new ProgramResult(run.program, i < FIRST_REPORTS, run.group.result?.name)));
		reveal(this.place, 'start');
		const lane = async () => {
			for (const run of waiting) {
				const card = run.card ?? new ProgramResult(run.program, false, run.group.result?.name);
				if (this.cancelled)
					card.cancel();
				else
					await this.checkOne(run, card);
				const verdict = card.card.dataset.verdict ?? 'incomplete';
				run.group.result?.tell(verdict);
				if (!run.card && verdict !== 'clear' && !this.cancelled && this.cards.length < 2 * MOST_CARDS)
					this.show(run, card);
				list?.tell(run.group.job.name, run.program, verdict, run.card?.card);
			}
		};
		await Promise.all(Array.from({length: BEGUN}, lane));
		list?.end();
	}

	/** @param {Run} run @param {ProgramResult} card */
	show(run, card) {
		const {result} = run.group;
		run.card = card;
		this.cards.push(card);
		if (result && !result.part.isConnected)
			this.place.append(result.part);
		(result?.part ?? this.place).append(card.card);
	}

	/**
	 * The faults that the command line reports for --dialect=auto with programs that it takes together: they must
	 * be for one control.
	 * @param {Group} group
	 * @returns {Promise<string>} its messages, or ''
	 */
	async dialectFault({job: {machine, programs}}) {
		const [files, options] = [this.files ?? [], this.options ?? []];
		if (!options.includes('--dialect=auto') || programs.length < 2)
			return '';
		const looked = files.map(([path, blob]) => /** @type {[string, Blob]} */ ([path, programs.includes(path) ? blob.slice(0, LOOK) : blob]));
		const {err} = await this.client.run(['--dialect=auto', '--parse-only', '--max-blocks=1', '--', machine, ...programs], looked, PARTS);
		return err.split('\n').filter((line) => /error: --dialect=auto/.test(line)).join('\n');
	}

	/**
	 * Checks a program in a worker. Without a card there is no report.
	 * @param {Run} run @param {ProgramResult} card that tells what is found
	 */
	async checkOne({group, program, card: shown}, card) {
		const {machine, setup, waivers} = group.job, files = this.files ?? [], options = [...this.options ?? [], ...(waivers ? [`--waivers=${waivers}`] : [])];
		const key = group.result ? `${group.result.name}: ${program}` : program;
		try {
			const fault = await (group.fault ??= this.dialectFault(group));
			fault.split('\n').forEach((line) => card.onMessage(line));
			if (fault) {
				card.fail('Incomplete: the programs do not show one control for all of them. Check them apart, or name the dialect.');
				return;
			}
			const result = await this.client.check({files, machine, setup, programs: [program], options, report: Boolean(shown) && !options.includes('--parse-only')}, card);
			const report = result.reports.get(program), blob = report && new Blob([/** @type {any} */ (report)], {type: 'text/html'});
			card.show(result, commandLine([...options, ...(setup ? [`--setup=${setup}`] : [])], [machine, program]), blob);
			this.memory.set(key, result.memory);
			if (blob)
				this.reports.set(key, blob);
		} catch (error) {
			const gone = error instanceof Cancelled ? [] : await unreadable(files);
			if (error instanceof Cancelled)
				card.cancel();
			else
				card.fail(gone.length ? `Incomplete: the browser cannot read ${gone.join(', ')} any more, because the file was changed or moved. Drop it again.` : String(error));
		}
	}
}
