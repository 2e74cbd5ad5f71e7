// @ts-check
/**
 * job_files.js - determines the kinds of the files that a user dropped: the machine, its meshes, the setup, the
 * programs.
 */
import {Files} from './files.js';
import {fetched} from './modules.js';
import {element} from './page.js';
import {filesInZip} from './zip_files.js';

/** Bytes that are enough to determine the kind of a file, and the part of an XML file with the names of other files. */
const HEAD = 65536, MOST = 1 << 24;

/**
 * @typedef {'machine' | 'setup' | 'jobs' | 'mesh' | 'program' | 'subprogram' | 'waivers' | 'library' | 'other'} Role
 * @typedef {{path: string, blob: Blob, role: Role, text: string}} JobFile
 */

/** The beginning of a text: UTF-16 if its first bytes say so, else UTF-8. @param {Blob} blob @param {number} count */
async function headOf(blob, count) {
	const bytes = new Uint8Array(await blob.slice(0, count).arrayBuffer()), mark = 256 * bytes[0] + bytes[1];
	return new TextDecoder(mark === 0xfffe ? 'utf-16le' : mark === 0xfeff ? 'utf-16be' : 'utf-8').decode(bytes);
}

/** Files that are certainly not programs. */
const FOREIGN = /\.(jpe?g|png|gif|svg|webp|pdf|html?|md|docx?|xlsx?|odt|ods|exe|dll)$/i;
/** Tables of tools and offsets, to which a setup refers. */
const LIBRARY = /\.(json|csv|tls|tbl|t|toa)$/i;

/** @param {string} path */
export function isZip(path) {
	return /\.zip$/i.test(path);
}

/** Files that operating systems add to folders. @param {string} path */
export function isClutter(path) {
	return /(^|\/)(\.DS_Store$|\._|Thumbs\.db$|desktop\.ini$|__MACOSX\/|\.git\/|\.svn\/)/i.test(path);
}

/** @param {string} path */
export function isArchive(path) {
	return /\.(zip|7z|rar|gz|tgz|tar|xz|bz2)$/i.test(path);
}

/** A machine or a project of another program, which `fivecheck import` reads. @param {string} path */
export function isForeignMachine(path) {
	return /\.(mch|ctl|vcproject|fcm|ini|hal|urdf|xacro)$/i.test(path);
}

/** A drawing of a CAD system, which is not a mesh. @param {string} path */
export function isDrawing(path) {
	return /\.(step|stp|iges|igs|sldprt|sldasm|ipt|iam|prt|catpart|x_t|dxf|dwg|f3d|3mf|glb|gltf)$/i.test(path);
}

/** @type {Role[]} */
const XML = ['machine', 'setup', 'waivers', 'jobs'];

/** @param {string} path @param {string} text @returns {Role} */
function roleOf(path, text) {
	if (/\.(stl|obj|ply)$/i.test(path))
		return 'mesh';
	if (isForeignMachine(path))
		return 'other';
	const root = /** @type {Role | undefined} */ (text.match(/<(machine|setup|waivers|jobs)[\s>]/)?.[1]);
	return root ?? (LIBRARY.test(path) && (!/\.(json|csv)$/i.test(path) || /tool|^[^\n]*number/i.test(text)) ? 'library' : /\.xml$/i.test(path) || isDrawing(path) || isArchive(path) || FOREIGN.test(path) || LIBRARY.test(path) ? 'other' : 'program');
}

/**
 * @param {string} path
 * @param {Blob} blob
 * @returns {Promise<JobFile>}
 */
export async function jobFile(path, blob) {
	const head = await headOf(blob, HEAD), role = roleOf(path, head);
	return {path, blob, role, text: XML.includes(role) ? await headOf(blob, MOST) : head};
}

