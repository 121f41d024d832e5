#pragma once  // internal to core/neural

// Whole spectra of many people at once, for training: at all 351 samples of the grid, in single
// precision (core/skin/model/reflectance_batch.h: within 2e-6 of SkinModel).

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/compiled_model.h"

namespace cutis {

// One spectrum a row.
using SpectraBlock = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic>;

// Thread-safe: const after construction.
class SpectraSource {
 public:
  explicit SpectraSource(const SkinModel& model);

  SpectraBlock spectra(const ParameterVector* people, std::size_t count) const;

  // Calls work(first, block) for the people [first, first + block.rows()), block by block, several
  // at once.
  Status forEachBlock(const std::vector<ParameterVector>& people, const JobContext& context,
                      const std::function<void(std::size_t, const SpectraBlock&)>& work) const;

 private:
  CompiledModel nodes_;
};

}  // namespace cutis
