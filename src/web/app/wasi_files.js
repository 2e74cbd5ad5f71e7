// @ts-check
/**
 * wasi_files.js - the calls of WASI preview 1 for files: a tree in memory without links (files.js).
 */
import {FileNode, Files, Folder, MemoryBytes} from './files.js';

/** Error numbers of WASI. */
export const E = {SUCCESS: 0, BADF: 8, EXIST: 20, INVAL: 28, ISDIR: 31, NOENT: 44, NOSYS: 52, NOTDIR: 54, NOTEMPTY: 55, SPIPE: 70};
/** Kinds of files. */
const KIND = {STREAM: 2, FOLDER: 3, FILE: 4};
const OPEN = {CREATE: 1, FOLDER: 2, EXCLUSIVE: 4, TRUNCATE: 8};
const APPEND = 1;
const ALL_RIGHTS = 0x1fffffffn;

/** @typedef {{ node: FileNode | Folder | null, position: number, append: boolean }} Descriptor */

/**
 * What the calls for files need from the host of a run.
 * @typedef {object} FileHost
 * @property {Files} files
 * @property {Uint8Array} [input] standard input
 * @property {(fd: 1 | 2, bytes: Uint8Array) => void} [onOutput] bytes that are valid during the call only
 * @property {(node: FileNode, offset: number) => void} [onRead] a file was read up to there
 */

export class WasiFiles {
	/** @param {FileHost} host */
	constructor(host) {
		this.host = host;
		/** @type {(Descriptor | undefined)[]} */
		this.open = [0, 1, 2].map(() => ({node: null, position: 0, append: false}));
		this.open.push({node: host.files.root, position: 0, append: false});
		this.input = new MemoryBytes(host.input);
		/** @type {WebAssembly.Memory} */
		this.memory = new WebAssembly.Memory({initial: 0});
	}

	view() {
		return new DataView(this.memory.buffer);
	}

	/**
	 * @param {number} at
	 * @param {number} length
	 */
	bytes(at, length) {
		return new Uint8Array(this.memory.buffer, at, length);
	}

	/**
	 * @param {number} at
	 * @param {number} length
	 */
	text(at, length) {
		return new TextDecoder().decode(this.bytes(at, length));
	}

	/**
	 * The buffers of a read or write.
	 * @param {number} list
	 * @param {number} count
	 */
	*buffers(list, count) {
		const view = this.view();
		for (let i = 0; i < count; i++)
			yield this.bytes(view.getUint32(list + 8 * i, true), view.getUint32(list + 8 * i + 4, true));
	}

