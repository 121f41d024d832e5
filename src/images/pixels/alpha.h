#pragma once

// Alpha: the share of a pixel that its colour covers.
//
// Files hold colours either as they are (straight) or multiplied by alpha (associated, also called
// premultiplied). Everything that computes with colours wants them straight; planes that were read
// hold what their file holds, and say which it is. Where alpha is 0 there is nothing to divide by:
// such colours pass through both ways as they are, so that nothing hidden there is lost.
// Thread-safe: pure functions.

#include <span>

namespace cutis {

enum class AlphaKind {
  straight,    // also of pictures without alpha
  associated,  // colours are multiplied by alpha
};

// Associated to straight colours, in place. Precondition: as many values in both.
void divideByAlpha(std::span<float> color, std::span<const float> alpha);

// Straight to associated colours, in place. Precondition: as many values in both.
void multiplyByAlpha(std::span<float> color, std::span<const float> alpha);

}  // namespace cutis
