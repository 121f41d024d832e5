#pragma once  // internal to core/fit/refined

// What the kernel of the refined fit is given, put together from the model, the rig's nodes and
// what is known beforehand. Thread-safe: const after construction.

#include <vector>

#include "core/fit/fit_options.h"
#include "core/fit/refined/channel_discrepancy.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/rig/rig.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/skin_model.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// A problem with the arrays it points to, for one precision: float or double. Has no start, no
// tolerance and the usual limit of rounds; parameters are held, and there is shading, as the
// options say.
template <typename T>
class RefinedProblemData {
 public:
  // nodes: weights of the channels, and behind them those of other rows, which do not count.
  RefinedProblemData(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
                     const NoiseModel& noise, const FitOptions& options,
                     const ChannelDiscrepancy& discrepancy = {});
  RefinedProblemData(const RefinedProblemData&) = delete;
  RefinedProblemData& operator=(const RefinedProblemData&) = delete;

  RefinedProblem<T>& problem() { return problem_; }
  const RefinedProblem<T>& problem() const { return problem_; }

 private:
  void setCoordinates(const ParameterAxes& axes, const Prior& prior, const FitOptions& options);
  // Where a chromophore outweighs the absorption of the tissue without it, in the green.
  void setCurvature(const SkinModel& model);
  void setDiscrepancy(const ChannelDiscrepancy& discrepancy);

  CompiledModel model_;
  std::vector<T> weights_;
  RefinedProblem<T> problem_ = {};
};

}  // namespace cutis
