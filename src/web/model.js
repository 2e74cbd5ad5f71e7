// @ts-check
// model.js - what the viewer shows: plain data, whoever brings it (pack.js for a report, later the app).
//
// Lengths in mm, angles in degrees, times in seconds. Link 0 is the base, link i + 1 is what axes[i] carries. Meshes and
// the directions and locations of axes are in machine coordinates with every axis at 0.

/**
 * @typedef {[number, number, number]} Vec3
 *
 * @typedef {Object} Axis
 * @property {string} letter
 * @property {string} [title]
 * @property {boolean} rotary
 * @property {number} parent	the link that carries it
 * @property {Vec3} direction
 * @property {Vec3} location
 * @property {number|null} min	null: unlimited
 * @property {number|null} max
 *
 * @typedef {Object} Mesh
 * @property {Float32Array} positions	x y z for each vertex
 * @property {Uint32Array} indices	three for each triangle
 *
 * @typedef {Object} Body
 * @property {string} name
 * @property {number} link
 * @property {'machine'|'fixture'|'part'|'holder'|'shank'|'cutter'|string} role
 * @property {number|null} tool	number of the tool that it belongs to: shown only while that tool is in the spindle
 * @property {Mesh} mesh
 *
 * @typedef {Object} Finding
 * @property {string} kind	as in NDJSON: collision, clearance, limit, start-overlap, ...
 * @property {string} file
 * @property {number} line
 * @property {number} column
 * @property {number} fraction
 * @property {string|null} a
 * @property {string|null} b
 * @property {Object<string, number>} axes
 * @property {number} time
 * @property {Vec3|null} point
 * @property {number|null} clearance
 * @property {string|null} block
 * @property {string} [accepted]
 * @property {string} [reason]
 * @property {string} [advice]	what would make it go away, such as "needs 4.0 mm more tool length"
 * @property {number[]} [triangles_a]	triangles of body a at the contact
 * @property {number[]} [triangles_b]
 *
 * @typedef {Object} Pair
 * @property {string} a
 * @property {string} b
 * @property {string} status
 * @property {number} clearance	that must be kept
 * @property {string} reason
 * @property {number|null} [nearest]	smallest proven distance; null: not measured
 * @property {number|null} [time]	where that was
 *
 * @typedef {Object} Pose
 * @property {number} time
 * @property {number[]} values	by axis, in the order of model.axes; mm and degrees
 * @property {number} block	index of the block that runs
 * @property {number} tool
 *
 * @typedef {Object} Blocks
 * @property {number} count
 * @property {(index: number) => number} start	time
 * @property {(index: number) => number} end
 * @property {(index: number) => number} line
 * @property {(index: number) => number} file	index of the file in model.sources
 * @property {(time: number) => number} at	the block that runs at a time
 * @property {(file: number, line: number) => number} of	the first block of a line, or -1
 *
 * @typedef {Object} Path
 * @property {number} duration
 * @property {(time: number) => Pose} pose
 * @property {Blocks} blocks
 *
 * @typedef {Object} Source	a program or subprogram
 * @property {string} name
 * @property {string|null} sha256
 * @property {number} lines
 * @property {(line: number) => (string|null)} text	null: not in the report
 * @property {(text: string) => void} supply	the whole text, from the user
 *
 * @typedef {Object} Clearance	"at least" of all pairs, over time
 * @property {number} cap	mm: more is not measured
 * @property {Float64Array} times	starts of the intervals, and the end of the last
 * @property {Float32Array} least	mm, one for each interval
 * @property {Int32Array} pair	index of the nearest pair in model.pairs, or -1
 *
 * @typedef {Object} Plane	separates the pair during an interval: n . x = offset, in the frame of a link
 * @property {number} start
 * @property {number} end
 * @property {number} pair
 * @property {number} link
 * @property {Vec3} normal
 * @property {number} offset
 *
 * @typedef {Object} Mark	a tool change or an operation's name
 * @property {number} time
 * @property {string} text
 *
 * @typedef {Object} Model
 * @property {string} version	of fivecheck
 * @property {string} machine
 * @property {string} program
 * @property {'clear'|'passed'|'found'|'accepted'|'incomplete'|string} verdict
 * @property {string} sentence
 * @property {string[]} cautions
 * @property {{file: string|null, line: number|null, text: string}[]} errors
 * @property {{kind: string, file: string, sha256: string|null}[]} files
 * @property {Axis[]} axes
 * @property {Body[]} bodies
 * @property {Pair[]} pairs
 * @property {Finding[]} findings
 * @property {Path} path
 * @property {Source[]} sources
 * @property {Clearance|null} clearance
 * @property {Plane[]} planes
 * @property {Mark[]} tools
 * @property {Mark[]} operations
 * @property {[string, string][]} setup	what, value
 * @property {[string, string][]} statistics
 * @property {string} accuracy	how exactly the picture is drawn
 */

export {};
