#pragma once  // internal to core/fit/table

// Vectorised parts of core/fit/table/skin_table.cpp. Plain data, see
// core/skin/layers/node_constants.h.

#include <cstddef>

#include "core/skin/layers/node_constants.h"

namespace cutis {

inline constexpr int kMaximumTableRows = 16;
// What is known of an epidermis at a node: R⁺, R⁻ and T⁺T⁻, or the polynomial's columns.
inline constexpr std::size_t kEpidermisNumbers = kDermalTerms;

struct TableArguments {
  const NodeConstants<float>* nodes = nullptr;
  std::size_t nodeCount = 0;
  LayerConstants<float> layers = {};

  const float* dermalBlood = nullptr;  // dermalStride values
  std::size_t dermalStride = 0;        // multiple of the widest vector
  // [node][dermalStride]: reflectance of the half-space, or, where radiative transfer is a
  // polynomial, the dermis's variable in it.
  float* dermis = nullptr;

  const float* weights = nullptr;  // [node][kMaximumTableRows]
  std::size_t rowCount = 0;

  // One epidermis.
  float melanin = 0.0f;
  float blend = 0.0f;
  float epidermalBlood = 0.0f;
  float carotene = 0.0f;
  float* scratch = nullptr;
  float* out = nullptr;  // [row][dermalStride]

  std::size_t scratchSize() const { return kEpidermisNumbers * nodeCount; }
};

// The smallest multiple of the widest vector that holds count floats.
std::size_t roundUpToTableLanes(std::size_t count);

// Every dermis at every node.
void runDermisKernel(const TableArguments& arguments);

// Rows of one epidermis over every dermis.
void runTableKernel(const TableArguments& arguments);

}  // namespace cutis
