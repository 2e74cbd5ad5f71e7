// @ts-check
/**
 * advice.js - what the dropped files lack, or what a check would leave out, and what to do about it: one sentence each.
 */
import {isArchive, isDrawing, isForeignMachine, missingFiles, nameOf, unlistedPrograms} from './job_files.js';

/** @typedef {import('./job_files.js').JobFile} JobFile */

/** If there are more names, only this many are listed. */
const TOLD = 8;

/** @param {string[]} names */
function list(names) {
	return names.length <= TOLD + 1 ? names.join(', ') : `${names.slice(0, TOLD).join(', ')} and ${names.length - TOLD} others`;
}

/**
 * @param {JobFile[]} files
 * @param {string[]} replaced meshes that took the place of others of the same name
 * @returns {string[]}
 */
export function adviceOn(files, replaced) {
	const named = (/** @type {(file: JobFile) => boolean} */ is) => files.filter(is).map(({path}) => path);
	const empty = named(({blob}) => blob.size === 0), drawings = named(({path}) => isDrawing(path)), archives = named(({path}) => isArchive(path));
	const foreign = named(({path}) => isForeignMachine(path)), setups = files.some(({role}) => role === 'setup');
	const loose = named(({role, path}) => role === 'library' && !files.some((file) => (file.role === 'setup' || file.role === 'machine') && file.text.includes(nameOf(path))));
	const others = named(({role, path, blob}) => role === 'other' && blob.size > 0 && ![...drawings, ...archives, ...foreign].includes(path));
	const missing = missingFiles(files), unlisted = unlistedPrograms(files).map(({path}) => path);
	return [
		...(archives.length ? [`Unpack ${list(archives)}, and drop the folder that comes out of it.`] : []),
		...(drawings.length ? [`Bodies are read from STL, OBJ and PLY files: export ${list(drawings)} as STL from the CAD system.`] : []),
		...foreign.map((path) => `${path} is a file of another program. On the command line, fivecheck import --output=machine ${nameOf(path)} makes a machine file of it: drop the folder machine.`),
		...(empty.length ? [`${list(empty)}: nothing in it. Save or export it again.`] : []),
		...replaced.map((path) => `Another ${path} took the place of the one that was here: all bodies that name ${path} have its shape now. Rename one of the two if they are different bodies.`),
		...(loose.length ? [`${list(loose)}: perhaps tools, but no setup names them. ${setups ? `Add <tools href="${nameOf(loose[0])}"/> to the setup.` : 'The form for a setup below does.'}`] : []),
		...(others.length ? [`Not of use for a check: ${list(others)}.`] : []),
		...(unlisted.length ? [`The job file does not name ${list(unlisted)}: not checked.`] : []),
		...(missing.length ? [`Not here yet: ${list(missing)}. Drop them, too.`] : []),
	];
}
