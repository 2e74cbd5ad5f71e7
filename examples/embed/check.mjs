// check.mjs - checks a program on a machine in JavaScript, with the WebAssembly of make web:
//
//     node examples/embed/check.mjs build-web/app/fivecheck.wasm FOLDER machine.xml setup.xml part.nc
//
// The last three names are those of files in FOLDER. The exit status is that of the check.
import fs from 'node:fs';
import path from 'node:path';
import {Fivecheck} from '../../src/web/app/fivecheck.js';
import {Files} from '../../src/web/app/files.js';

const [wasm, folder, machine, setup, program] = process.argv.slice(2);
const fivecheck = await Fivecheck.load(fs.readFileSync(wasm));

const files = new Files();
for (const name of fs.readdirSync(folder, {recursive: true})) {
	if (fs.statSync(path.join(folder, name)).isFile())
		files.add(name, fs.readFileSync(path.join(folder, name)));
}

const result = fivecheck.check({
	files, machine, setup, programs: [program],
	onEvent: ({kind, line, a, b}) => b && console.log(`line ${line}: ${kind}: ${a} and ${b}`),
	onMessage: (message) => console.error(message),
});
process.exitCode = result.status;
