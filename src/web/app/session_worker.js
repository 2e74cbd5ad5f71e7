// @ts-check
/**
 * session_worker.js - a machine that stays loaded in a worker (session_client.js). Each query has a number, which its
 * answer repeats.
 */
import {Fivecheck} from './fivecheck.js';
import {Files} from './files.js';

/** @typedef {import('./fivecheck.js').Session} Session */

/** Only the data of the report is used. */
const NO_VIEWER = '/* none */';

class Desk {
	/** @param {WebAssembly.Module[]} modules @param {[string, string | Blob][]} files @param {{machine: string, setup?: string}} job */
	constructor(modules, files, job) {
		this.files = new Files();
		for (const [path, contents] of files)
			this.files.add(path, contents);
		this.job = job;
		/** @type {Session} */
		this.session = new Fivecheck(modules, NO_VIEWER).session(this.files);
	}

	/** @param {{name: string, text: string, options?: string[], report?: boolean}} program */
	check({name, text, options, report}) {
		this.files.add(name, text);
		return this.session.check({...this.job, programs: [name], options, report});
	}

	/** @param {{axes: Record<string, number>, tool: number}} where */
	pose({axes, tool}) {
		return this.session.pose(axes, tool);
	}
}

/** @type {Desk | undefined} */
let desk;

addEventListener('message', ({data: {id, open, check, pose}}) => {
	try {
		if (open)
			desk = new Desk(open.modules, open.files, open.job);
		postMessage({id, answer: check ? desk?.check(check) : pose ? desk?.pose(pose) : true});
	} catch (error) {
		postMessage({id, failed: String(error)});
	}
});
