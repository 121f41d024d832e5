#include "core/simulate/photograph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/simulate/backdrop.h"
#include "core/simulate/channel_model.h"
#include "core/simulate/counter_normal.h"
#include "core/simulate/paint/gradient_noise.h"
#include "core/skin/parameter_buffer.h"
#include "core/skin/pixel_state.h"

namespace cutis {
namespace {

constexpr std::uint64_t kNoiseStream = 800;
// Pixels evaluated at once: their reflectances stay in the cache.
constexpr std::size_t kBatch = 512;

// What is photographed, and how.
struct Sitting {
  const ChromophoreMaps& maps;
  const ChannelModel model;
  const Backdrop backdrop;
  const double proportionalNoise;
  const std::uint64_t seed;
};

// Channels of one tile, a row each.
class TileExposure {
 public:
  TileExposure(const Sitting& sitting, const Rect& rect)
      : sitting_(sitting),
        rect_(rect),
        channels_(sitting.model.channelCount(), rect.pixelCount()) {}

  Status run(Measurements& photographs) {
    CUTIS_TRY(skin, loadParameters(sitting_.maps, rect_));
    exposeSkin(skin);
    exposeBackdrop(skin.present);
    addNoise();
    for (std::size_t k = 0; k < channels_.rowCount(); ++k) {
      CUTIS_CHECK(photographs.channels[k].store(rect_, channels_[k]));
    }
    return photographs.state.store(rect_, states(skin.present));
  }

 private:
  void exposeSkin(const ParameterBuffer& skin) {
    std::vector<float> reflectance;
    for (std::size_t begin = 0; begin < skin.count(); begin += kBatch) {
      const std::size_t count = std::min(kBatch, skin.count() - begin);
      const auto first = skin.present.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = first + static_cast<std::ptrdiff_t>(count);
      if (std::find(first, last, true) == last) continue;
      sitting_.model.evaluate(skin.batch().part(begin, count), reflectance,
                              channels_.rows().part(begin, count));
    }
  }

  void exposeBackdrop(const std::vector<bool>& present) {
    if (std::find(present.begin(), present.end(), false) == present.end()) return;
    const std::vector<float> level = sitting_.backdrop.level(rect_);
    for (std::size_t k = 0; k < channels_.rowCount(); ++k) {
      const float reading = sitting_.backdrop.channel(k);
      for (std::size_t i = 0; i < level.size(); ++i) {
        if (!present[i]) channels_[k][i] = reading * level[i];
      }
    }
  }

  void addNoise() {
    const auto deviation = static_cast<float>(sitting_.proportionalNoise);
    const auto pictureWidth = static_cast<std::uint64_t>(sitting_.maps.width());
    for (std::size_t k = 0; k < channels_.rowCount(); ++k) {
      const std::uint64_t key = noiseKey(sitting_.seed, kNoiseStream + k);
      float* value = channels_[k].data();
      for (int y = rect_.y0; y < rect_.y1; ++y) {
        const std::uint64_t pixel =
            static_cast<std::uint64_t>(y) * pictureWidth + static_cast<std::uint64_t>(rect_.x0);
        for (int x = 0; x < rect_.width(); ++x, ++value) {
          const float factor =
              deviation > 0.0f
                  ? 1.0f + deviation * normalAt(key, pixel + static_cast<std::uint64_t>(x))
                  : 1.0f;
          *value = std::max(0.0f, *value * factor);
        }
      }
    }
  }

  static std::vector<float> states(const std::vector<bool>& present) {
    std::vector<float> states;
    states.reserve(present.size());
    for (const bool skin : present) {
      states.push_back(storedState(skin ? PixelState::solved : PixelState::masked));
    }
    return states;
  }

  const Sitting& sitting_;
  const Rect rect_;
  PixelBuffer<float> channels_;
};

}  // namespace

Result<Measurements> photograph(const ChromophoreMaps& maps, const SkinModel& model, const Rig& rig,
                                double proportionalNoise, std::uint64_t seed,
                                const JobContext& context) {
  if (!(proportionalNoise >= 0.0) || !std::isfinite(proportionalNoise)) {
    return usageError("", "the noise must be a standard deviation from 0, such as 0.005");
  }
  CUTIS_TRY(channels, ChannelModel::create(model, rig, maps.perPixel(), context.child(0.0, 0.2)));
  const Sitting sitting = {maps, std::move(channels),
                           Backdrop(rig, maps.width(), maps.height(), seed), proportionalNoise,
                           seed};
  Measurements photographs;
  photographs.rig = rig;
  photographs.isSimulated = maps.coefficients.empty();
  photographs.state = Plane(maps.width(), maps.height(), PixelFormat::half);
  for (int k = 0; k < rig.channelCount(); ++k) {
    photographs.channels.emplace_back(maps.width(), maps.height());
  }
  CUTIS_CHECK(parallelFor(static_cast<std::size_t>(photographs.state.tileCount()),
                          context.child(0.2, 1.0), [&](std::size_t i) {
                            const Rect rect = photographs.state.tileRect(static_cast<int>(i));
                            return TileExposure(sitting, rect).run(photographs);
                          }));
  return photographs;
}

}  // namespace cutis
