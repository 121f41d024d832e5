#include "core/edit/edit_stack.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace cutis {
namespace {

// Opacity times mask per pixel; empty if it is 1 everywhere.
Result<std::vector<float>> weightsOf(const Edit& edit, const Rect& rect, int step,
                                     std::size_t count) {
  std::vector<float> weights;
  if (edit.mask.empty()) {
    if (edit.opacity < 1.0) weights.assign(count, static_cast<float>(edit.opacity));
    return weights;
  }
  std::vector<float> row(static_cast<std::size_t>(rect.width()));
  for (int y = rect.y0; y < rect.y1; y += step) {
    CUTIS_CHECK(edit.mask.load({rect.x0, y, rect.x1, y + 1}, row));
    for (std::size_t x = 0; x < row.size(); x += static_cast<std::size_t>(step)) {
      // What is no number includes nothing.
      const float included = row[x] > 0.0f ? std::min(row[x], 1.0f) : 0.0f;
      weights.push_back(included * static_cast<float>(edit.opacity));
    }
  }
  return weights;
}

void applyTo(std::span<float> values, const std::vector<bool>& present,
             const std::vector<float>& weights, const ParameterEdit& edit, EditLaw law,
             const ParameterAxis& axis) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!present[i]) continue;
    const double original = values[i];
    const double edited = editedValue(edit, law, axis, original);
    const double weight = weights.empty() ? 1.0 : double{weights[i]};
    values[i] = static_cast<float>(original + weight * (edited - original));
  }
}

}  // namespace

bool Edit::isNeutral() const {
  return !enabled || opacity == 0.0 ||
         std::all_of(parameters.begin(), parameters.end(),
                     [](const ParameterEdit& edit) { return edit.isNeutral(); });
}

bool isNeutral(const EditStack& edits) {
  return std::all_of(edits.begin(), edits.end(), [](const Edit& edit) { return edit.isNeutral(); });
}

double editedValue(const ParameterEdit& edit, EditLaw law, const ParameterAxis& axis,
                   double value) {
  if (edit.set) return axis.clamp(*edit.set);
  const double share = law == EditLaw::byIndex ? axis.index(value) / (axis.samples - 1) : 1.0;
  return axis.clamp(value * (1.0 + (edit.scale - 1.0) * share) + edit.add);
}

Status applyEdits(const EditStack& edits, const ParameterAxes& axes, const Rect& rect, int step,
                  ParameterBuffer& buffer) {
  for (const Edit& edit : edits) {
    if (edit.isNeutral()) continue;
    CUTIS_TRY(weights, weightsOf(edit, rect, step, buffer.count()));
    for (const Parameter parameter : kParameters) {
      const auto k = static_cast<std::size_t>(parameter);
      if (edit.parameters[k].isNeutral()) continue;
      applyTo(buffer.values[k], buffer.present, weights, edit.parameters[k],
              chromophoreTable()[k].editLaw, axes[k]);
    }
  }
  return {};
}

}  // namespace cutis