/** The files of an example of the page, which come in one archive. @param {string} name */
export async function exampleFiles(name) {
	const archive = `${name}.zip`, files = await filesInZip('', await (await fetched(`examples/${archive}`, archive)).blob());
	return Promise.all(files.map(([path, blob]) => jobFile(path, blob)));
}

/**
 * The names of the examples of the page.
 * @param {HTMLElement} place where it is told if they cannot be loaded
 * @returns {Promise<string[]>}
 */
export async function examplesOf(place) {
	try {
		return await (await fetched('examples/index.json', 'index.json')).json();
	} catch (error) {
		place.append(element('span', {className: 'lack'}, `The examples cannot be loaded (${/** @type {Error} */ (error).message}); your own files work all the same.`));
		return [];
	}
}

/**
 * The files that cannot be read: a browser reads no file that was changed after it was dropped.
 * @param {[string, Blob][]} files
 */
export async function unreadable(files) {
	const read = await Promise.all(files.map(([, blob]) => blob.slice(0, 1).arrayBuffer().then(() => true, () => false)));
	return files.filter((_, i) => !read[i]).map(([path]) => path);
}

/**
 * A program, mesh or tool library that comes without its folder is a new version of the file with its name, if there is
 * one: it gets the path of that file.
 * @param {JobFile[]} files that come @param {JobFile[]} here
 */
export function atHome(files, here) {
	const byName = grouped(here);
	return files.map((file) => {
		const same = (byName.get(file.path) ?? []).filter(({role}) => role === file.role);
		return ['program', 'mesh', 'library'].includes(file.role) && same.length === 1 ? {...file, path: same[0].path} : file;
	});
}

/**
 * The files that have the path of an earlier one: it would be unclear which of them is used.
 * @param {JobFile[]} files
 */
export function twins(files) {
	const paths = new Set();
	return files.filter(({path}) => paths.size === paths.add(path).size);
}

/** Do two files hold the same bytes? @param {Blob} a @param {Blob} b */
export async function sameBytes(a, b) {
	if (a.size !== b.size)
		return false;
	const [left, right] = (await Promise.all([a.arrayBuffer(), b.arrayBuffer()])).map((buffer) => new Uint8Array(buffer));
	return left.every((byte, i) => byte === right[i]);
}

