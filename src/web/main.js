// @ts-check
// main.js - shows the report that the page carries.

console.log('viewer');
