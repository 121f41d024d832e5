#include "core/analyse/pixel_sample.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/spectra/colorimetry.h"

namespace cutis {
namespace {

int stepFor(int width, int height, std::size_t most) {
  const double pixels = static_cast<double>(width) * height;
  int step = std::max(1, static_cast<int>(std::sqrt(pixels / static_cast<double>(most))));
  const auto count = [&](int side) { return static_cast<std::size_t>((side + step - 1) / step); };
  while (count(width) * count(height) > most)
    ++step;
  return step;
}

// Rows of several planes, read together.
class Rows {
 public:
  explicit Rows(std::vector<Plane> planes) : planes_(std::move(planes)), rows_(planes_.size()) {}

  Status load(int y) {
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const int width = planes_[k].width();
      rows_[k].resize(static_cast<std::size_t>(width));
      CUTIS_CHECK(planes_[k].load({0, y, width, y + 1}, rows_[k]));
    }
    return {};
  }
  float at(std::size_t k, std::size_t x) const { return rows_[k][x]; }
  std::size_t count() const { return planes_.size(); }

 private:
  std::vector<Plane> planes_;
  std::vector<std::vector<float>> rows_;
};

// Pixel by pixel to row by row: [i][k] → [k][i].
PixelBuffer<float> transposed(const std::vector<float>& pixels, std::size_t rows) {
  PixelBuffer<float> result(rows, rows == 0 ? 0 : pixels.size() / rows);
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t i = 0; i < result.count(); ++i)
      result[k][i] = pixels[i * rows + k];
  }
  return result;
}

// exposure: a factor on the channels.
Result<PixelSample> sampleOf(const std::vector<Plane>& channelPlanes, float exposure,
                             const std::vector<Plane>& valuePlanes, const Plane& statePlane,
                             std::size_t most, const JobContext& context) {
  const int width = statePlane.width(), height = statePlane.height();
  const int step = stepFor(width, height, most);
  Rows channels(channelPlanes), parameters(valuePlanes), state({statePlane});
  PixelSample sample;
  std::vector<float> seen, known;
  for (int y = 0; y < height; y += step) {
    if (context.stopRequested()) return Cancelled{};
    CUTIS_CHECK(state.load(y));
    CUTIS_CHECK(channels.load(y));
    CUTIS_CHECK(parameters.load(y));
    for (int column = 0; column < width; column += step) {
      const auto x = static_cast<std::size_t>(column);
      if (!hasEstimate(pixelState(state.at(0, x)))) continue;
      ++sample.count;
      for (std::size_t k = 0; k < channels.count(); ++k)
        seen.push_back(channels.at(k, x) * exposure);
      for (std::size_t k = 0; k < parameters.count(); ++k)
        known.push_back(parameters.at(k, x));
    }
  }
  sample.channels = transposed(seen, channels.count());
  sample.values = transposed(known, parameters.count());
  return sample;
}

}  // namespace

Result<PixelSample> samplePixels(const Measurements& measurements, const ChromophoreMaps* maps,
                                 std::size_t most, const JobContext& context) {
  return sampleOf(measurements.channels, static_cast<float>(measurements.exposure),
                  maps == nullptr ? std::vector<Plane>() : maps->planes(),
                  maps == nullptr ? measurements.state : maps->state, most, context);
}

Result<PixelSample> sampleMaps(const ChromophoreMaps& maps, std::size_t most,
                               const JobContext& context) {
  return sampleOf({}, 1.0f, maps.planes(), maps.state, most, context);
}

std::vector<double> reconstructionDeltaE(const Rig& rig, const PixelSolver& solver,
                                         const PixelSample& sample) {
  const Eigen::Vector3d white = whitePoint(rig.lights.front().power, rig.camera.sensor);
  PixelBuffer<float> residuals(sample.channels.rowCount(), sample.count);
  solver.residuals(sample.channels.rows(), sample.values.rows(), residuals.rows());
  std::vector<double> differences(sample.count);
  for (std::size_t i = 0; i < sample.count; ++i) {
    Eigen::Vector3d measured, modelled;
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      measured[c] = double{sample.channels[k][i]} * white[c];
      modelled[c] = measured[c] - double{residuals[k][i]} * white[c];
    }
    differences[i] = deltaE2000(labFromXyz(measured, white), labFromXyz(modelled, white));
  }
  return differences;
}

bool seesColors(const Rig& rig) {
  return rig.camera.isObserver && rig.lights.size() == 1;
}

}  // namespace cutis
