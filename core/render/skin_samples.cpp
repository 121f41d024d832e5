#include "core/render/skin_samples.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace cutis {
namespace {

// Below this a ratio of two models says nothing; far below the darkest skin in any channel.
constexpr float kSmallestAlbedo = 1e-4f;

// What is edited at a time for a draft: small enough to stay in a core's cache.
constexpr int kStripSamples = 4096;

PictureBuffer emptyPicture(const SkinSamples& samples) {
  PictureBuffer picture;
  picture.width = samples.width();
  picture.height = samples.height();
  return picture;
}

Result<ParameterBuffer> edited(const SkinSamples& samples, const EditStack& edits,
                               const ParameterAxes& axes) {
  ParameterBuffer parameters = *samples.parameters;
  CUTIS_CHECK(applyEdits(edits, axes, samples.rect, samples.step, parameters));
  return parameters;
}

// What a response model or its table makes of the parameters.
template <typename Response>
std::vector<std::vector<float>> evaluated(const ParameterBuffer& parameters,
                                          const Response& response) {
  std::vector<std::vector<float>> channels(static_cast<std::size_t>(response.rowCount()),
                                           std::vector<float>(parameters.count()));
  std::vector<float*> rows;
  for (std::vector<float>& channel : channels)
    rows.push_back(channel.data());
  response.evaluate(parameters.batch(), rows);
  for (std::size_t i = 0; i < parameters.count(); ++i) {
    if (parameters.present[i]) continue;
    for (std::vector<float>& channel : channels)
      channel[i] = 0.0f;
  }
  return channels;
}

// The parameters that edits change, of some rows of samples.
ParameterBuffer partOf(const SkinSamples& samples, std::size_t first, std::size_t count) {
  ParameterBuffer part;
  part.values = PixelBuffer<float>(kParameterCount, count);
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    const auto row = samples.parameters->values[k].subspan(first, count);
    std::copy(row.begin(), row.end(), part.values[k].begin());
  }
  const auto present = samples.parameters->present.begin() + static_cast<std::ptrdiff_t>(first);
  part.present.assign(present, present + static_cast<std::ptrdiff_t>(count));
  return part;
}

// Multiplies a strip of a channel by after / before where there is skin.
void multiplyByRatio(const std::vector<bool>& present, std::span<const float> before,
                     std::span<const float> after, std::span<float> pixels) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!present[i]) continue;
    pixels[i] *= std::max(after[i], kSmallestAlbedo) / std::max(before[i], kSmallestAlbedo);
  }
}

// Calls take(from) for every n-th sample of every n-th row of a picture.
template <typename Take>
void forEvery(int width, int height, int n, Take take) {
  for (int y = 0; y < height; y += n) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int x = 0; x < width; x += n)
      take(row + static_cast<std::size_t>(x));
  }
}

std::size_t countOfEvery(int width, int height, int n) {
  return static_cast<std::size_t>((width + n - 1) / n) *
         static_cast<std::size_t>((height + n - 1) / n);
}

template <typename Values>
std::vector<float> thinnedRow(const Values& values, int width, int height, int n) {
  std::vector<float> kept;
  kept.reserve(countOfEvery(width, height, n));
  forEvery(width, height, n, [&](std::size_t from) { kept.push_back(values[from]); });
  return kept;
}

std::vector<bool> thinnedStates(const std::vector<bool>& present, int width, int height, int n) {
  std::vector<bool> kept;
  kept.reserve(countOfEvery(width, height, n));
  forEvery(width, height, n, [&](std::size_t from) { kept.push_back(present[from]); });
  return kept;
}

}  // namespace

Result<SkinSamples> loadSamples(const EditedSkin& skin, const Rect& rect, int step) {
  SkinSamples samples;
  samples.rect = rect;
  samples.step = step;
  CUTIS_TRY(parameters, loadParameters(skin.maps, rect, step));
  samples.parameters = std::make_shared<const ParameterBuffer>(std::move(parameters));
  return samples;
}

std::vector<std::vector<float>> responseTo(const ParameterBuffer& parameters,
                                           const ResponseModel& response) {
  return evaluated(parameters, response);
}

std::vector<std::vector<float>> responseTo(const ParameterBuffer& parameters,
                                           const ResponseTable& table) {
  return evaluated(parameters, table);
}

