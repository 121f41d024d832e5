#pragma once

// Normal random numbers by counter: the n-th of a key, without the ones before it, so that noise in
// a pixel does not depend on who drew before.
//
// Ziggurat of 128 layers (Marsaglia & Tsang 2000, in the form of Doornik 2005) on hashed counters:
// the exact distribution but for rounding to float. About 5 ns a draw.

#include <cstdint>

namespace cutis {

// Mean 0, variance 1. Thread-safe.
float normalAt(std::uint64_t key, std::uint64_t counter);

}  // namespace cutis
