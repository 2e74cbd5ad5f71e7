// @ts-check
/**
 * files.js - the files of a run of the checker: a tree of folders in memory, without links. The bytes of a file are in
 * memory, or are read in slices from their source, so that a program of any length fits.
 */

/**
 * The source of the bytes of a file.
 * @typedef {{ readonly size: number, read(offset: number, into: Uint8Array): number }} Source
 */

/** Bytes in memory, which grow as they are written. */
export class MemoryBytes {
	/** @param {Uint8Array} [bytes] */
	constructor(bytes = new Uint8Array(0)) {
		/** One after the other; a larger copy of all would cost more than writing. */
		this.parts = [bytes];
		this.room = this.size = bytes.length;
	}

	/**
	 * The memory between two offsets.
	 * @param {number} from
	 * @param {number} to at most `room`
	 */
	*pieces(from, to) {
		let start = 0;
		for (const part of this.parts) {
			if (from < start + part.length && start < to)
				yield part.subarray(Math.max(0, from - start), to - start);
			start += part.length;
		}
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} into
	 */
	read(offset, into) {
		let count = 0;
		for (const piece of this.pieces(offset, Math.min(offset + into.length, this.size))) {
			into.set(piece, count);
			count += piece.length;
		}
		return count;
	}

	/** @param {number} size */
	makeRoom(size) {
		if (size <= this.room)
			return;
		const part = new Uint8Array(Math.max(size - this.room, this.room, 4096));
		this.parts.push(part);
		this.room += part.length;
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} from
	 */
	write(offset, from) {
		const end = offset + from.length;
		let count = 0;
		this.makeRoom(end);
		for (const piece of this.pieces(offset, end)) {
			piece.set(from.subarray(count, count + piece.length));
			count += piece.length;
		}
		this.size = Math.max(this.size, end);
	}

	/** What is beyond the size is always zero. @param {number} size */
	resize(size) {
		this.makeRoom(size);
		for (const piece of this.pieces(size, this.size))
			piece.fill(0);
		this.size = size;
	}

	/** A copy of the bytes that were written. */
	contents() {
		const bytes = new Uint8Array(this.size);
		this.read(0, bytes);
		return bytes;
	}
}

/**
 * Bytes that one reading of a Blob brings, and bytes of all Blobs that stay in memory. Each reading waits for another
 * process of the browser, so most files are read whole, once; a longer program still takes only this room.
 */
export const READING = {slice: 1 << 25, room: 1 << 26};

/** The slices in memory, the one that was read first at the beginning. @type {Map<Blob, {start: number, bytes: Uint8Array}>} */
const slices = new Map();

/**
 * The slice of a blob in which a byte is.
 * @param {Blob} blob
 * @param {number} offset below its size
 */
function sliceOf(blob, offset) {
	const known = slices.get(blob);
	if (known && offset >= known.start && offset < known.start + known.bytes.length)
		return known;
	slices.delete(blob);
	const slice = {start: offset, bytes: new Uint8Array(new FileReaderSync().readAsArrayBuffer(blob.slice(offset, offset + READING.slice)))};
	let room = READING.room - slice.bytes.length;
	for (const {bytes} of slices.values())
		room -= bytes.length;
	for (const [other, {bytes}] of slices) {
		if (room >= 0)
			break;
		slices.delete(other);
		room += bytes.length;
	}
	slices.set(blob, slice);
	return slice;
}

/** A File or Blob of the browser, read in slices; only in a worker, where reading may block. */
export class BlobBytes {
	/** @param {Blob} blob */
	constructor(blob) {
		this.blob = blob;
		this.size = blob.size;
	}

	/**
	 * @param {number} offset
	 * @param {Uint8Array} into
	 */
	read(offset, into) {
		if (offset >= this.size)
			return 0;
		const {start, bytes} = sliceOf(this.blob, offset), from = offset - start, count = Math.min(into.length, bytes.length - from);
		into.set(bytes.subarray(from, from + count));
		return count;
	}
}

/** @typedef {Map<string, Folder | FileNode>} Entries */

export class FileNode {
	/**
	 * @param {Source} source
	 * @param {number} number
	 */
	constructor(source, number) {
		this.source = source;
		this.number = number;
	}
}

export class Folder {
	/** @param {number} number */
	constructor(number) {
		/** @type {Entries} */
		this.entries = new Map();
		this.number = number;
	}
}

/** The tree. Paths are absolute or relative to the root, with `/` between their parts. */
export class Files {
	constructor() {
		this.count = 1;
		this.root = new Folder(this.count++);
		this.folder('tmp');
	}

	/**
	 * The parts of a path, without `.` and `..`; the root is its own parent, as in POSIX.
	 * @param {string} path
	 */
	static parts(path) {
		/** @type {string[]} */
		const parts = [];
		for (const part of path.split('/')) {
			if (part === '..')
				parts.pop();
			else if (part !== '' && part !== '.')
				parts.push(part);
		}
		return parts;
	}

	/**
	 * The file or folder with this path, or undefined.
	 * @param {string} path
	 * @param {Folder} [from]
	 * @returns {Folder | FileNode | undefined}
	 */
	find(path, from = this.root) {
		/** @type {Folder | FileNode | undefined} */
		let at = from;
		for (const part of Files.parts(path)) {
			if (!(at instanceof Folder))
				return undefined;
			at = at.entries.get(part);
		}
		return at;
	}

	/**
	 * The folder with this path; it is made if it is missing, with the folders above it.
	 * @param {string} path
	 */
	folder(path) {
		let at = this.root;
		for (const part of Files.parts(path)) {
			let next = at.entries.get(part);
			if (!(next instanceof Folder))
				at.entries.set(part, next = new Folder(this.count++));
			at = next;
		}
		return at;
	}

	/**
	 * Adds a file with this path, and makes its folders.
	 * @param {string} path
	 * @param {string | Uint8Array | ArrayBuffer | Blob | Source} contents
	 */
	add(path, contents) {
		const parts = Files.parts(path), name = parts.pop();
		if (name === undefined)
			throw new Error(`no path of a file: ${path}`);
		const node = new FileNode(sourceOf(contents), this.count++);
		this.folder(parts.join('/')).entries.set(name, node);
		return node;
	}

	/**
	 * The bytes of a file that was written, or undefined.
	 * @param {string} path
	 */
	contents(path) {
		const node = this.find(path);
		return node instanceof FileNode && node.source instanceof MemoryBytes ? node.source.contents() : undefined;
	}
}

/**
 * @param {string | Uint8Array | ArrayBuffer | Blob | Source} contents
 * @returns {Source}
 */
function sourceOf(contents) {
	if (typeof contents === 'string')
		return new MemoryBytes(new TextEncoder().encode(contents));
	if (contents instanceof Uint8Array)
		return new MemoryBytes(contents);
	if (contents instanceof ArrayBuffer)
		return new MemoryBytes(new Uint8Array(contents));
	return contents instanceof Blob ? new BlobBytes(contents) : contents;
}
