#include "core/neural/dense/activation.h"

#include <array>
#include <cstddef>

namespace cutis {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"linear", "relu", "sigmoid", "squareplus"};

}  // namespace

std::string_view activationName(Activation activation) {
  return kNames[static_cast<std::size_t>(activation)];
}

std::optional<Activation> activationByName(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<Activation>(i);
  }
  return {};
}

}  // namespace cutis
