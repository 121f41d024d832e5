#include "core/simulate/paint/complexion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/simulate/paint/gradient_noise.h"
#include "core/simulate/paint/soft_area.h"

namespace cutis {
namespace {

enum ComplexionStream : std::uint64_t {
  kWarpX = 100,
  kWarpY,
  kBlotches,
  kFurrows,
  kParameterNoise
};

// Shapes of the noises that a recipe only scales.
NoiseRecipe warpNoise(double deviation) {
  return {deviation, 0.4, 4, 0.5};
}
constexpr NoiseRecipe kBlotchNoise = {1.0, 0.07, 5, 0.7};
NoiseRecipe furrowNoise(double size) {
  return {1.0, size, 2, 0.7};
}

constexpr bool isConcentration(std::size_t parameter) {
  return parameter != kMelaninBlend;
}

// Concentrations blend as logarithms: halfway between light and dark looks halfway.
float toBlend(std::size_t parameter, double value) {
  return static_cast<float>(isConcentration(parameter) ? std::log(std::max(value, 1e-6)) : value);
}

// A tone in pixels.
struct ToneShape {
  ToneShape(const SkinTone& tone, const PatchFrame& frame)
      : x(frame.x(tone.x)),
        y(frame.y(tone.y)),
        scaleX(1.0f / frame.x(tone.reach)),
        scaleY(1.0f / frame.y(tone.reach)) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      parameters[k] = toBlend(k, tone.parameters[k]);
    }
  }
  // 1/8 at the tone's reach.
  float weight(float px, float py) const {
    const float dx = (px - x) * scaleX;
    const float dy = (py - y) * scaleY;
    const float nearness = 1.0f / (1.0f + dx * dx + dy * dy);
    return nearness * nearness * nearness;
  }

  float x, y, scaleX, scaleY;
  std::array<float, kParameterCount> parameters;
};

