#include "core/simulate/paint/gradient_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cutis {
namespace {

// Brings the noise of unit gradients to a standard deviation of 1.
constexpr float kScale = 4.6f;

struct Direction {
  float x, y;
};

// A unit vector: half a circle in rational form, then mirrored by two more bits.
Direction direction(std::uint64_t bits) {
  const float t = static_cast<float>(static_cast<std::uint32_t>(bits)) * 0x1p-32f;
  const float scale = kScale / (1.0f + t * t);
  float x = (1.0f - t * t) * scale;
  float y = 2.0f * t * scale;
  if (bits >> 32 & 1) x = -x;
  if (bits >> 33 & 1) y = -y;
  return {x, y};
}

float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

// This does without a call into the library, which std::floor is below SSE4.
int floorToInt(float value) {
  const int towardsZero = static_cast<int>(value);
  return towardsZero - (value < static_cast<float>(towardsZero) ? 1 : 0);
}

}  // namespace

float gradientNoise(std::uint64_t key, float x, float y) {
  const int i = floorToInt(x);
  const int j = floorToInt(y);
  const float dx = x - static_cast<float>(i);
  const float dy = y - static_cast<float>(j);
  const auto corner = [&](int a, int b) {
    const Direction g = direction(latticeBits(key, i + a, j + b));
    return g.x * (dx - static_cast<float>(a)) + g.y * (dy - static_cast<float>(b));
  };
  const float u = fade(dx);
  return mix(mix(corner(0, 0), corner(1, 0), u), mix(corner(0, 1), corner(1, 1), u), fade(dy));
}

NoiseRows::NoiseRows(std::uint64_t key, float cell, float offsetX, float offsetY, const Rect& rect)
    : key_(key),
      cell_(cell),
      offsetY_(offsetY),
      firstColumn_(floorToInt((static_cast<float>(rect.x0) + 0.5f) / cell + offsetX)) {
  for (int x = rect.x0; x < rect.x1; ++x) {
    const float position = (static_cast<float>(x) + 0.5f) / cell + offsetX;
    const int column = floorToInt(position);
    while (firstColumn_ + static_cast<int>(starts_.size()) <= column) {
      starts_.push_back(static_cast<std::size_t>(x - rect.x0));
    }
    const float dx = position - static_cast<float>(column);
    dx_.push_back(dx);
    fade_.push_back(fade(dx));
  }
  above_.resize(starts_.size() + 1);
  below_.resize(starts_.size() + 1);
  loadRow(floorToInt((static_cast<float>(rect.y0) + 0.5f) / cell + offsetY));
}

void NoiseRows::loadLattice(int row, std::vector<Gradient>& gradients) const {
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    const Direction g = direction(latticeBits(key_, firstColumn_ + static_cast<int>(i), row));
    gradients[i] = {g.x, g.y};
  }
}

void NoiseRows::loadRow(int row) {
  loadLattice(row, above_);
  loadLattice(row + 1, below_);
  latticeRow_ = row;
}

void NoiseRows::add(int y, float weight, float* out) {
  const float position = (static_cast<float>(y) + 0.5f) / cell_ + offsetY_;
  const int row = floorToInt(position);
  if (row == latticeRow_ + 1) {
    above_.swap(below_);
    loadLattice(row + 1, below_);
    latticeRow_ = row;
  } else if (row != latticeRow_) {
    loadRow(row);
  }

  // On a row of pixels a corner's share is linear in x: blend the two lattice rows once, then from
  // the left to the right corner pixel by pixel.
  const float dy = position - static_cast<float>(row);
  const float v = fade(dy);
  const auto slope = [&](std::size_t i) { return weight * mix(above_[i].x, below_[i].x, v); };
  const auto value = [&](std::size_t i) {
    return weight * mix(above_[i].y * dy, below_[i].y * (dy - 1.0f), v);
  };
  float leftSlope = slope(0);
  float leftValue = value(0);
  for (std::size_t cell = 0; cell < starts_.size(); ++cell) {
    const float rightSlope = slope(cell + 1);
    const float rightValue = value(cell + 1);
    const float slopeChange = rightSlope - leftSlope;
    const float valueChange = rightValue - rightSlope - leftValue;
    const std::size_t end = cell + 1 < starts_.size() ? starts_[cell + 1] : dx_.size();
    for (std::size_t i = starts_[cell]; i < end; ++i) {
      out[i] += leftValue + leftSlope * dx_[i] + fade_[i] * (valueChange + slopeChange * dx_[i]);
    }
    leftSlope = rightSlope;
    leftValue = rightValue;
  }
}

FractalRows::FractalRows(const NoiseRecipe& recipe, std::uint64_t key, const PatchFrame& frame,
                         const Rect& rect)
    : width_(static_cast<std::size_t>(rect.width())) {
  double power = 0.0;
  for (int k = 0; k < recipe.octaves; ++k)
    power += std::pow(recipe.gain, 2 * k);
  for (int k = 0; k < recipe.octaves; ++k) {
    const float cell = frame.length(std::ldexp(recipe.largest, -k));
    const float visible = smoothStep(1.3f, 2.6f, cell);
    const auto weight =
        static_cast<float>(recipe.deviation * std::pow(recipe.gain, k) / std::sqrt(power));
    if (visible <= 0.0f || weight <= 0.0f) continue;
    Random random(key, static_cast<std::uint64_t>(k));
    const std::uint64_t octaveKey = random.bits();
    const auto offsetX = static_cast<float>(random.uniform());
    const auto offsetY = static_cast<float>(random.uniform());
    octaves_.push_back({NoiseRows(octaveKey, cell, offsetX, offsetY, rect), weight * visible});
  }
}

void FractalRows::row(int y, float* out) {
  std::fill(out, out + width_, 0.0f);
  for (Octave& octave : octaves_)
    octave.rows.add(y, octave.weight, out);
}

}  // namespace cutis
