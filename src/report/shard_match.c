#include "report/shard_match.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/strbuf.h"
#include "report/format/json.h"

static const struct srcloc nowhere;

/* The position of a run among its shards; 1 of 1 programs if there are no shards. */
struct share {
	json_int_t part, parts;
	bool of_blocks;
};

static struct share share_of(const struct ndjson_run *run)
{
	const json_t *shard = json_object_get(run->header, "shard");
	const char *of = ndjson_run_text(shard, "of");

	if (!json_is_object(shard))
		return (struct share){1, 1, false};
	return (struct share){json_integer_value(json_object_get(shard, "part")),
			      json_integer_value(json_object_get(shard, "parts")), of && !strcmp(of, "blocks")};
}

static bool match_shares(const struct ndjson_run *runs, size_t count, bool *of_blocks, struct diag *diag)
{
	const struct share first = share_of(&runs[0]);
	struct strbuf there = {0};
	bool good = (json_int_t)count == first.parts;

	for (size_t i = 0; i < count; i++) {
		const struct share share = share_of(&runs[i]);

		if (share.parts != first.parts || share.of_blocks != first.of_blocks) {
			diag_error(diag, nowhere, "%s and %s are not shards of one run", runs[0].path, runs[i].path);
			strbuf_release(&there);
			return false;
		}
		strbuf_addf(&there, " %lld", (long long)share.part);
		good = good && share.part == (json_int_t)i + 1;
	}
	if (!good && first.parts == 1)
		diag_error(diag, nowhere, "%s is a whole run and not a shard of one: it cannot be joined with others",
			   runs[0].path);
	else if (!good)
		diag_error(diag, nowhere, "each of %lld shards must be given once, but these were given:%s",
			   (long long)first.parts, strbuf_text(&there));
	strbuf_release(&there);
	*of_blocks = first.of_blocks;
	return good;
}

/* Everything in the headers must be equal, except for the values that differ from shard to shard. */
static bool match_options(const struct ndjson_run *a, const struct ndjson_run *b, struct diag *diag)
{
	const char *key;
	json_t *value;

	json_object_foreach (a->header, key, value) {
		json_t *other = json_object_get(b->header, key);
		char *texts[2];

		if (!strcmp(key, "shard") || !strcmp(key, "programs") || !strcmp(key, "files") ||
		    (other && json_equal(value, other)))
			continue;
		texts[0] = json_dumps(value, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(12));
		texts[1] = other ? json_dumps(other, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(12)) : NULL;
		diag_error(diag, nowhere, "%s and %s differ in %s: %s and %s", a->path, b->path, key, texts[0],
			   texts[1] ? texts[1] : "nothing");
		free(texts[0]);
		free(texts[1]);
		return false;
	}
	return true;
}

static bool is_kind(const json_t *file, const char *kind)
{
	const char *known = ndjson_run_text(file, "kind");

	return known && !strcmp(known, kind);
}

static const json_t *find_file(const json_t *files, const char *name)
{
	for (size_t i = 0; i < json_array_size(files); i++) {
		const json_t *file = json_array_get(files, i);
		const char *known = ndjson_run_text(file, "file");

		if (known && !strcmp(known, name))
			return file;
	}
	return NULL;
}

/* Each file of a that must also be in b must have the same digest. `optional`: it may be missing in b. */
static bool match_files(const struct ndjson_run *a, const json_t *files, const struct ndjson_run *b,
			const json_t *others, bool optional, struct diag *diag)
{
	for (size_t i = 0; i < json_array_size(files); i++) {
		const json_t *file = json_array_get(files, i);
		const char *name = ndjson_run_text(file, "file"), *digest = ndjson_run_text(file, "sha256");
		const json_t *other = name ? find_file(others, name) : NULL;
		const char *other_digest = ndjson_run_text(other, "sha256");

		if (!other && optional)
			continue;
		if (!digest || (other && !other_digest)) {
			diag_error(diag, nowhere,
				   "%s has no digest of %s, which cannot be read twice, so it is not known whether the "
				   "shards read the same bytes",
				   digest ? b->path : a->path, name ? name : "a file");
			return false;
		}
		if (other && !strcmp(digest, other_digest))
			continue;
		diag_error(diag, nowhere, other ? "%s and %s did not read the same %s"
						: "%s, but not %s, has read %s", a->path, b->path, name);
		return false;
	}
	return true;
}

