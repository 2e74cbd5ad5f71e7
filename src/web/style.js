// @ts-check
// style.js - the text of stage.css and style.css: bundle-web puts it here.

export const STYLE = '';
