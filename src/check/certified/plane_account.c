#include "check/certified/plane_account.h"

#include "base/minmax.h"

/* Prices are running means: the weight of the last price. */
#define LAST_SHARE 0.125

/* The largest credit. More would be spent where planes have stopped paying. */
#define CREDIT_MAX 1e5

/*
 * The time for a node in a search, as a share of the time for a node pair in a sweep or a distance query. Measured: 80
 * to 95 instructions against 600 to 760.
 */
#define SEARCH_WEIGHT 0.125

/* Nodes: the assumed minimum cost of a first search. */
#define FIRST_PRICE 2000

/* The largest number of chunks or steps that are left out after failed searches. */
enum { BACKOFF_MAX = 64 };

void plane_account_init(struct plane_account *account, size_t nodes)
{
	*account = (struct plane_account){.search_price = SEARCH_WEIGHT * (FIRST_PRICE + (double)nodes)};
}

bool plane_account_allows(const struct plane_account *account)
{
	return account->credit > account->search_price;
}

static bool allows(const struct plane_account *account, struct plane_pause *pause)
{
	if (!plane_account_allows(account))
		return false;
	if (pause->idle <= 0)
		return true;
	pause->idle--;
	return false;
}

bool plane_account_allows_chunk(struct plane_account *account)
{
	return allows(account, &account->chunks);
}

bool plane_account_allows_halves(struct plane_account *account)
{
	return allows(account, &account->halves);
}

bool plane_account_allows_parts(struct plane_account *account)
{
	return allows(account, &account->parts);
}

static void add_credit(struct plane_account *account, double visits)
{
	account->credit = smaller(account->credit + visits, CREDIT_MAX);
}

void plane_account_add_query(struct plane_account *account, long visits)
{
	add_credit(account, (double)visits);
}

void plane_account_add_sweep(struct plane_account *account, long visits)
{
	add_credit(account, (double)visits);
	account->sweep_price += LAST_SHARE * ((double)visits - account->sweep_price);
}

void plane_account_add_saved(struct plane_account *account, size_t steps)
{
	add_credit(account, account->sweep_price * (double)steps);
}

void plane_account_add_search(struct plane_account *account, long visits)
{
	const double price = SEARCH_WEIGHT * (double)visits;

	account->credit -= price;
	account->search_price += LAST_SHARE * (price - account->search_price);
}

bool plane_account_allows_carrying(struct plane_account *account)
{
	return allows(account, &account->carried);
}

static void learn(struct plane_pause *pause, bool proved)
{
	pause->backoff = proved ? 0 : pause->backoff < BACKOFF_MAX ? 2 * pause->backoff + 1 : BACKOFF_MAX;
	pause->idle = pause->backoff;
}

void plane_account_add_carried(struct plane_account *account, long visits, bool proved)
{
	account->credit -= SEARCH_WEIGHT * (double)visits;
	learn(&account->carried, proved);
}

void plane_account_add_chunk(struct plane_account *account, bool proved)
{
	learn(&account->chunks, proved);
}

void plane_account_add_halves(struct plane_account *account, bool proved)
{
	learn(&account->halves, proved);
}

void plane_account_add_parts(struct plane_account *account, bool proved)
{
	learn(&account->parts, proved);
	account->parts.idle /= 2;
}
