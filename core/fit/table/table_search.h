#pragma once

// The paper's two searches in the table of skin (§4, §4.1), exhaustive: what faster ones are held
// against.
//
// Distance² = ΔE76² of the white photograph + ΔL*² of the narrowband blue + ΔL*² of the narrowband
// green. CIELAB of the white photograph goes through a 3 × 3 matrix from the camera to XYZ (D65,
// 2°), least squares over the table; L* of the narrowband responses takes them for relative
// luminances. A rig without narrowband lights is searched by the white photograph alone. Ties: the
// lowest entry.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/table/nearest_kernel.h"
#include "core/fit/table/skin_table.h"
#include "core/rig/narrowband.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// The rows a search table has: those of searchChannels(), then X, Y, Z under D65.
SpectrumRows searchTableRows(const Rig& rig, const Spectrum& daylight, const Sensor& observer);

// A measured pixel as the searches see it: L*, a*, b*, L* of blue, L* of green.
using SearchFeatures = std::array<float, kMaximumFeatures>;

// Thread-safe: const after construction.
class TableSearch {
 public:
  // table: made from searchTableRows(). white: XYZ of the perfect diffuser under D65.
  TableSearch(std::shared_ptr<const SkinTable> table, const Rig& rig, const Eigen::Vector3d& white);

  const SkinTable& table() const { return *table_; }
  bool hasNarrowband() const { return channels_.hasNarrowband(); }

  // channels: one value per channel of the rig.
  SearchFeatures features(std::span<const double> channels) const;

  // Entries nearest to each query. Cost: about 0.15 ms per query and core for all entries.
  void fullSearch(std::span<const SearchFeatures> queries, std::span<std::size_t> entries) const;

  // The three stages with β-carotene fixed at sample `caroteneSample` in the first:
  // white + blue for melanin and blend, white + blue for carotene, white + green for the
  // haemoglobins. About 40 µs.
  std::size_t threeStage(const SearchFeatures& query, int caroteneSample) const;

  // The entry of the first stage alone, and what the other two make of one.
  std::size_t firstStage(const SearchFeatures& query, int caroteneSample) const;
  std::size_t laterStages(const SearchFeatures& query, std::size_t firstEntry) const;

  // Indices into SearchFeatures that a search compares: all, and those of white and blue.
  std::span<const int> fullFeatures() const;
  std::span<const int> firstStageFeatures() const;
  // One feature of all entries.
  std::span<const float> featureOfEntries(int feature) const;

  // The carotene sample that full search finds most often over the population of the error protocol
  // (`count` simulated pixels): what the first stage fixes. Of equals the lowest.
  int mostFrequentCarotene(const SkinModel& model, const Rig& rig, int count) const;

 private:
  std::size_t sampleCount(Parameter parameter) const;
  NearestArguments argumentsFor(const SearchFeatures& query, std::span<const int> features) const;

  std::shared_ptr<const SkinTable> table_;
  SearchChannels channels_;
  Eigen::Matrix3d cameraToXyz_;
  Eigen::Vector3d white_;
  std::vector<std::vector<float>> features_;  // 3 or 5, each with readable padding
};

}  // namespace cutis
