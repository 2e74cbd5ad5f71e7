// @ts-check
/**
 * job_list.js - a job file: the machine, setup, waivers and programs of each of its jobs. The checker reports its
 * faults.
 */
import {folderOf} from './job_files.js';

/**
 * Paths are as written in the job file, relative to its folder.
 * @typedef {{name: string, machine: string, setup?: string, waivers?: string, programs: string[]}} ListedJob
 */

/** @param {import('./job_files.js').JobFile} list @returns {ListedJob[]} none, where that is no XML */
export function jobsIn({path, text}) {
	const root = new DOMParser().parseFromString(text, 'application/xml').documentElement, folder = folderOf(path);
	/** @param {Element} node @param {string} name */
	const file = (node, name) => node.hasAttribute(name) ? folder + node.getAttribute(name) : undefined;
	return [...root.children].filter(({localName}) => localName === 'job').map((job) => ({name: job.getAttribute('name') ?? '', machine: file(job, 'machine') ?? '',
		setup: file(job, 'setup'), waivers: file(job, 'waivers'), programs: [...job.children].map((program) => file(program, 'file') ?? '')}));
}

/**
 * The checker's messages about one file, from all its messages: each with the lines that it quotes.
 * @param {string} messages @param {string} path
 */
export function messagesAt(messages, path) {
	return messages.split(/\n(?=\S)/).filter((message) => message.startsWith(`${path}:`)).flatMap((message) => message.split('\n')).filter((line) => line.trim() !== '');
}