/* The files of the header without the programs. */
static json_t *without_programs(const struct ndjson_run *run)
{
	const json_t *files = json_object_get(run->header, "files");
	json_t *rest = json_array();

	for (size_t i = 0; i < json_array_size(files); i++) {
		json_t *file = json_array_get(files, i);

		if (!is_kind(file, "program"))
			json_push(rest, json_incref(file));
	}
	return rest;
}

/* A program from standard input is not among the files. */
static bool has_program(const struct ndjson_run *run, struct diag *diag)
{
	const json_t *files = json_object_get(run->header, "files");

	for (size_t i = 0; i < json_array_size(files) && run->count; i++) {
		if (is_kind(json_array_get(files, i), "program"))
			return true;
	}
	diag_error(diag, nowhere, "%s has no digest of its program: shards must read it from a file", run->path);
	return false;
}

static bool match_pair(const struct ndjson_run *a, const struct ndjson_run *b, bool of_blocks, struct diag *diag)
{
	json_t *common[2] = {of_blocks ? json_incref(json_object_get(a->header, "files")) : without_programs(a),
			     of_blocks ? json_incref(json_object_get(b->header, "files")) : without_programs(b)};
	const json_t *subprograms[2] = {json_object_get(a->summary, "files"), json_object_get(b->summary, "files")};
	bool good = match_options(a, b, diag) && (!of_blocks || (has_program(a, diag) && has_program(b, diag))) &&
		    match_files(a, common[0], b, common[1], false, diag) &&
		    match_files(b, common[1], a, common[0], false, diag) &&
		    match_files(a, subprograms[0], b, subprograms[1], true, diag);

	json_decref(common[0]);
	json_decref(common[1]);
	return good;
}

bool shard_match(const struct ndjson_run *runs, size_t count, bool *of_blocks, struct diag *diag)
{
	if (!match_shares(runs, count, of_blocks, diag))
		return false;
	if (*of_blocks && count == 1 && !has_program(&runs[0], diag))
		return false;
	/* Any two, because a subprogram may have been read by some shards only. */
	for (size_t i = 0; i < count; i++) {
		for (size_t k = i + 1; k < count; k++) {
			if (!match_pair(&runs[i], &runs[k], *of_blocks, diag))
				return false;
		}
	}
	return true;
}

static int compare_files(const void *a, const void *b)
{
	const json_t *x = *(json_t *const *)a, *y = *(json_t *const *)b;
	int order = strcmp(ndjson_run_text(x, "kind"), ndjson_run_text(y, "kind"));

	return order ? order : strcmp(ndjson_run_text(x, "file"), ndjson_run_text(y, "file"));
}

json_t *shard_match_files(const struct ndjson_run *runs, size_t count, bool subprograms)
{
	json_t **files = NULL, *array = json_array();
	size_t found = 0, capacity = 0;

	for (size_t i = 0; i < count; i++) {
		const json_t *list = json_object_get(subprograms ? runs[i].summary : runs[i].header, "files");

		for (size_t k = 0; k < json_array_size(list); k++) {
			json_t *file = json_array_get(list, k);

			if (!ndjson_run_text(file, "kind") || !ndjson_run_text(file, "file"))
				continue;
			files = mem_grow(files, &capacity, found + 1, sizeof(json_t *));
			files[found++] = file;
		}
	}
	if (found)
		qsort(files, found, sizeof(json_t *), compare_files);
	for (size_t i = 0; i < found; i++) {
		if (!i || compare_files(&files[i - 1], &files[i]))
			json_push(array, json_incref(files[i]));
	}
	free(files);
	return array;
}
