#pragma once  // internal to src/report/plot

// From values to places along an axis.

namespace cutis {

struct Scale {
  double from = 0.0, to = 1.0;    // values; positive where logarithmic
  double begin = 0.0, end = 1.0;  // their places
  bool logarithmic = false;

  // Values beyond the ends lie beyond the ends. What has no place (NaN, and where logarithmic what
  // is not positive) is not finite.
  double at(double value) const;
  // The value at a place.
  double valueAt(double place) const;

  bool operator==(const Scale&) const = default;
};

// A scale that can be drawn, whatever the ends are: where one is not finite, not in order or,
// logarithmic, not positive, the axis begins at 0 or 1, or has a length of its own.
Scale usableScale(double from, double to, bool logarithmic, double begin, double end);

}  // namespace cutis
