#include "src/color/transfer_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cutis {
namespace {

double curveAt(const TransferCurve::Parameters& p, double x) {
  return x >= p.d ? std::pow(p.a * x + p.b, p.g) + p.e : p.c * x + p.f;
}

// Where the power part begins, as light.
double lightOfPower(const TransferCurve::Parameters& p) {
  return std::pow(std::max(0.0, p.a * p.d + p.b), p.g) + p.e;
}

double inverseAt(const TransferCurve::Parameters& p, double y) {
  if (std::isnan(y)) return y;
  if (y >= lightOfPower(p)) return (std::pow(std::max(0.0, y - p.e), 1.0 / p.g) - p.b) / p.a;
  if (p.c == 0.0) return std::min(0.0, p.d);
  return std::min((y - p.f) / p.c, p.d);
}

// Between entries, and beyond the ends along the first and last step.
double interpolated(const std::vector<double>& table, double x) {
  if (std::isnan(x)) return x;
  const double steps = static_cast<double>(table.size() - 1);
  const double at = std::clamp(std::floor(x * steps), 0.0, steps - 1.0);
  const auto i = static_cast<std::size_t>(at);
  return table[i] + (x * steps - at) * (table[i + 1] - table[i]);
}

// Where y lies in a table that never falls.
double positionOf(const std::vector<double>& table, double y) {
  if (std::isnan(y)) return y;
  const double steps = static_cast<double>(table.size() - 1);
  auto above = std::lower_bound(table.begin(), table.end(), y);
  if (above == table.begin()) {
    // Below the first entry, or at it.
    above = std::next(table.begin());
  } else if (above == table.end()) {
    // Beyond what the samples reach; without a rise at the end there is nothing beyond.
    above = std::lower_bound(table.begin(), table.end(), table.back());
    if (above == table.begin()) return 0.0;
  }
  const auto i = static_cast<std::size_t>(above - table.begin()) - 1;
  const double rise = table[i + 1] - table[i];
  const double within = rise > 0.0 ? (y - table[i]) / rise : 0.0;
  return (static_cast<double>(i) + within) / steps;
}

std::vector<double> raised(std::vector<double> table) {
  for (std::size_t i = 1; i < table.size(); ++i)
    table[i] = std::max(table[i], table[i - 1]);
  return table;
}

}  // namespace

TransferCurve TransferCurve::power(double exponent) {
  return parametric({.g = exponent});
}

TransferCurve TransferCurve::srgb() {
  // IEC 61966-2-1.
  return parametric(
      {.g = 2.4, .a = 1.0 / 1.055, .b = 0.055 / 1.055, .c = 1.0 / 12.92, .d = 0.04045});
}

TransferCurve TransferCurve::parametric(const Parameters& parameters) {
  TransferCurve curve;
  curve.parameters_ = parameters;
  curve.odd_ = curveAt(parameters, 0.0) == 0.0;
  return curve;
}

TransferCurve TransferCurve::sampled(std::vector<double> light) {
  TransferCurve curve;
  curve.odd_ = light.front() == 0.0;
  curve.rising_ = std::make_shared<const std::vector<double>>(raised(light));
  curve.samples_ = std::make_shared<const std::vector<double>>(std::move(light));
  return curve;
}

TransferCurve TransferCurve::ofFormula(const Formula& formula) {
  TransferCurve curve;
  curve.formula_ = &formula;
  return curve;
}

TransferCurve TransferCurve::between(double black, double white) const {
  TransferCurve curve = *this;
  curve.black_ = black;
  curve.white_ = white;
  return curve;
}

double TransferCurve::lightAt(double number) const {
  if (formula_ != nullptr) return formula_->toLight(number);
  return samples_ ? interpolated(*samples_, number) : curveAt(parameters_, number);
}

double TransferCurve::numberAt(double light) const {
  if (formula_ != nullptr) return formula_->fromLight(light);
  return samples_ ? positionOf(*rising_, light) : inverseAt(parameters_, light);
}

double TransferCurve::toLight(double number) const {
  const double own = (number - black_) / (white_ - black_);
  const bool mirrored = odd_ && own < 0.0;
  const double y = lightAt(mirrored ? -own : own);
  return mirrored ? -y : y;
}

double TransferCurve::fromLight(double light) const {
  const bool mirrored = odd_ && light < 0.0;
  const double own = numberAt(mirrored ? -light : light);
  return black_ + (mirrored ? -own : own) * (white_ - black_);
}

bool TransferCurve::isRising() const {
  const double low = toLight(0.0), middle = toLight(0.5), high = toLight(1.0);
  const double back = fromLight(middle);
  return std::isfinite(low) && std::isfinite(back) && high > low && low <= middle &&
         middle <= high && high < 100.0;
}

bool TransferCurve::isLinear() const {
  if (formula_ != nullptr || isBetweenOthers()) return false;
  if (!samples_) return parameters_ == Parameters();
  const double steps = static_cast<double>(samples_->size() - 1);
  for (std::size_t i = 0; i < samples_->size(); ++i) {
    // A 16-bit entry is rounded.
    if (std::abs((*samples_)[i] - static_cast<double>(i) / steps) > 1.0 / 65535.0) return false;
  }
  return true;
}

std::optional<TransferCurve::Parameters> TransferCurve::parameters() const {
  if (samples_ || formula_ != nullptr || isBetweenOthers()) return std::nullopt;
  return parameters_;
}

const std::vector<double>& TransferCurve::samples() const {
  static const std::vector<double> none;
  return samples_ && !isBetweenOthers() ? *samples_ : none;
}

}  // namespace cutis
