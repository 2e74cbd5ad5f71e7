// @ts-check
/** cautions.js - which cautions of a verdict doubt its assumptions (verdict_caution_is_doubt in report/verdict.h). */

/** Cautions about what a person has excused, waived or accepted; unknown cautions are doubts. */
const SETTLED = /^\d+ pairs? of neighbours excused|^\d+ pairs? waived|^after an accepted finding/;

/** @param {string} caution */
export function isDoubt(caution) {
	return !SETTLED.test(caution);
}
