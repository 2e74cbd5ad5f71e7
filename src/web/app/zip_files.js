// @ts-check
/**
 * zip_files.js - the files in a ZIP archive (APPNOTE.TXT of PKWARE: 4.3.7 local header, 4.3.12 central directory, 4.3.16 its
 * end): stored or deflated, without ZIP64 and encryption.
 */
import {Files} from './files.js';

/** The largest number of bytes and files from one archive. */
export const LIMITS = {bytes: 1e9, files: 20000};

const END = 0x06054b50, ENTRY = 0x02014b50, LOCAL = 0x04034b50;
/** Sizes without the parts of variable length; the longest comment of an archive. */
const END_BYTES = 22, ENTRY_BYTES = 46, LOCAL_BYTES = 30, COMMENT = 65535;
const ENCRYPTED = 1, STORED = 0, DEFLATED = 8, ZIP64 = 0xffffffff;

/** An entry of the central directory. @typedef {{name: string, flags: number, method: number, crc: number, packed: number, size: number, offset: number}} Entry */

/** @param {Blob} blob @param {number} from @param {number} to */
async function viewOf(blob, from, to) {
	return new DataView(await blob.slice(from, to).arrayBuffer());
}

/** The letters from 128 on where names are not UTF-8 (appendix D.1): code page 437. */
const OLD_LETTERS = 'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0';

/** @param {DataView} view @param {number} at @param {number} length */
function nameAt(view, at, length) {
	const bytes = new Uint8Array(view.buffer, view.byteOffset + at, length);
	try {
		return new TextDecoder('utf-8', {fatal: true}).decode(bytes);
	} catch {
		return Array.from(bytes, (byte) => byte < 128 ? String.fromCharCode(byte) : OLD_LETTERS[byte - 128]).join('');
	}
}

/** @param {Blob} archive @returns {Promise<Entry[]>} */
async function directoryOf(archive) {
	const start = Math.max(0, archive.size - END_BYTES - COMMENT), tail = await viewOf(archive, start, archive.size);
	let end = tail.byteLength - END_BYTES;
	while (end >= 0 && tail.getUint32(end, true) !== END)
		end--;
	if (end < 0)
		throw new Error('it has no end: is it whole?');
	const count = tail.getUint16(end + 10, true), size = tail.getUint32(end + 12, true), at = tail.getUint32(end + 16, true);
	if (count > LIMITS.files || at === ZIP64)
		throw new Error(`it holds more than ${LIMITS.files} files, or is in the format ZIP64`);
	const view = await viewOf(archive, at, at + size), entries = [];
	for (let here = 0; entries.length < count;) {
		if (here + ENTRY_BYTES > view.byteLength || view.getUint32(here, true) !== ENTRY)
			throw new Error('its directory is broken');
		const [name, extra, comment] = [28, 30, 32].map((field) => view.getUint16(here + field, true));
		if (here + ENTRY_BYTES + name > view.byteLength)
			throw new Error('its directory is broken');
		entries.push({name: nameAt(view, here + ENTRY_BYTES, name), flags: view.getUint16(here + 8, true), method: view.getUint16(here + 10, true), crc: view.getUint32(here + 16, true),
			packed: view.getUint32(here + 20, true), size: view.getUint32(here + 24, true), offset: view.getUint32(here + 42, true)});
		here += ENTRY_BYTES + name + extra + comment;
	}
	return entries;
}

/** The effect of each byte on the check sum (4.4.7: CRC-32). */
const SUMS = Uint32Array.from({length: 256}, (_, sum) => {
	for (let bit = 0; bit < 8; bit++)
		sum = sum & 1 ? 0xedb88320 ^ sum >>> 1 : sum >>> 1;
	return sum;
});

/** The check sum of bytes that follow others. @param {number} sum of those, inverted @param {Uint8Array} bytes */
function summed(sum, bytes) {
	for (let i = 0; i < bytes.length; i++)
		sum = SUMS[(sum ^ bytes[i]) & 255] ^ sum >>> 8;
	return sum;
}

/** @param {ReadableStream<Uint8Array>} stream @param {number} size that it is to have @param {number} crc its check sum */
async function collected(stream, size, crc) {
	const reader = stream.getReader(), parts = /** @type {BlobPart[]} */ ([]);
	let count = 0, sum = -1;
	for (let step = await reader.read(); !step.done; step = await reader.read()) {
		count += step.value.length;
		if (count > size)
			break;
		sum = summed(sum, step.value);
		parts.push(/** @type {any} */ (step.value));
	}
	if (count === size && ~sum >>> 0 === crc)
		return new Blob(parts);
	await reader.cancel();
	throw new Error(count === size ? 'was damaged' : 'has another length than its archive says');
}

/** @param {Blob} archive @param {Entry} entry */
async function contentsOf(archive, {name, flags, method, crc, packed, size, offset}) {
	const local = await viewOf(archive, offset, offset + LOCAL_BYTES);
	if (flags & ENCRYPTED)
		throw new Error(`${name} is encrypted`);
	if (local.byteLength < LOCAL_BYTES || local.getUint32(0, true) !== LOCAL || (method !== STORED && method !== DEFLATED))
		throw new Error(`${name} is broken, or packed in another way`);
	const start = offset + LOCAL_BYTES + local.getUint16(26, true) + local.getUint16(28, true), data = archive.slice(start, start + packed);
	try {
		return await collected(method === STORED ? data.stream() : data.stream().pipeThrough(new DecompressionStream('deflate-raw')), size, crc);
	} catch (error) {
		throw new Error(`${name} cannot be unpacked: ${error instanceof Error ? error.message : error}`);
	}
}

/** The path of a file in the folder of its archive; some systems write \ for /. @param {string} name */
function placeOf(name) {
	const path = name.replaceAll('\\', '/'), parts = Files.parts(path);
	if (/^\/|^[a-z]:|(^|\/)\.\.(\/|$)/i.test(path))
		throw new Error(`${name} leads out of it`);
	if (!parts.length || [...path].some((letter) => letter < ' '))
		throw new Error('a file in it has no name, or one with control characters');
	return parts.join('/');
}

/**
 * @param {string} path of the archive
 * @param {Blob} archive
 * @returns {Promise<[string, Blob][]>} what is in it, in the folder where it is; fails with a sentence
 */
export async function filesInZip(path, archive) {
	const entries = (await directoryOf(archive)).filter(({name}) => !/[\\/]$/.test(name)), folder = path.slice(0, path.lastIndexOf('/') + 1);
	if (entries.reduce((sum, {size}) => sum + size, 0) > LIMITS.bytes)
		throw new Error(`more than ${LIMITS.bytes / 1e6} MB would come out of it`);
	const places = entries.map(({name}) => placeOf(name)), seen = new Set(), twice = places.find((place) => seen.size === seen.add(place).size);
	if (twice)
		throw new Error(`${twice} is in it twice`);
	/** @type {[string, Blob][]} */
	const files = [];
	for (const [i, entry] of entries.entries())
		files.push([folder + places[i], await contentsOf(archive, entry)]);
	return files;
}
