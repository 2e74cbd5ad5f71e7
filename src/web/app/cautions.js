// @ts-check
/** cautions.js - which cautions of a verdict doubt what it takes for granted (verdict_caution_is_doubt in report/verdict.h). */

/** What a person has excused, waived or accepted; what is not known here is a doubt. */
const SETTLED = /^\d+ pairs? of neighbours excused|^\d+ pairs? waived|^after an accepted finding/;

/** @param {string} caution */
export function isDoubt(caution) {
	return !SETTLED.test(caution);
}
