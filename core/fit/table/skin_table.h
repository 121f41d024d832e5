#pragma once

// The table of skin (paper, supplement A): channels of every combination of the profile's parameter
// samples, 51 · 11 · 5 · 51 · 4 = 572,220 entries for li2024.
//
// Entries are ordered by melanin, blend, carotene, dermal and epidermal haemoglobin, the last
// running fastest: each stage of the three-stage search then reads one contiguous block.
//
// Built separably: at one wavelength the epidermis is three numbers of four parameters and the
// dermis one number of its blood, so 572,220 × 351 reflectances take 11,220 × 351 slabs, 51 × 351
// half-spaces and one adding step each. Spectra are summed into channels as they arise.

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/table/table_kernel.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/grid.h"

namespace cutis {

class SkinTable {
 public:
  SkinTable() = default;
  SkinTable(const ParameterAxes& axes, int channelCount);

  const ParameterAxes& axes() const { return axes_; }
  int channelCount() const { return static_cast<int>(channels_.size()); }
  std::size_t size() const { return size_; }

  // Value of one channel for all entries.
  std::vector<float>& channel(int k) { return channels_[static_cast<std::size_t>(k)]; }
  const std::vector<float>& channel(int k) const { return channels_[static_cast<std::size_t>(k)]; }

  // Sample positions on the axes, indexed by Parameter, and back.
  std::size_t entry(const std::array<int, kParameterCount>& samples) const;
  std::array<int, kParameterCount> samples(std::size_t entry) const;
  ParameterVector parameters(std::size_t entry) const;

 private:
  ParameterAxes axes_;
  std::size_t size_ = 0;
  std::vector<std::vector<float>> channels_;
};

std::size_t tableSize(const ParameterAxes& axes);

// rows: what to sum, at most kMaximumTableRows. Wavelengths where all rows are zero are not
// evaluated. Single precision, within 4e-6 of SkinModel for rows that sum to 1. About 0.2 s for
// eight rows on two cores. Cancelled if asked to stop.
Result<SkinTable> buildSkinTable(const SkinModel& model, const SpectrumRows& rows,
                                 const JobContext& context);

}  // namespace cutis