/** Files that a setup uses as tool libraries are not programs. @param {JobFile[]} files */
export function withLibraries(files) {
	const setups = files.filter(({role}) => role === 'setup');
	const named = new Set(setups.flatMap(({text}) => [...text.matchAll(/<tools\s[^<>]*?\bhref=(["'])([^"']+)\1/g)].map(([, , path]) => nameOf(path))));
	return files.map((file) => (file.role === 'program' || file.role === 'other') && named.has(nameOf(file.path)) ? {...file, role: /** @type {Role} */ ('library')} : file);
}

/** The files with each name. @param {JobFile[]} files @returns {Map<string, JobFile[]>} */
function grouped(files) {
	/** @type {Map<string, JobFile[]>} */
	const byName = new Map();
	for (const file of files) {
		const name = nameOf(file.path), same = byName.get(name);
		same ? same.push(file) : byName.set(name, [file]);
	}
	return byName;
}

/** The kinds that a user must look at first come first. @type {Role[]} */
const ORDER = ['jobs', 'machine', 'setup', 'program', 'subprogram', 'waivers', 'library', 'other', 'mesh'];

/** @param {JobFile[]} files */
export function inOrder(files) {
	return [...files].sort((a, b) => ORDER.indexOf(a.role) - ORDER.indexOf(b.role));
}

/** @param {string} path */
export function nameOf(path) {
	return path.slice(path.lastIndexOf('/') + 1);
}

/** @param {string} path */
export function folderOf(path) {
	return path.slice(0, path.lastIndexOf('/') + 1);
}

const ENTITIES = /** @type {Record<string, string>} */ ({lt: '<', gt: '>', amp: '&', quot: '"', apos: '\''});

/** @param {string} value of an attribute of XML */
function unescaped(value) {
	return value.replace(/&(?:#x([\da-f]+)|#(\d+)|(lt|gt|amp|quot|apos));/gi, (all, hex, code, name) => {
		const letter = parseInt(hex ?? code, hex ? 16 : 10);
		return name ? ENTITIES[name.toLowerCase()] : letter <= 0x10ffff ? String.fromCodePoint(letter) : all;
	});
}

/** The files with paths relative to the innermost folder that contains all of them. @param {JobFile[]} files */
export function inTheirFolder(files) {
	let common = folderOf(files[0]?.path ?? '');
	for (const {path} of files) {
		while (!path.startsWith(common))
			common = folderOf(common.slice(0, -1));
	}
	return files.map((file) => ({...file, path: file.path.slice(common.length)}));
}

/** The files in a machine, setup or job file: their paths as written there. @param {JobFile} file */
function namedIn({role, text}) {
	if (role !== 'machine' && role !== 'setup' && role !== 'jobs')
		return [];
	const attribute = role === 'jobs' ? /\s(?:machine|setup|waivers|file)=(["'])([^"']+)\1/g : /\s(?:mesh|href)=(["'])([^"']+)\1/g;
	return [...text.replace(/<!--[^]*?(?:-->|$)/g, '').matchAll(attribute)].map(([, , path]) => unescaped(path));
}

/** Do two paths of folders end in the same way? @param {string} a @param {string} b */
function foldersAgree(a, b) {
	const [one, other] = [a, b].map((path) => `/${folderOf(path).replace(/^(\.{0,2}\/)+/, '')}`.replace(/^\/$/, ''));
	return one.endsWith(other) || other.endsWith(one);
}

/** The only file that a name may refer to. @param {Map<string, JobFile[]>} byName @param {string} named */
function standIn(byName, named) {
	const found = (byName.get(nameOf(named)) ?? []).filter(({path}) => foldersAgree(path, named));
	return found.length === 1 ? found[0] : undefined;
}

/**
 * Each file that another one refers to, with the file that was found for it. A file with a folder in its path is also
 * found if it was dropped without its folder, or with more folders around it; the files that it refers to are searched
 * from its path.
 * @param {JobFile[]} files
 * @returns {{path: string, named: string, found?: JobFile}[]} `path` is where the checker looks for it
 */
function namedFiles(files) {
	const here = new Map(files.map((file) => [file.path, file])), byName = grouped(files), all = [], asked = new Set(), waiting = [...files];
	for (const file of waiting) {
		for (const named of namedIn(file)) {
			const path = folderOf(file.path) + named;
			if (asked.has(path))
				continue;
			const found = here.get(Files.parts(path).join('/')) ?? standIn(byName, named);
			asked.add(path);
			all.push({path, named, found});
			// No file refers to a job file: a file that refers to itself would cause an endless loop.
			if (found && file.role === 'jobs' && found.role !== 'jobs' && !here.has(path))
				waiting.push({...found, path});
		}
	}
	return all;
}

/**
 * The files of a job, where the checker looks for them.
 * @param {JobFile[]} files
 * @returns {[string, Blob][]}
 */
export function withMeshes(files) {
	const all = new Map(files.map(({path, blob}) => [path, blob]));
	for (const {path, found} of namedFiles(files)) {
		if (found)
			all.set(path, found.blob);
	}
	return [...all];
}

/** The names of missing files in the machine, setup and job file. @param {JobFile[]} files */
export function missingFiles(files) {
	return [...new Set(namedFiles(files).filter(({found}) => !found).map(({named}) => named))];
}

/** Programs that are not in the job file: nothing checks them. @param {JobFile[]} files */
export function unlistedPrograms(files) {
	const named = new Set(namedFiles(files).map(({found}) => found));
	return files.some(({role}) => role === 'jobs') ? files.filter((file) => file.role === 'program' && !named.has(file)) : [];
}
