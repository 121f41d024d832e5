#pragma once  // internal to ui/widgets

// How a factor is written in its field, and what is understood when one is typed.

#include <QString>

#include "ui/widgets/slider_scale.h"

namespace cutis {

// "×1.50"; a third decimal stands only where it is not zero.
QString factorText(double factor);

struct ReadFactor {
  double factor = 1;
  QString objection;  // one sentence for the user; empty: the factor is good
};

// "1.5", "1,5", "×1.5" and "150 %" are one factor, in every language. What is no number and what
// lies outside the scale meets an objection that names the limits.
ReadFactor readFactor(const QString& text, const SliderScale& scale);

// "0 to 3 (0 % to 300 %)"
QString limitsText(const SliderScale& scale);

}  // namespace cutis
