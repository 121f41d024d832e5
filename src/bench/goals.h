#pragma once

// What this version set out to reach, and whether this run did.

#include <optional>
#include <string>
#include <vector>

#include "src/bench/figures.h"

namespace cutis {

enum class GoalUnit { none, meanSquare, seconds, microseconds, percent };

struct Goal {
  std::string key;   // for scripts
  std::string what;  // for people, with how it was come by where it was not measured as it stands
  GoalUnit unit = GoalUnit::none;
  // Either may be missing.
  std::optional<double> least;
  std::optional<double> most;
  double reached = 0.0;  // in the unit
  // Asked of two cores with AVX-512.
  bool presumesAvx512 = false;

  bool isMet() const { return !(least && !(reached >= *least)) && !(most && !(reached <= *most)); }
};

// Those that the figures say something about. Times of pictures of 2048² pixels are scaled from
// the largest that was run where that was smaller.
std::vector<Goal> goalsOf(const BenchFigures& figures);

}  // namespace cutis
