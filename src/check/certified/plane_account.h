/* plane_account.h - whether a search for travelling planes pays. It decides when to search, and proves nothing. */
#ifndef FIVECHECK_CHECK_CERTIFIED_PLANE_ACCOUNT_H
#define FIVECHECK_CHECK_CERTIFIED_PLANE_ACCOUNT_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Near contact, or where one body lies inside a hollow of the other, planes are found in vain or last for a step. So
 * searches may cost what the pair's sweeps and distance queries have cost, and what planes have saved.
 */
struct plane_account {
	double credit;	/* node pairs that searches may still look at */
	double sweep_price;	/* node pairs that the sweep of a step looks at: a running mean */
	double search_price;	/* the same of a search */
	/*
	 * Chunks for which no plane is searched, and steps that are not halved: now, and after the next search in vain.
	 */
	struct plane_pause {
		int idle, backoff;
	} chunks, halves, carried, parts;
};

/* nodes: what the first search has to look at besides. */
void plane_account_init(struct plane_account *account, size_t nodes);

bool plane_account_allows(const struct plane_account *account);

/* The same for the planes of a chunk and of halves; false also while earlier such searches were in vain. */
bool plane_account_allows_chunk(struct plane_account *account);
bool plane_account_allows_halves(struct plane_account *account);

/* A step was swept, or the distance asked for. */
void plane_account_add_sweep(struct plane_account *account, long visits);
void plane_account_add_query(struct plane_account *account, long visits);

/* Planes have proved so many steps. */
void plane_account_add_saved(struct plane_account *account, size_t steps);

void plane_account_add_search(struct plane_account *account, long visits);

/* The same of kept planes that are measured again and nothing else. */
bool plane_account_allows_carrying(struct plane_account *account);
void plane_account_add_carried(struct plane_account *account, long visits, bool proved);

void plane_account_add_chunk(struct plane_account *account, bool proved);
void plane_account_add_halves(struct plane_account *account, bool proved);

/* The same where a step is measured: after one search in vain the next one is tried all the same. */
bool plane_account_allows_parts(struct plane_account *account);
void plane_account_add_parts(struct plane_account *account, bool proved);

#endif
