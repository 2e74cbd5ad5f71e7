/* plane_account.h - decides whether a search for travelling planes pays. It proves nothing. */
#ifndef FIVECHECK_CHECK_CERTIFIED_PLANE_ACCOUNT_H
#define FIVECHECK_CHECK_CERTIFIED_PLANE_ACCOUNT_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Near contact, or where one body is inside a hollow of the other, searches find no planes, or planes that last for one
 * step. So searches may cost as much as the pair's sweeps and distance queries have cost, plus what planes have saved.
 */
struct plane_account {
	double credit;	/* node pairs that searches may still examine */
	double sweep_price;	/* node pairs per swept step: a running mean */
	double search_price;	/* node pairs per search: a running mean */
	/* Chunks without a search, and steps that are not halved: now, and after the next failed search. */
	struct plane_pause {
		int idle, backoff;
	} chunks, halves, carried, parts;
};

/* `nodes`: the additional cost of the first search. */
void plane_account_init(struct plane_account *account, size_t nodes);

bool plane_account_allows(const struct plane_account *account);

/* The same for the planes of a chunk and of halves; also false while earlier such searches have failed. */
bool plane_account_allows_chunk(struct plane_account *account);
bool plane_account_allows_halves(struct plane_account *account);

/* A step was swept, or a distance queried. */
void plane_account_add_sweep(struct plane_account *account, long visits);
void plane_account_add_query(struct plane_account *account, long visits);

/* Planes have proved this number of steps. */
void plane_account_add_saved(struct plane_account *account, size_t steps);

void plane_account_add_search(struct plane_account *account, long visits);

/* The same for kept planes that are only measured again. */
bool plane_account_allows_carrying(struct plane_account *account);
void plane_account_add_carried(struct plane_account *account, long visits, bool proved);

void plane_account_add_chunk(struct plane_account *account, bool proved);
void plane_account_add_halves(struct plane_account *account, bool proved);

/* The same where a step is measured: after one search in vain the next one is tried all the same. */
bool plane_account_allows_parts(struct plane_account *account);
void plane_account_add_parts(struct plane_account *account, bool proved);

#endif
