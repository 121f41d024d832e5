#pragma once

// A response as a table over the five parameters, read by simplex interpolation: for pictures that
// must follow a hand, at a fifth of the time of the model and within a stated error of it.
//
// Logarithms are interpolated, since what absorbs multiplies. Colours lie within ΔE2000 0.3 of the
// model's, within 0.06 on average over the ranges of the parameters (li2024 and skin2026,
// tests/core/skin/response_table_test.cpp). Samples lie closest where there is little of a
// parameter, since there it changes most.

#include <span>
#include <vector>

#include "core/base/pixel_rows.h"
#include "core/skin/profile/parameter_axis.h"
#include "core/skin/response_model.h"

namespace cutis {

// The samples of a table for a profile with these ranges.
ParameterAxes responseTableAxes(const ParameterAxes& ranges);

// Thread-safe: const after construction.
class ResponseTable {
 public:
  // Some milliseconds and 0.7 MB per row of the response. A discrepancy is taken at its mean:
  // coefficients are not among the parameters of a table. Precondition: no constant of the
  // response is free.
  ResponseTable(const ResponseModel& response, const ParameterAxes& ranges);

  int rowCount() const { return rowCount_; }

  // The first kParameterCount rows of `values` are read, as ResponseModel::evaluate() reads them;
  // what lies beyond a range is taken as its end. out[row][i] for each pixel of them.
  void evaluate(PixelRows<const float> values, std::span<float* const> out) const;

 private:
  int rowCount_ = 0;
  ParameterAxes axes_;
  std::vector<float> samples_;  // logarithms, [melanin][blend][dermal][epidermal][carotene][row]
};

}  // namespace cutis
