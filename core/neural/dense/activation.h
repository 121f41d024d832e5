#pragma once  // internal to core/neural/dense

// What a unit of a network does with its sum. The slope of each is a function of the output alone,
// so that back-propagation need not keep the sums.

#include <optional>
#include <string_view>

namespace cutis {

enum class Activation {
  linear,      // x
  relu,        // max(x, 0)
  sigmoid,     // 1 / (1 + e^(−x)); |x| above 36 counts as 36
  squareplus,  // (x + √(x² + 1)) / 2: a relu with a round corner (Barron 2021), no exponential
};

// "linear", "relu", "sigmoid", "squareplus", as they stand in files.
std::string_view activationName(Activation activation);
std::optional<Activation> activationByName(std::string_view name);

}  // namespace cutis