// Paints a tile row by row.
class RowPainter {
 public:
  RowPainter(const SkinRecipe& recipe, const PatchFrame& frame, std::uint64_t seed, PatchTile& tile)
      : recipe_(recipe),
        side_(frame.side()),
        tile_(tile),
        width_(static_cast<std::size_t>(tile.rect.width())),
        carotene_(recipe.carotene.area, frame),
        stubble_(recipe.stubble.areas, frame),
        warpX_(warpNoise(recipe.warp), noiseKey(seed, kWarpX), frame, tile.rect),
        warpY_(warpNoise(recipe.warp), noiseKey(seed, kWarpY), frame, tile.rect),
        blotches_(kBlotchNoise, noiseKey(seed, kBlotches), frame, tile.rect),
        furrows_(furrowNoise(recipe.furrows.size), noiseKey(seed, kFurrows), frame, tile.rect) {
    for (const SkinTone& tone : recipe.tones)
      tones_.emplace_back(tone, frame);
    for (const FlushRecipe& flush : recipe.flushes)
      flushes_.emplace_back(flush.area, frame);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      noises_.emplace_back(recipe.noise[k], noiseKey(seed, kParameterNoise + k), frame, tile.rect);
    }
    for (std::vector<float>* row : {&x_, &y_, &noise_})
      row->resize(width_);
  }

  void paint(int y) {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      values_[k] = tile_.values[k].data() + tile_.index(tile_.rect.x0, y);
    }
    stray(y);
    blendTones();
    addNoise(y);
    addFurrows(y);
    addFlush(y);
    addCarotene();
    addShade();
  }

 private:
  // Pixel centres, moved by the warp.
  void stray(int y) {
    warpX_.row(y, x_.data());
    warpY_.row(y, y_.data());
    for (std::size_t i = 0; i < width_; ++i) {
      x_[i] = static_cast<float>(tile_.rect.x0) + static_cast<float>(i) + 0.5f + x_[i] * side_;
      y_[i] = static_cast<float>(y) + 0.5f + y_[i] * side_;
    }
  }

  void blendTones() {
    std::fill(noise_.begin(), noise_.end(), 0.0f);
    for (float* values : values_)
      std::fill(values, values + width_, 0.0f);
    for (const ToneShape& tone : tones_) {
      for (std::size_t i = 0; i < width_; ++i) {
        const float weight = tone.weight(x_[i], y_[i]);
        noise_[i] += weight;
        for (std::size_t k = 0; k < kParameterCount; ++k) {
          values_[k][i] += weight * tone.parameters[k];
        }
      }
    }
    for (float* values : values_) {
      for (std::size_t i = 0; i < width_; ++i)
        values[i] /= noise_[i];
    }
  }

  void addNoise(int y) {
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      noises_[k].row(y, noise_.data());
      for (std::size_t i = 0; i < width_; ++i)
        values_[k][i] += noise_[i];
      if (!isConcentration(k)) continue;
      for (std::size_t i = 0; i < width_; ++i)
        values_[k][i] = std::exp(values_[k][i]);
    }
  }

  // Along the zeros of a noise.
  void addFurrows(int y) {
    const auto melanin = static_cast<float>(recipe_.furrows.melanin);
    const auto epidermal = static_cast<float>(recipe_.furrows.epidermal);
    furrows_.row(y, noise_.data());
    for (std::size_t i = 0; i < width_; ++i) {
      const float near = std::max(0.0f, 1.0f - 3.0f * std::abs(noise_[i]));
      values_[kMelanin][i] *= 1.0f + near * melanin;
      values_[kHaemoglobinEpidermal][i] *= 1.0f + near * epidermal;
    }
  }

  void addFlush(int y) {
    if (flushes_.empty()) return;
    blotches_.row(y, noise_.data());
    for (std::size_t k = 0; k < flushes_.size(); ++k) {
      const auto dermal = static_cast<float>(recipe_.flushes[k].dermal);
      const auto epidermal = static_cast<float>(recipe_.flushes[k].epidermal);
      const auto unevenness = static_cast<float>(recipe_.flushes[k].blotches);
      for (std::size_t i = 0; i < width_; ++i) {
        const float weight =
            flushes_[k].weight(x_[i], y_[i]) * std::max(0.0f, 1.0f + unevenness * noise_[i]);
        values_[kHaemoglobinDermal][i] += weight * dermal;
        values_[kHaemoglobinEpidermal][i] += weight * epidermal;
      }
    }
  }

  void addCarotene() {
    const auto carotene = static_cast<float>(recipe_.carotene.carotene);
    for (std::size_t i = 0; i < width_; ++i) {
      values_[kCarotene][i] += carotene_.weight(x_[i], y_[i]) * carotene;
    }
  }

  // The shade of hairs below the surface.
  void addShade() {
    const auto shade = static_cast<float>(recipe_.stubble.shade);
    const auto blend = static_cast<float>(recipe_.stubble.blend);
    for (std::size_t i = 0; i < width_; ++i) {
      const float added = stubble_.weight(x_[i], y_[i]) * shade;
      const float melanin = values_[kMelanin][i] + added;
      values_[kMelaninBlend][i] = mix(values_[kMelaninBlend][i], blend, added / melanin);
      values_[kMelanin][i] = melanin;
    }
  }

  const SkinRecipe& recipe_;
  const float side_;
  PatchTile& tile_;
  const std::size_t width_;
  std::vector<ToneShape> tones_;
  std::vector<AreaShape> flushes_;
  AreaShape carotene_;
  AreaShapes stubble_;
  FractalRows warpX_, warpY_, blotches_, furrows_;
  std::vector<FractalRows> noises_;
  // Working memory for the current row.
  std::vector<float> x_, y_, noise_;
  std::array<float*, kParameterCount> values_ = {};
};

}  // namespace

void paintComplexion(const SkinRecipe& recipe, const PatchFrame& frame, std::uint64_t seed,
                     PatchTile& tile) {
  RowPainter painter(recipe, frame, seed, tile);
  for (int y = tile.rect.y0; y < tile.rect.y1; ++y)
    painter.paint(y);
}

}  // namespace cutis
