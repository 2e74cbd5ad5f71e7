// @ts-check
// style.js - the text of style.css: bundle-web puts it here.

export const STYLE = '';