	/** @param {number} fd */
	fd_close(fd) {
		if (!this.open[fd])
			return E.BADF;
		this.open[fd] = undefined;
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} out */
	fd_fdstat_get(fd, out) {
		const file = this.open[fd], view = this.view();
		if (!file)
			return E.BADF;
		view.setUint8(out, file.node instanceof Folder ? KIND.FOLDER : file.node ? KIND.FILE : KIND.STREAM);
		view.setUint16(out + 2, file.append ? APPEND : 0, true);
		// A stream without seek is not a terminal.
		view.setBigUint64(out + 8, ALL_RIGHTS, true);
		view.setBigUint64(out + 16, ALL_RIGHTS, true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} flags */
	fd_fdstat_set_flags(fd, flags) {
		const file = this.open[fd];
		if (!file)
			return E.BADF;
		file.append = (flags & APPEND) !== 0;
		return E.SUCCESS;
	}

	/**
	 * @param {FileNode | Folder | null} node
	 * @param {number} out
	 */
	putStatus(node, out) {
		const view = this.view(), kind = node instanceof Folder ? KIND.FOLDER : node ? KIND.FILE : KIND.STREAM;
		this.bytes(out, 64).fill(0);
		view.setBigUint64(out, 1n, true);
		view.setBigUint64(out + 8, BigInt(node ? node.number : 0), true);
		view.setUint8(out + 16, kind);
		view.setBigUint64(out + 24, 1n, true);
		view.setBigUint64(out + 32, BigInt(node instanceof FileNode ? node.source.size : 0), true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} out */
	fd_filestat_get(fd, out) {
		const file = this.open[fd];
		return file ? this.putStatus(file.node, out) : E.BADF;
	}

	/** @param {number} fd @param {bigint} size */
	fd_filestat_set_size(fd, size) {
		const node = this.open[fd]?.node;
		if (!(node instanceof FileNode && node.source instanceof MemoryBytes))
			return E.BADF;
		node.source.resize(Number(size));
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} out */
	fd_prestat_get(fd, out) {
		if (fd !== 3)
			return E.BADF;
		this.view().setUint32(out, 0, true);
		this.view().setUint32(out + 4, 1, true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} at */
	fd_prestat_dir_name(fd, at) {
		if (fd !== 3)
			return E.BADF;
		this.bytes(at, 1)[0] = '/'.charCodeAt(0);
		return E.SUCCESS;
	}

	/**
	 * Reads at `offset`, or where the file stands.
	 * @param {number} fd @param {number} list @param {number} count @param {number} out @param {number} [offset]
	 */
	read(fd, list, count, out, offset) {
		const file = this.open[fd];
		let total = 0;
		if (!file || fd === 1 || fd === 2)
			return E.BADF;
		if (file.node instanceof Folder)
			return E.ISDIR;
		const source = file.node ? file.node.source : this.input;
		let at = offset ?? file.position;
		for (const buffer of this.buffers(list, count)) {
			for (let done = 0; done < buffer.length;) {
				const got = source.read(at, buffer.subarray(done));
				if (got === 0)
					break;
				done += got;
				at += got;
				total += got;
			}
		}
		if (offset === undefined)
			file.position = at;
		if (file.node)
			this.host.onRead?.(file.node, at);
		this.view().setUint32(out, total, true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} list @param {number} count @param {number} out */
	fd_read(fd, list, count, out) {
		return this.read(fd, list, count, out);
	}

	/** @param {number} fd @param {number} list @param {number} count @param {bigint} offset @param {number} out */
	fd_pread(fd, list, count, offset, out) {
		return this.read(fd, list, count, out, Number(offset));
	}

	/** @param {number} fd @param {number} list @param {number} count @param {number} out */
	fd_write(fd, list, count, out) {
		const file = this.open[fd];
		let total = 0;
		if (!file || fd === 0 || file.node instanceof Folder)
			return E.BADF;
		const source = file.node?.source;
		if (source && !(source instanceof MemoryBytes))
			return E.BADF;
		for (const buffer of this.buffers(list, count)) {
			if (source) {
				source.write(file.append ? source.size : file.position, buffer);
				file.position = file.append ? source.size : file.position + buffer.length;
			} else if (buffer.length) {
				this.host.onOutput?.(/** @type {1 | 2} */ (fd), buffer);
			}
			total += buffer.length;
		}
		this.view().setUint32(out, total, true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {bigint} offset @param {number} whence @param {number} out */
	fd_seek(fd, offset, whence, out) {
		const file = this.open[fd];
		if (!file)
			return E.BADF;
		if (!(file.node instanceof FileNode))
			return E.SPIPE;
		const from = whence === 0 ? 0 : whence === 1 ? file.position : file.node.source.size;
		const to = from + Number(offset);
		if (to < 0)
			return E.INVAL;
		file.position = to;
		this.view().setBigUint64(out, BigInt(to), true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} out */
	fd_tell(fd, out) {
		return this.fd_seek(fd, 0n, 1, out);
	}

	fd_sync() {
		return E.SUCCESS;
	}

	/**
	 * The file or folder of a path, relative to an open folder.
	 * @param {number} fd @param {number} at @param {number} length
	 */
	named(fd, at, length) {
		const from = this.open[fd]?.node, parts = Files.parts(this.text(at, length));
		if (!(from instanceof Folder))
			return {error: E.NOTDIR};
		const node = this.host.files.find(parts.join('/'), from), name = parts.pop();
		const folder = this.host.files.find(parts.join('/'), from);
		return {node, name, folder: folder instanceof Folder ? folder : undefined};
	}

	/** @param {number} fd @param {number} _flags @param {number} at @param {number} length @param {number} out */
	path_filestat_get(fd, _flags, at, length, out) {
		const { node, error } = this.named(fd, at, length);
		return error ?? (node ? this.putStatus(node, out) : E.NOENT);
	}

	/**
	 * @param {number} fd @param {number} _follow @param {number} at @param {number} length @param {number} how
	 * @param {bigint} _rights @param {bigint} _inherited @param {number} flags @param {number} out
	 */
	path_open(fd, _follow, at, length, how, _rights, _inherited, flags, out) {
		const found = this.named(fd, at, length);
		let node = found.node;
		if (found.error)
			return found.error;
		if (node && how & OPEN.CREATE && how & OPEN.EXCLUSIVE)
			return E.EXIST;
		if (!node) {
			if (!(how & OPEN.CREATE) || !found.folder || found.name === undefined)
				return E.NOENT;
			node = new FileNode(new MemoryBytes(), this.host.files.count++);
			found.folder.entries.set(found.name, node);
		}
		if (how & OPEN.FOLDER && !(node instanceof Folder))
			return E.NOTDIR;
		if (how & OPEN.TRUNCATE) {
			if (!(node instanceof FileNode && node.source instanceof MemoryBytes))
				return E.ISDIR;
			node.source.resize(0);
		}
		let number = 3;
		while (this.open[number])
			number++;
		this.open[number] = {node, position: 0, append: (flags & APPEND) !== 0};
		this.view().setUint32(out, number, true);
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} at @param {number} length */
	path_create_directory(fd, at, length) {
		const { node, name, folder, error } = this.named(fd, at, length);
		if (error || node)
			return error ?? E.EXIST;
		if (!folder || name === undefined)
			return E.NOENT;
		folder.entries.set(name, new Folder(this.host.files.count++));
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} at @param {number} length */
	path_unlink_file(fd, at, length) {
		const { node, name, folder, error } = this.named(fd, at, length);
		if (error || !node)
			return error ?? E.NOENT;
		if (!(node instanceof FileNode))
			return E.ISDIR;
		folder?.entries.delete(name ?? '');
		return E.SUCCESS;
	}

	/** @param {number} fd @param {number} at @param {number} length */
	path_remove_directory(fd, at, length) {
		const { node, name, folder, error } = this.named(fd, at, length);
		if (error || !node)
			return error ?? E.NOENT;
		if (!(node instanceof Folder))
			return E.NOTDIR;
		if (node.entries.size)
			return E.NOTEMPTY;
		folder?.entries.delete(name ?? '');
		return E.SUCCESS;
	}

	/**
	 * @param {number} fd @param {number} at @param {number} length
	 * @param {number} to_fd @param {number} to @param {number} to_length
	 */
	path_rename(fd, at, length, to_fd, to, to_length) {
		const from = this.named(fd, at, length), into = this.named(to_fd, to, to_length);
		if (from.error || into.error || !from.node || !into.folder || into.name === undefined)
			return from.error ?? into.error ?? E.NOENT;
		from.folder?.entries.delete(from.name ?? '');
		into.folder.entries.set(into.name, from.node);
		return E.SUCCESS;
	}

	path_readlink() {
		return E.INVAL;
	}

	/** @param {number} fd @param {number} at @param {number} length @param {bigint} cookie @param {number} out */
	fd_readdir(fd, at, length, cookie, out) {
		const folder = this.open[fd]?.node;
		if (!(folder instanceof Folder))
			return E.NOTDIR;
		const into = this.bytes(at, length);
		let used = 0, number = 0;
		for (const [name, node] of folder.entries) {
			if (BigInt(number++) < cookie)
				continue;
			const text = new TextEncoder().encode(name), entry = new Uint8Array(24 + text.length);
			const view = new DataView(entry.buffer);
			view.setBigUint64(0, BigInt(number), true);
			view.setBigUint64(8, BigInt(node.number), true);
			view.setUint32(16, text.length, true);
			view.setUint8(20, node instanceof Folder ? KIND.FOLDER : KIND.FILE);
			entry.set(text, 24);
			const part = entry.subarray(0, length - used);
			into.set(part, used);
			used += part.length;
			if (used === length)
				break;
		}
		this.view().setUint32(out, used, true);
		return E.SUCCESS;
	}
}
