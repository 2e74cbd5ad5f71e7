// @ts-check
/** dropped.js - the files that a user drops onto a page: files, folders, ZIP archives. */
import {isZip} from './job_files.js';
import {filesInZip} from './zip_files.js';

/**
 * All files below a dropped entry.
 * @param {FileSystemEntry} entry
 * @returns {Promise<[string, Blob][]>}
 */
async function filesBelow(entry) {
	if (entry.isFile) {
		/** @type {File} */
		const file = await new Promise((done, failed) => /** @type {FileSystemFileEntry} */ (entry).file(done, failed));
		return [[entry.fullPath.replace(/^\//, ''), file]];
	}
	const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader(), all = [];
	for (;;) {
		/** @type {FileSystemEntry[]} */
		const some = await new Promise((done, failed) => reader.readEntries(done, failed));
		if (some.length === 0)
			break;
		all.push(...some);
	}
	return (await Promise.all(all.map(filesBelow))).flat();
}

/** Does the user drag files, and not a text? @param {DragEvent} event */
function hasFiles(event) {
	return event.dataTransfer?.types.includes('Files') ?? false;
}

/**
 * Takes files dropped anywhere on the page.
 * @param {HTMLElement} place that shows it while files are held over the page
 * @param {(found: [string, Blob][]) => void} take
 */
export function takeDrops(place, take) {
	addEventListener('dragover', (event) => {
		if (!hasFiles(event))
			return;
		event.preventDefault();
		place.classList.add('over');
	});
	addEventListener('dragleave', () => place.classList.remove('over'));
	addEventListener('drop', async (event) => {
		if (!hasFiles(event))
			return;
		event.preventDefault();
		place.classList.remove('over');
		const entries = [...(event.dataTransfer?.items ?? [])].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
		take((await Promise.all(entries.map((entry) => filesBelow(entry)))).flat());
	});
}

/**
 * Replaces ZIP archives by their files; an archive that cannot be read stays, with the reason. If there are several
 * archives, each gets its own folder.
 * @param {[string, Blob][]} found
 */
export async function unpacked(found) {
	const several = found.filter(([path]) => isZip(path)).length > 1, faults = /** @type {string[]} */ ([]), files = await Promise.all(found.map(async ([path, blob]) => {
		try {
			return isZip(path) ? await filesInZip(several ? path.replace(/\.zip$/i, '/') : path, blob) : [/** @type {[string, Blob]} */ ([path, blob])];
		} catch (error) {
			faults.push(`${path} cannot be read: ${/** @type {Error} */ (error).message}.`);
			return [/** @type {[string, Blob]} */ ([path, blob])];
		}
	}));
	return {files: files.flat(), faults};
}
