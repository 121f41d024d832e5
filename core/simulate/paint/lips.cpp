#include "core/simulate/paint/lips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simulate/paint/gradient_noise.h"
#include "core/simulate/paint/soft_area.h"

namespace cutis {
namespace {

constexpr std::uint64_t kLipsStream = 300;

float bump(float value, float width) {
  return std::exp(-value * value / (width * width));
}

// 1 where the noise is 0, falling to 0 over `width`.
float crease(float noise, float width) {
  return std::max(0.0f, 1.0f - std::abs(noise) / width);
}

}  // namespace

// Along and across the mouth, in half widths: u from −1 to 1, v downwards from the line between the
// lips.
struct Lips::Place {
  float u, v;
  float heightAbove, heightBelow;  // of the lips at u, from the line between them
};

struct Lips::Texture {
  float lines;  // logarithm of what the lines across add
  float blood;  // factor on the haemoglobin
  float gap;    // 1 between the lips, 0 away from there
};

Lips::Lips(const LipsRecipe& recipe, const PatchFrame& frame, std::uint64_t seed)
    : recipe_(recipe),
      key_(noiseKey(seed, kLipsStream)),
      x_(frame.x(recipe.x)),
      y_(frame.y(recipe.y)),
      halfWidth_(frame.length(recipe.halfWidth)),
      softness_(std::max(frame.length(recipe.softness), 0.5f)),
      cosine_(std::cos(radians(recipe.angle))),
      sine_(std::sin(radians(recipe.angle))) {}

Lips::Place Lips::placeOf(float x, float y) const {
  const float dx = (x - x_) / halfWidth_;
  const float dy = (y - y_) / halfWidth_;
  const float u = dx * cosine_ + dy * sine_;
  const float across = dy * cosine_ - dx * sine_;
  const float rest = std::max(0.0f, 1.0f - u * u);
  const float side = std::abs(u);
  // The line between the lips sinks towards the corners, and in the middle under the tubercle.
  const float line = 0.05f * u * u + 0.03f * bump(u, 0.15f) - 0.018f * bump(side - 0.3f, 0.2f);
  // Cupid's bow: two peaks and a dip between.
  const float bow = 1.0f + 0.1f * bump(side - 0.22f, 0.14f) - 0.17f * bump(u, 0.13f);
  const float above = static_cast<float>(recipe_.upper) * rest * (0.72f + 0.28f * rest) * bow;
  const float below =
      static_cast<float>(recipe_.lower) * std::pow(rest, 0.9f) * (0.9f + 0.1f * rest);
  return {u, across - line, above + line, below - line};
}

float Lips::depth(const Place& place) const {
  const float vertical = std::min(place.v + place.heightAbove, place.heightBelow - place.v);
  return std::min(vertical, 1.0f - std::abs(place.u)) * halfWidth_;
}

float Lips::depth(float x, float y) const {
  return depth(placeOf(x, y));
}

// Share of lip in a pixel, over a slightly ragged border.
float Lips::cover(const Place& place) const {
  const float inside = depth(place);
  if (inside < -2.5f * softness_) return 0.0f;
  const float ragged = gradientNoise(key_, 9.0f * place.u, 9.0f * place.v);
  return smoothStep(-softness_, 2.0f * softness_, inside + 0.35f * softness_ * ragged);
}

Lips::Texture Lips::textureAt(const Place& place) const {
  const float rest = std::max(0.0f, 1.0f - place.u * place.u);
  // Lines fan out from the middle.
  const float fan = place.u / (1.0f + 0.8f * std::abs(place.v));
  const float coarse = gradientNoise(key_ + 1, 13.0f * fan, 1.6f * place.v);
  const float fine = gradientNoise(key_ + 2, 34.0f * fan, 3.0f * place.v);
  const float grain = gradientNoise(key_ + 3, 60.0f * fan, 30.0f * place.v);
  const float mottle = gradientNoise(key_ + 4, 9.0f * place.u, 9.0f * place.v);
  const float lines = static_cast<float>(recipe_.lines) *
                      (1.6f * crease(coarse, 0.28f) + 0.8f * crease(fine, 0.5f) - 0.4f);

  // Full lips are palest where they bulge, and the upper is the darker one.
  const bool isUpper = place.v < 0.0f;
  const float height = std::max(isUpper ? place.heightAbove : place.heightBelow, 0.01f);
  const float bulge = rest * bump(std::abs(place.v) / height - 0.5f, 0.4f);
  const float blood = std::exp(lines + 0.14f * mottle + 0.05f * grain - 0.3f * bulge);

  // One thinner than a pixel is spread over it.
  const float thickness = 0.008f + 0.014f * rest * (1.0f + 0.25f * mottle);
  const float drawn = std::max(thickness, 0.6f / halfWidth_);
  const float gap = thickness / drawn * bump(place.v, drawn) * smoothStep(0.0f, 0.15f, rest);
  return {lines + 0.15f * grain, isUpper ? 1.12f * blood : blood, gap};
}

void Lips::paint(PatchTile& tile) const {
  const float reach = 1.2f * halfWidth_ + 4.0f * softness_;
  const Rect rect = intersection(tile.rect, pixelsAround(x_, y_, reach));
  const auto lip = [&](Parameter parameter) {
    return static_cast<float>(recipe_.parameters[static_cast<std::size_t>(parameter)]);
  };
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const Place place = placeOf(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float share = cover(place);
      if (share <= 0.0f) continue;
      const Texture texture = textureAt(place);
      const auto set = [&](Parameter parameter, float value) {
        float& old = tile.at(parameter, tile.index(x, y));
        old = mix(old, value, share);
      };
      set(kMelanin, lip(kMelanin) * std::exp(0.5f * texture.lines) + 0.06f * texture.gap);
      set(kMelaninBlend, mix(lip(kMelaninBlend), 0.7f, texture.gap));
      set(kHaemoglobinDermal, lip(kHaemoglobinDermal) * texture.blood);
      set(kHaemoglobinEpidermal, lip(kHaemoglobinEpidermal) * texture.blood + 0.08f * texture.gap);
      set(kCarotene, lip(kCarotene));
    }
  }
}

}  // namespace cutis
