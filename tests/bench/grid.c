/*
 * grid.c - the usual way to know the remaining stock: a grid of cells, and the tool at instants of its path.
 *
 *     grid CELL HOLDER_END FLUTES DIAMETER SHANK HOLDER X0 Y0 Z0 X1 Y1 Z1 RAPID <PATH
 *
 * For three axes with an upright ball cutter, in the best form of the method: one bit for each cell, those over one
 * another in words, so that a cutter clears a whole column in a few operations; what stands above the blank is not
 * looked at. Lengths in mm. HOLDER_END and FLUTES are the heights of the holder's and the shank's lower ends over the
 * tip; DIAMETER, SHANK and HOLDER are diameters; then the box of the blank. PATH is the table of `fivecheck
 * --dump-path`; what is faster than RAPID mm/s is a rapid.
 *
 * Instants are as far apart as leaves cusps of half a cell between them. Nothing is known between two instants, and a
 * cell leaves when its centre is inside the cutter, so there is no bound of the error. Prints the seconds of processor
 * time without reading the path, and the number of instants at which the tool was in what is left.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct grid {
	double cell, low[3];
	long count[3];	/* cells along each axis */
	long words;	/* of one column */
	uint64_t *bits;	/* column by column */
};

/* A part of the tool: what is below `radius` of the axis and above `bottom` over the tip; or the cutter's ball. */
struct part {
	double radius, bottom;
	int ball;
};

/* Whole cells from `first` to the top: clears them, or tells whether one of them is there. */
static int above(const struct grid *grid, uint64_t *column, long first, int clear)
{
	long word = first > 0 ? first / 64 : 0;
	uint64_t mask = first > 0 ? ~(uint64_t)0 << first % 64 : ~(uint64_t)0;
	int found = 0;

	for (; word < grid->words; word++, mask = ~(uint64_t)0) {
		found = found || (column[word] & mask);
		if (clear)
			column[word] &= ~mask;
	}
	return found;
}

static long cell_at(const struct grid *grid, int axis, double x)
{
	return (long)ceil((x - grid->low[axis]) / grid->cell - 0.5);
}

static long bounded(long cell, long count)
{
	return cell < 0 ? 0 : cell > count ? count : cell;
}

/* The part stands with the tip at `tip`. */
static int meet(const struct grid *grid, const struct part *part, const double tip[3], int clear)
{
	const long x0 = bounded(cell_at(grid, 0, tip[0] - part->radius), grid->count[0]);
	const long x1 = bounded(cell_at(grid, 0, tip[0] + part->radius), grid->count[0]);
	const double r2 = part->radius * part->radius;
	int found = 0;

	if (cell_at(grid, 2, tip[2] + part->bottom) >= grid->count[2])
		return 0;
	for (long x = x0; x < x1; x++) {
		const double dx = grid->low[0] + ((double)x + 0.5) * grid->cell - tip[0];
		const double room = sqrt(fmax(r2 - dx * dx, 0));
		const long y0 = bounded(cell_at(grid, 1, tip[1] - room), grid->count[1]);
		const long y1 = bounded(cell_at(grid, 1, tip[1] + room), grid->count[1]);

		for (long y = y0; y < y1; y++) {
			const double dy = grid->low[1] + ((double)y + 0.5) * grid->cell - tip[1];
			const double d2 = dx * dx + dy * dy;
			const double rise = part->ball ? part->radius - sqrt(fmax(r2 - d2, 0)) : 0;

			found |= above(grid, &grid->bits[(x * grid->count[1] + y) * grid->words],
				       cell_at(grid, 2, tip[2] + part->bottom + rise), clear);
		}
	}
	return found;
}

static int grid_init(struct grid *grid, double cell, const double low[3], const double high[3])
{
	size_t size;

	grid->cell = cell;
	for (int k = 0; k < 3; k++) {
		grid->low[k] = low[k];
		grid->count[k] = (long)ceil((high[k] - low[k]) / cell);
	}
	grid->words = (grid->count[2] + 63) / 64;
	size = (size_t)(grid->count[0] * grid->count[1] * grid->words) * sizeof(*grid->bits);
	grid->bits = malloc(size);
	if (!grid->bits)
		return 0;
	memset(grid->bits, 0xff, size);
	/* What is above the blank is empty. */
	for (long i = 0; i < grid->count[0] * grid->count[1] && grid->count[2] % 64; i++)
		grid->bits[i * grid->words + grid->words - 1] = ((uint64_t)1 << grid->count[2] % 64) - 1;
	return 1;
}

/* The columns X, Y, Z and time of a row: line move tool X Y Z time deviation. */
static int read_row(char *line, int time_column, double row[4])
{
	int column = 0, found = 0;

	for (char *word = strtok(line, "\t\n"); word; word = strtok(NULL, "\t\n"), column++) {
		if (column >= 3 && column < 6)
			row[column - 3] = strtod(word, NULL);
		if (column == time_column)
			row[3] = strtod(word, NULL);
		found += (column >= 3 && column < 6) || column == time_column;
	}
	return found == 4;
}

struct path {
	double (*rows)[4];
	size_t count, capacity;
};

static void read_path(struct path *path)
{
	char line[1024];

	for (int first = 1; fgets(line, sizeof(line), stdin); first = 0) {
		if (path->count == path->capacity) {
			path->capacity = 2 * path->capacity + 1024;
			path->rows = realloc(path->rows, path->capacity * sizeof(*path->rows));
			if (!path->rows)
				exit(2);
		}
		if (!first && read_row(line, 6, path->rows[path->count]))
			path->count++;
	}
}

static long follow(const struct grid *grid, const struct part parts[3], double rapid, const struct path *path)
{
	const double apart = sqrt(8 * parts[0].radius * 0.5 * grid->cell);
	long found = 0;

	for (size_t row = 1; row < path->count; row++) {
		const double *last = path->rows[row - 1], *next = path->rows[row];
		const double d[3] = {next[0] - last[0], next[1] - last[1], next[2] - last[2]};
		const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
		const long steps = (long)ceil(length / apart);
		const int fast = length > rapid * (next[3] - last[3]);

		for (long i = 1; i <= steps; i++) {
			const double s = (double)i / (double)steps;
			const double tip[3] = {last[0] + s * d[0], last[1] + s * d[1], last[2] + s * d[2]};

			found += meet(grid, &parts[0], tip, !fast) && fast;
			found += meet(grid, &parts[1], tip, 0) || meet(grid, &parts[2], tip, 0);
		}
	}
	return found;
}

int main(int argc, char **argv)
{
	struct path path = {NULL, 0, 0};
	double value[13];
	struct grid grid;
	clock_t start;
	long found;

	if (argc != 14) {
		fprintf(stderr, "usage: grid CELL HOLDER_END FLUTES DIAMETER SHANK HOLDER X0 Y0 Z0 X1 Y1 Z1 RAPID <PATH\n");
		return 2;
	}
	for (int i = 0; i < 13; i++)
		value[i] = strtod(argv[i + 1], NULL);
	read_path(&path);
	start = clock();
	if (!grid_init(&grid, value[0], &value[6], &value[9])) {
		fprintf(stderr, "grid: too many cells\n");
		return 2;
	}
	found = follow(&grid,
		       (struct part[]){{value[3] / 2, 0, 1}, {value[4] / 2, value[2], 0}, {value[5] / 2, value[1], 0}},
		       value[12], &path);
	printf("%.6f %ld\n", (double)(clock() - start) / CLOCKS_PER_SEC, found);
	free(grid.bits);
	free(path.rows);
	return 0;
}
