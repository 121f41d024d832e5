#include "core/skin/response_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/skin/response_table_kernel.h"

namespace cutis {
namespace {

// Samples and spacing of each parameter, in their order.
struct Spacing {
  int samples;
  int exponent;
};
constexpr std::array<Spacing, kParameterCount> kSpacings = {
    {{25, 3}, {5, 1}, {17, 3}, {17, 2}, {5, 3}}};

// Far below the darkest skin in any channel; a channel that sees nothing stays at it.
constexpr float kSmallestResponse = 1e-12f;

// Parameters of all samples that have this amount of melanin, a row each.
PixelBuffer<float> sliceParameters(const ParameterAxes& axes, int melanin, std::size_t rowCount,
                                   std::size_t count) {
  PixelBuffer<float> values(rowCount, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (std::size_t k = kParameterCount; k-- > 1;) {
      const auto samples = static_cast<std::size_t>(axes[k].samples);
      values[k][i] = static_cast<float>(axes[k].value(static_cast<double>(rest % samples)));
      rest /= samples;
    }
    values[0][i] = static_cast<float>(axes[0].value(melanin));
  }
  return values;
}

}  // namespace

ParameterAxes responseTableAxes(const ParameterAxes& ranges) {
  ParameterAxes axes;
  for (std::size_t k = 0; k < kParameterCount; ++k)
    axes[k] = {ranges[k].maximum, kSpacings[k].samples, kSpacings[k].exponent};
  return axes;
}

ResponseTable::ResponseTable(const ResponseModel& response, const ParameterAxes& ranges)
    : rowCount_(response.rowCount()), axes_(responseTableAxes(ranges)) {
  assert(response.free().count() == 0);
  const auto rows = static_cast<std::size_t>(rowCount_);
  std::size_t count = 1;
  for (std::size_t k = 1; k < kParameterCount; ++k)
    count *= static_cast<std::size_t>(axes_[k].samples);
  samples_.resize(static_cast<std::size_t>(axes_[0].samples) * count * rows);
  PixelBuffer<float> reflected(rows, count);
  std::vector<float*> out;
  for (std::size_t row = 0; row < rows; ++row)
    out.push_back(reflected[row].data());
  float* slice = samples_.data();
  for (int melanin = 0; melanin < axes_[0].samples; ++melanin, slice += count * rows) {
    const auto valueRows = static_cast<std::size_t>(kParameterCount + response.coefficientCount());
    response.evaluate(sliceParameters(axes_, melanin, valueRows, count).rows(), out);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t row = 0; row < rows; ++row)
        slice[i * rows + row] = std::log(std::max(reflected[row][i], kSmallestResponse));
    }
  }
}

void ResponseTable::evaluate(PixelRows<const float> values, std::span<float* const> out) const {
  assert(out.size() == static_cast<std::size_t>(rowCount_));
  ResponseTableArguments arguments = {};
  arguments.samples = samples_.data();
  int stride = rowCount_;
  for (std::size_t k = kParameterCount; k-- > 0;) {
    const ParameterAxis& axis = axes_[k];
    arguments.axes[k] = {static_cast<float>(1.0 / axis.maximum),
                         static_cast<float>(axis.samples - 1), axis.exponent, stride};
    stride *= axis.samples;
  }
  arguments.parameters = values;
  arguments.rowCount = out.size();
  arguments.out = out.data();
  runResponseTableKernel(arguments);
}

}  // namespace cutis
