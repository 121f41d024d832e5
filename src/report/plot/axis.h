#pragma once  // internal to src/report/plot

// An axis of a plot: which values it spans and what is written beside it.

#include <functional>
#include <string>
#include <vector>

#include "src/report/plot/ticks.h"

namespace cutis {

struct Tick {
  double value = 0.0;
  std::string words;
  std::string raised;  // after the words: an exponent
  bool minor = false;  // goes first where there is no room for all

  bool operator==(const Tick&) const = default;
};

struct Axis {
  double from = 0.0, to = 1.0;
  bool logarithmic = false;
  std::vector<Tick> ticks;  // rising; those beyond the ends are not drawn
  std::string title;        // "wavelength"
  std::string unit;         // "nm"
  bool hasGrid = true;      // lines across the panel
  // Beside an axis upwards room is kept for these words, so that it stays where it is while the
  // numbers change.
  std::string widest;

  bool operator==(const Axis&) const = default;
};

// The words for a value on an axis whose ticks lie `step` apart.
using TickWords = std::function<std::string(double value, double step)>;

// With round numbers within the ends, in at most `steps` steps.
Axis linearAxis(double from, double to, int steps, const TickWords& words = tickWords);

// With 1, 2 and 5 times powers of ten within the ends, which are positive. The step told to
// `words` is the value itself.
Axis logarithmicAxis(double from, double to, const TickWords& words = tickWords);

// From a power of ten to another, as few as have both values, which are positive, between them.
// Written as 10 and an exponent.
Axis decadeAxis(double least, double most);

}  // namespace cutis
