// speed.mjs - what the checker in WebAssembly takes, beside the native one. No time is judged here.
//
// speed.mjs FIVECHECK MODULE MACHINE SETUP PROGRAM [ROUNDS]: the least processor time of some rounds, in each of which the native
// program, a new node (cold: the module is compiled, too) and the same node once more (warm) take turns. The machine's
// meshes have to be in its folder.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';
import {Fivecheck} from '../../src/web/app/fivecheck.js';
import {Files} from '../../src/web/app/files.js';
import {addFromDisk} from './disk.mjs';

/** Seconds of the processor that this process and its threads took. */
function own() {
	const {user, system} = process.cpuUsage();
	return (user + system) / 1e6;
}

/** Two runs of the module in this process: cold, warm. */
async function runs(module, machine, setup, program) {
	const times = [];
	let fivecheck;
	for (let i = 0; i < 2; i++) {
		const start = own(), files = new Files();
		fivecheck ??= await Fivecheck.load(fs.readFileSync(module));
		addFromDisk(files, path.dirname(machine), '.');
		files.add('s.xml', fs.readFileSync(setup));
		files.add('p.nc', fs.readFileSync(program));
		const {status} = fivecheck.run(['-fndjson', '--setup=s.xml', path.basename(machine), 'p.nc'], files);
		times.push({status, seconds: own() - start});
	}
	return times;
}

/** The native program, its processor time as the shell tells it. */
function native(fivecheck, machine, setup, program) {
	const {status, stderr} = spawnSync('bash', ['-c', 'TIMEFORMAT="%U %S"; time "$0" "$@" >/dev/null 2>&1', fivecheck, '-j1', '-fndjson', `--setup=${setup}`, machine, program],
		{encoding: 'utf8'});
	return {status, seconds: stderr.trim().split(' ').reduce((sum, text) => sum + Number(text), 0)};
}

const [fivecheck, module, machine, setup, program, rounds = '5'] = process.argv.slice(2);
if (fivecheck === '--runs') {
	console.log(JSON.stringify(await runs(module, machine, setup, program)));
} else {
	const least = [Infinity, Infinity, Infinity];
	for (let i = 0; i < Number(rounds); i++) {
		const node = spawnSync(process.execPath, [fileURLToPath(import.meta.url), '--runs', module, machine, setup, program], {encoding: 'utf8'});
		const all = [native(fivecheck, machine, setup, program), ...JSON.parse(node.stdout)];
		if (new Set(all.map(({status}) => status)).size > 1)
			throw new Error(`exit statuses ${all.map(({status}) => status)}`);
		all.forEach(({seconds}, k) => least[k] = Math.min(least[k], seconds));
	}
	const [one, cold, warm] = least;
	console.log(`native ${one.toFixed(2)} s; node cold ${cold.toFixed(2)} s, ${(cold / one).toFixed(2)} times; warm ${warm.toFixed(2)} s, ${(warm / one).toFixed(2)} times`);
}
