#include "src/report/plot/scale.h"

#include <cmath>

namespace cutis {

double Scale::at(double value) const {
  const double share =
      logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
  return begin + share * (end - begin);
}

double Scale::valueAt(double place) const {
  const double share = (place - begin) / (end - begin);
  return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
}

Scale usableScale(double from, double to, bool logarithmic, double begin, double end) {
  const auto usable = [&](double value) {
    return std::isfinite(value) && (!logarithmic || value > 0.0);
  };
  if (!usable(from)) from = logarithmic ? 1.0 : 0.0;
  if (!usable(to) || !(to > from)) to = logarithmic ? 10.0 * from : from + std::fmax(1.0, from);
  return {from, to, begin, end, logarithmic};
}

}  // namespace cutis
