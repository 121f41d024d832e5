#pragma once

// Arrays of floats that begin at a line of the cache: vectors that straddle two lines cost the
// kernels of networks a quarter of their speed.

#include <cstddef>
#include <new>
#include <vector>

namespace cutis {

inline constexpr std::size_t kCacheLine = 64;

template <typename T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <typename U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(kCacheLine)));
  }
  void deallocate(T* at, std::size_t) { ::operator delete(at, std::align_val_t(kCacheLine)); }

  bool operator==(const CacheLineAllocator&) const = default;
};

using AlignedFloats = std::vector<float, CacheLineAllocator<float>>;

}  // namespace cutis
