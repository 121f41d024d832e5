#pragma once

// Edits of skin by its biology: pure functions from parameters to parameters.
//
// An edit changes any of the five parameters of every pixel that has an estimate, blended by a mask
// and an opacity; a stack applies its edits from first to last. Results are clamped to the
// profile's ranges.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/skin/parameter_buffer.h"
#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// The largest factor that a person or a file may give.
inline constexpr double kMostScale = 1000.0;

// value → set, if given, else scaled + add.
//
// What a factor makes of a value is the parameter's law of editing (EditLaw).
struct ParameterEdit {
  double scale = 1.0;  // not negative
  double add = 0.0;    // in the parameter's unit
  std::optional<double> set;

  bool isNeutral() const { return scale == 1.0 && add == 0.0 && !set; }
  bool operator==(const ParameterEdit&) const = default;
};

struct Edit {
  std::array<ParameterEdit, kParameterCount> parameters;
  // 0 and NaN leave the original, 1 gives the edited value, between blends. Empty: everywhere 1.
  // Otherwise the size of the maps.
  Plane mask;
  double opacity = 1.0;  // [0, 1]
  bool enabled = true;
  std::string name;  // what people call it; may be empty

  bool isNeutral() const;
};

using EditStack = std::vector<Edit>;

// Whether the edited maps are the original ones.
bool isNeutral(const EditStack& edits);

// The edited value of one parameter, of the table or further, clamped to the axis.
double editedValue(const ParameterEdit& edit, EditLaw law, const ParameterAxis& axis, double value);

// Edits the pixels of a buffer that was loaded from `rect` with `step` (see loadParameters).
Status applyEdits(const EditStack& edits, const ParameterAxes& axes, const Rect& rect, int step,
                  ParameterBuffer& buffer);

}  // namespace cutis
