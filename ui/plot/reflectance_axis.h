#pragma once  // internal to ui/plot

// The upper end of an axis of reflectance that stays where it is while curves change: the largest
// value seen so far as a tidy number, or where the user has put it.

#include <optional>

namespace cutis {

class ReflectanceAxis {
 public:
  // 1 while nothing was seen.
  double maximum() const;
  bool isAutomatic() const { return !chosen_; }

  // Not finite values are ignored.
  void see(double value);
  // The next smaller or larger tidy number, so many times: negative for smaller.
  void step(int count);
  void setAutomatic() { chosen_.reset(); }
  // Nothing seen, nothing chosen.
  void forget();

 private:
  double seen_ = 0.0;
  std::optional<double> chosen_;
};

}  // namespace cutis
