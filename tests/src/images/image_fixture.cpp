#include "tests/src/images/image_fixture.h"

#include <algorithm>
#include <cmath>

namespace cutis::test {

namespace fs = std::filesystem;

fs::path ImageFolder::path(const std::string& name) const {
  return root() / name;
}

std::vector<std::string> ImageFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(root())) {
    names.push_back(fs::relative(entry.path(), root()).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Plane makePlane(int width, int height, const std::function<float(int x, int y)>& value,
                PixelFormat format) {
  Plane plane(width, height, format);
  std::vector<float> values;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      values.push_back(value(x, y));
  }
  if (!plane.store(plane.bounds(), values)) fail("cannot store");
  return plane;
}

std::vector<float> valuesOf(const Plane& plane) {
  std::vector<float> values(plane.bounds().pixelCount());
  if (!plane.load(plane.bounds(), values)) fail("cannot load");
  return values;
}

float pixelOf(const Plane& plane, int x, int y) {
  float value = 0.0f;
  if (!plane.load({x, y, x + 1, y + 1}, std::span(&value, 1))) fail("cannot load");
  return value;
}

ImageContent makeContent(int width, int height, const std::vector<std::string>& channels,
                         unsigned seed) {
  ImageContent content;
  content.channelNames = channels;
  unsigned state = seed;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    content.channels.push_back(makePlane(width, height, [&](int x, int y) {
      const float wave = std::sin(0.05f * static_cast<float>(x) + static_cast<float>(c)) *
                         std::cos(0.03f * static_cast<float>(y));
      return 0.5f + 0.3f * wave + 0.2f * (random01(state) - 0.5f);
    }));
  }
  return content;
}

JobContext Listener::context() {
  JobContext context;
  context.notice = [this](const std::string& sentence) { sentences.push_back(sentence); };
  return context;
}

JobContext Stopper::context() {
  JobContext context;
  context.stop = source.get_token();
  context.progress = Progress([this](double, const std::string&) { source.request_stop(); });
  return context;
}

}  // namespace cutis::test
