#pragma once

// Rows × pixels in memory: the one form in which channels, parameters and results of many pixels
// are handed about, and the samples of a network with them.
//
// A row holds one value of every pixel (a channel, a parameter, the reflectance at a node); rows
// lie `stride` elements apart, so that a part of the pixels is a view like the whole and nothing is
// copied to narrow it. T is float or double, const where the rows are only read.
//
// PixelRows is plain data (core/skin/layers/node_constants.h says why): kernels read the members
// and call no function of it. It owns nothing and is copied freely. PixelBuffer owns what it holds.
// Thread-safe as far as the memory is.

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace cutis {

template <typename T>
struct PixelRows {
  T* data = nullptr;
  std::size_t rowCount = 0;
  std::size_t count = 0;   // pixels
  std::size_t stride = 0;  // from an element to the same pixel's in the next row, at least `count`

  T* row(std::size_t k) const { return data + k * stride; }
  T& at(std::size_t k, std::size_t pixel) const { return data[k * stride + pixel]; }

  // Pixels [first, first + size) of all rows.
  PixelRows part(std::size_t first, std::size_t size) const {
    return {data + first, rowCount, size, stride};
  }

  operator PixelRows<const T>() const requires(!std::is_const_v<T>) {
    return {data, rowCount, count, stride};
  }
};

// Rows one right after the other.
template <typename T>
PixelRows<T> packedRows(T* data, std::size_t rowCount, std::size_t count) {
  return {data, rowCount, count, count};
}

template <typename T>
class PixelBuffer {
 public:
  PixelBuffer() = default;
  // All 0.
  PixelBuffer(std::size_t rowCount, std::size_t count)
      : rowCount_(rowCount), count_(count), values_(rowCount * count) {}

  std::size_t rowCount() const { return rowCount_; }
  std::size_t count() const { return count_; }
  bool empty() const { return values_.empty(); }

  std::span<T> operator[](std::size_t k) {
    return std::span<T>(values_).subspan(k * count_, count_);
  }
  std::span<const T> operator[](std::size_t k) const {
    return std::span<const T>(values_).subspan(k * count_, count_);
  }

  PixelRows<T> rows() { return packedRows(values_.data(), rowCount_, count_); }
  PixelRows<const T> rows() const { return packedRows(values_.data(), rowCount_, count_); }

  bool operator==(const PixelBuffer&) const = default;

 private:
  std::size_t rowCount_ = 0;
  std::size_t count_ = 0;
  std::vector<T> values_;  // [row][pixel]
};

}  // namespace cutis
