/* random.h - a stream of random numbers that is the same on all computers for the same seed. */
#ifndef CAMPAIGN_RANDOM_H
#define CAMPAIGN_RANDOM_H

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "../bench/plain_scene.h"

class Random {
public:
	/* Each case of a campaign has its own stream. */
	Random(uint64_t seed, uint64_t number) : engine_(seed * 0x9e3779b97f4a7c15 + number)
	{
	}

	/* The distributions of the standard library differ between implementations. */
	double in(double low, double high)
	{
		return low + (high - low) * ((double)(engine_() >> 11) * 0x1p-53);
	}

	/* Each decade is equally probable. */
	double size(double low, double high)
	{
		return std::exp(in(std::log(low), std::log(high)));
	}

	int below(int count)
	{
		return (int)(engine_() % (uint64_t)count);
	}

	bool chance(double share)
	{
		return in(0, 1) < share;
	}

	vec point(double reach)
	{
		double x = in(-reach, reach), y = in(-reach, reach);

		return vec_of(x, y, in(-reach, reach));
	}

	vec direction()
	{
		for (;;) {
			vec v = point(1);

			if (norm(v) > 0.1 && norm(v) <= 1)
				return times(1 / norm(v), v);
		}
	}

	template <class T> void shuffle(std::vector<T> &items)
	{
		for (size_t i = items.size(); i > 1; i--)
			std::swap(items[i - 1], items[(size_t)below((int)i)]);
	}

private:
	std::mt19937_64 engine_;
};

#endif
