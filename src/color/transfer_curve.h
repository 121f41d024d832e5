#pragma once  // internal to src/color

// The curve between a channel's number and light, as files state it: a power, the parametric curves
// of ICC profiles (ICC.1:2022, §10.18, types 0 to 4), samples, or a formula of video
// (video_curve.h).
//
// Numbers are 1 at the end of an integer's range, light is 1 for white. Curves that begin at 0
// continue oddly below it, others by their linear part; samples continue along their first and last
// step. NaN stays NaN. A value; copies share; any number of threads may read one.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cutis {

class TransferCurve {
 public:
  // y = (a·x + b)^g + e from x = d on, else c·x + f.
  struct Parameters {
    double g = 1.0, a = 1.0, b = 0.0, c = 0.0, d = 0.0, e = 0.0, f = 0.0;
    bool operator==(const Parameters&) const = default;
  };

  // Both ways of a curve that no parameters describe, from 0 on.
  struct Formula {
    const char* name = "";
    double (*toLight)(double number) = nullptr;
    double (*fromLight)(double light) = nullptr;
  };

  // Linear.
  TransferCurve() = default;
  static TransferCurve power(double exponent);
  static TransferCurve srgb();
  static TransferCurve parametric(const Parameters& parameters);
  // Light at equal steps of the number from 0 to 1. Precondition: at least two.
  static TransferCurve sampled(std::vector<double> light);
  // The formula outlives all curves.
  static TransferCurve ofFormula(const Formula& formula);
  // The same curve where these numbers mean what 0 and 1 do here.
  TransferCurve between(double black, double white) const;

  double toLight(double number) const;
  // The exact inverse; where several numbers mean the same light, the least of them.
  double fromLight(double light) const;

  bool isLinear() const;
  // Whether it can be followed both ways: finite, without falling, and less than 100 at 1.
  bool isRising() const;
  // What describes it wholly; neither for formulas, and between other numbers than 0 and 1.
  std::optional<Parameters> parameters() const;
  const std::vector<double>& samples() const;
  // "PQ"; empty for all that is no formula.
  std::string formulaName() const { return formula_ != nullptr ? formula_->name : ""; }

 private:
  double lightAt(double number) const;
  double numberAt(double light) const;
  bool isBetweenOthers() const { return black_ != 0.0 || white_ != 1.0; }

  Parameters parameters_;
  bool odd_ = true;
  double black_ = 0.0, white_ = 1.0;
  const Formula* formula_ = nullptr;
  std::shared_ptr<const std::vector<double>> samples_;
  // The samples without their falls, for the search.
  std::shared_ptr<const std::vector<double>> rising_;
};

}  // namespace cutis