SkinSamples thinned(const SkinSamples& samples, int n) {
  const int width = samples.width();
  const int height = samples.height();
  SkinSamples kept;
  kept.rect = samples.rect;
  kept.step = samples.step * n;
  const PixelBuffer<float>& values = samples.parameters->values;
  ParameterBuffer parameters;
  parameters.values = PixelBuffer<float>(values.rowCount(), countOfEvery(width, height, n));
  for (std::size_t k = 0; k < values.rowCount(); ++k) {
    const std::vector<float> row = thinnedRow(values[k], width, height, n);
    std::copy(row.begin(), row.end(), parameters.values[k].begin());
  }
  parameters.present = thinnedStates(samples.parameters->present, width, height, n);
  kept.parameters = std::make_shared<const ParameterBuffer>(std::move(parameters));
  for (const std::vector<float>& channel : samples.original)
    kept.original.push_back(thinnedRow(channel, width, height, n));
  for (const std::vector<float>& channel : samples.tabulated)
    kept.tabulated.push_back(thinnedRow(channel, width, height, n));
  return kept;
}

PictureBuffer thinned(const PictureBuffer& picture, int n) {
  PictureBuffer kept;
  kept.width = (picture.width + n - 1) / n;
  kept.height = (picture.height + n - 1) / n;
  for (const std::vector<float>& channel : picture.channels)
    kept.channels.push_back(thinnedRow(channel, picture.width, picture.height, n));
  kept.present = thinnedStates(picture.present, picture.width, picture.height, n);
  return kept;
}

Result<PictureBuffer> renderSamples(const SkinSamples& samples, const EditStack& edits,
                                    const ParameterAxes& axes, const ResponseModel& response) {
  PictureBuffer picture = emptyPicture(samples);
  if (isNeutral(edits) && !samples.original.empty()) {
    picture.channels = samples.original;
    picture.present = samples.parameters->present;
    return picture;
  }
  CUTIS_TRY(parameters, edited(samples, edits, axes));
  picture.channels = responseTo(parameters, response);
  picture.present = std::move(parameters.present);
  return picture;
}

Result<PictureBuffer> mapSamples(const SkinSamples& samples, const EditStack& edits,
                                 const ParameterAxes& axes, Parameter parameter) {
  ParameterBuffer parameters = partOf(samples, 0, samples.parameters->count());
  CUTIS_CHECK(applyEdits(edits, axes, samples.rect, samples.step, parameters));
  PictureBuffer picture = emptyPicture(samples);
  const std::span<const float> values = parameters.values[static_cast<std::size_t>(parameter)];
  picture.channels.emplace_back(values.begin(), values.end());
  picture.present = std::move(parameters.present);
  return picture;
}

Result<PictureBuffer> editAlbedoSamples(PictureBuffer source, const SkinSamples& samples,
                                        const EditStack& edits, const ParameterAxes& axes,
                                        const ResponseModel& albedo, bool pure) {
  if (!pure && isNeutral(edits)) return source;
  CUTIS_TRY(parameters, edited(samples, edits, axes));
  const std::vector<std::vector<float>> changed = responseTo(parameters, albedo);
  for (std::size_t k = 0; k < source.channels.size(); ++k) {
    std::vector<float>& pixels = source.channels[k];
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (!parameters.present[i]) continue;
      const float before = std::max(samples.original[k][i], kSmallestAlbedo);
      const float after = std::max(changed[k][i], kSmallestAlbedo);
      if (pure) {
        pixels[i] = changed[k][i];
      } else if (after != before) {
        pixels[i] *= after / before;
      }
    }
  }
  return source;
}

Result<PictureBuffer> draftSamples(PictureBuffer unedited, const SkinSamples& samples,
                                   const EditStack& edits, const ParameterAxes& axes,
                                   const ResponseTable& table) {
  if (isNeutral(edits)) return unedited;
  PictureBuffer& picture = unedited;
  const auto width = static_cast<std::size_t>(picture.width);
  const int stripRows = std::max(1, kStripSamples / std::max(1, picture.width));
  for (int y = 0; y < picture.height; y += stripRows) {
    const int rows = std::min(stripRows, picture.height - y);
    const std::size_t first = static_cast<std::size_t>(y) * width;
    ParameterBuffer part = partOf(samples, first, static_cast<std::size_t>(rows) * width);
    const int top = samples.rect.y0 + y * samples.step;
    const Rect rect = {samples.rect.x0, top, samples.rect.x1,
                       std::min(top + rows * samples.step, samples.rect.y1)};
    CUTIS_CHECK(applyEdits(edits, axes, rect, samples.step, part));
    const std::vector<std::vector<float>> after = evaluated(part, table);
    for (std::size_t c = 0; c < picture.channels.size(); ++c) {
      multiplyByRatio(part.present, std::span(samples.tabulated[c]).subspan(first, part.count()),
                      after[c], std::span(picture.channels[c]).subspan(first, part.count()));
    }
  }
  return unedited;
}

}  // namespace cutis
