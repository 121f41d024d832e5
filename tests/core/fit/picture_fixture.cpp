#include "tests/core/fit/picture_fixture.h"

#include "core/base/random.h"
#include "tests/support/models.h"

namespace cutis::test {

Measurements photograph(const Rig& rig, int width, int height,
                        const std::function<std::vector<float>(int, int)>& channels,
                        const std::function<PixelState(int, int)>& state) {
  Measurements picture;
  picture.rig = rig;
  picture.state = Plane(width, height, PixelFormat::half);
  const Rect all = picture.state.bounds();
  const auto channelCount = static_cast<std::size_t>(rig.channelCount());
  std::vector<std::vector<float>> values(channelCount, std::vector<float>(all.pixelCount()));
  std::vector<float> states(all.pixelCount());
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      const std::vector<float> pixel = channels(x, y);
      for (std::size_t k = 0; k < channelCount; ++k)
        values[k][i] = pixel[k];
      if (state) states[i] = storedState(state(x, y));
    }
  }
  for (const std::vector<float>& channel : values) {
    picture.channels.emplace_back(width, height);
    static_cast<void>(picture.channels.back().store(all, channel));
  }
  static_cast<void>(picture.state.store(all, states));
  return picture;
}

Measurements skinPhotograph(const Rig& rig, int width, int height) {
  const Eigen::VectorXd skin =
      responseRows(rig).matrix() * li2024().reflectance({0.04, 0.6, 0.02, 0.02, 0.001}).matrix();
  return photograph(rig, width, height, [&](int x, int y) {
    Random random(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
    std::vector<float> pixel;
    for (const double value : skin) {
      pixel.push_back(static_cast<float>(value * (1.0 + 0.01 * random.normal())));
    }
    return pixel;
  });
}

Measurements crop(const Measurements& picture, const Rect& part) {
  Measurements cropped;
  cropped.rig = picture.rig;
  const auto cut = [&](const Plane& plane) {
    Plane smaller(part.width(), part.height(), plane.format());
    static_cast<void>(smaller.store(smaller.bounds(), pixelsOf(plane, part)));
    return smaller;
  };
  for (const Plane& channel : picture.channels)
    cropped.channels.push_back(cut(channel));
  cropped.state = cut(picture.state);
  return cropped;
}

std::vector<float> pixelsOf(const Plane& plane, const Rect& rect) {
  std::vector<float> values(rect.pixelCount());
  static_cast<void>(plane.load(rect, values));
  return values;
}

std::vector<float> pixelsOf(const Plane& plane) {
  return pixelsOf(plane, plane.bounds());
}

std::vector<float> everything(const FitPlanes& planes, const Rect& rect) {
  std::vector<float> all;
  const auto add = [&](const Plane& plane) {
    const std::vector<float> values = pixelsOf(plane, rect);
    all.insert(all.end(), values.begin(), values.end());
  };
  for (const Plane& plane : planes.maps.values)
    add(plane);
  for (const Plane& plane : planes.deviations)
    add(plane);
  for (const Plane& plane : planes.residuals)
    add(plane);
  add(planes.maps.state);
  return all;
}

}  // namespace cutis::test
