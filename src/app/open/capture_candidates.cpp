#include "src/app/open/capture_candidates.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "src/images/image_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr int kThumbnailSide = 128;
constexpr std::size_t kMemoryForPhotograph = std::size_t{1} << 30;
// Correlation of log luminance. The same face under two lights has more, two faces have less.
constexpr double kOneScene = 0.8;
// Shadows and noise say nothing.
constexpr double kLeastLight = 1e-3;
constexpr float kWhite = 1.0f;

Result<std::array<std::size_t, 3>> colorChannels(const ImageHeader& header) {
  if (!header.layer.colors) {
    return inputError(header.file.string(),
                      "it has no red, green and blue; choose colour photographs");
  }
  if (header.isLayerOpen()) {
    return inputError(header.file.string(),
                      "it has several layers with colours and no plain channels R, G and B; choose "
                      "photographs of one layer");
  }
  std::array<std::size_t, 3> channels = {};
  for (std::size_t c = 0; c < 3; ++c)
    channels[c] = static_cast<std::size_t>((*header.layer.colors)[c]);
  return channels;
}

Result<PhotographThumbnail> thumbnailOf(const Image& image,
                                        const std::array<std::size_t, 3>& channels) {
  const int step = std::max(1, (std::max(image.width, image.height) - 1) / kThumbnailSide + 1);
  PhotographThumbnail thumbnail;
  thumbnail.width = (image.width - 1) / step + 1;
  thumbnail.height = (image.height - 1) / step + 1;
  const auto columns = static_cast<std::size_t>(thumbnail.width);
  thumbnail.rgb.resize(3 * columns * static_cast<std::size_t>(thumbnail.height));
  std::vector<float> row(static_cast<std::size_t>(image.width));
  for (int y = 0; y < thumbnail.height; ++y) {
    for (std::size_t c = 0; c < 3; ++c) {
      CUTIS_CHECK(image.channels[channels[c]].load({0, y * step, image.width, y * step + 1}, row));
      for (std::size_t x = 0; x < columns; ++x) {
        thumbnail.rgb[3 * (static_cast<std::size_t>(y) * columns + x) + c] =
            row[x * static_cast<std::size_t>(step)];
      }
    }
  }
  return thumbnail;
}

double shareOfWhite(const PhotographThumbnail& thumbnail) {
  std::size_t white = 0;
  for (std::size_t k = 0; k < thumbnail.rgb.size(); k += 3) {
    if (*std::max_element(&thumbnail.rgb[k], &thumbnail.rgb[k] + 3) >= kWhite) ++white;
  }
  return 3.0 * static_cast<double>(white) / static_cast<double>(thumbnail.rgb.size());
}

// What captures call the numbers of a photograph. Without any statement 8 bits are taken as a
// camera's finished picture and more of them as its linear data.
std::string encodingOf(const ImageHeader& header) {
  const auto decided = decideColors(header.colors, {}, header.file.string());
  if (!decided) return "raw";
  const ColorStatement& followed = decided.value().followed;
  const bool isSilent = followed.source == ColorSource::formatDefault;
  if (followed.space.isLinear() || (isSilent && header.sourceType != SampleType::uint8)) {
    return "linear";
  }
  return followed.space.isNamed && followed.space.matrix ? followed.space.name : "raw";
}

// Linear where the encoding names no space.
std::array<TransferCurve, 3> curvesOf(const std::string& encoding) {
  const auto space = namedColorSpace(encoding, {});
  return space && space.value().matrix ? space.value().matrix->curves
                                       : std::array<TransferCurve, 3>();
}

Eigen::Vector3d meanLight(const PhotographThumbnail& thumbnail, const std::string& encoding) {
  const std::array<TransferCurve, 3> curves = curvesOf(encoding);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < thumbnail.rgb.size(); ++k) {
    const float number = thumbnail.rgb[k];
    if (number >= 0.0f && number <= kWhite) {
      sum[static_cast<Eigen::Index>(k % 3)] += curves[k % 3].toLight(double{number});
    }
  }
  return sum;
}

std::vector<double> logLuminance(const PhotographThumbnail& thumbnail) {
  std::vector<double> values;
  for (std::size_t k = 0; k < thumbnail.rgb.size(); k += 3) {
    const double sum =
        double{thumbnail.rgb[k]} + double{thumbnail.rgb[k + 1]} + double{thumbnail.rgb[k + 2]};
    values.push_back(std::log(std::isfinite(sum) ? std::max(sum, kLeastLight) : kLeastLight));
  }
  return values;
}

// Precondition: as many of both.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto count = static_cast<double>(a.size());
  double meanA = 0.0, meanB = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    meanA += a[k] / count;
    meanB += b[k] / count;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    aa += (a[k] - meanA) * (a[k] - meanA);
    bb += (b[k] - meanB) * (b[k] - meanB);
    ab += (a[k] - meanA) * (b[k] - meanB);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

bool areOfOneScene(const std::vector<CandidatePhotograph>& photographs) {
  const CandidatePhotograph& first = photographs.front();
  const std::vector<double> light = logLuminance(first.thumbnail);
  return photographs.size() > 1 &&
         std::all_of(photographs.begin() + 1, photographs.end(), [&](const auto& other) {
           return other.width == first.width && other.height == first.height &&
                  correlation(light, logLuminance(other.thumbnail)) >= kOneScene;
         });
}

Result<CandidatePhotograph> inspectPhotograph(const fs::path& file, const JobContext& context) {
  const auto store = std::make_shared<TileStore>(kMemoryForPhotograph);
  std::array<std::size_t, 3> channels = {};
  const auto accept = [&](const ImageHeader& header) -> Status {
    CUTIS_TRY(found, colorChannels(header));
    channels = found;
    return {};
  };
  CUTIS_TRY(image, readImage(file, {{}, accept}, store, context));
  CandidatePhotograph photograph;
  photograph.path = file;
  photograph.width = image.width;
  photograph.height = image.height;
  photograph.encoding = encodingOf(image);
  CUTIS_TRY(thumbnail, thumbnailOf(image, channels));
  photograph.thumbnail = std::move(thumbnail);
  if (isInteger(image.sourceType)) photograph.saturatedShare = shareOfWhite(photograph.thumbnail);
  photograph.clues = {file.stem().string(), meanLight(photograph.thumbnail, photograph.encoding)};
  return photograph;
}

// "skin.1001" → "skin.####"; the same text where there is no such number.
std::string withoutNumber(const std::string& stem) {
  constexpr std::size_t kFewestDigits = 4;
  std::size_t end = stem.size();
  while (end > 0) {
    std::size_t begin = end;
    while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1])) != 0)
      --begin;
    if (end - begin >= kFewestDigits) return stem.substr(0, begin) + "####" + stem.substr(end);
    end = begin == end ? end - 1 : begin;
  }
  return stem;
}

}  // namespace

Result<CaptureCandidates> inspectPhotographs(const std::vector<fs::path>& files,
                                             const JobContext& context) {
  CaptureCandidates candidates;
  const auto count = static_cast<double>(files.size());
  for (const fs::path& file : files) {
    const auto done = static_cast<double>(candidates.photographs.size());
    CUTIS_TRY(photograph,
              inspectPhotograph(file, context.child(done / count, (done + 1.0) / count)));
    candidates.photographs.push_back(std::move(photograph));
  }
  candidates.colorSpaces = colorSpaceNames();
  candidates.areOfOneScene = !files.empty() && areOfOneScene(candidates.photographs);
  return candidates;
}

std::vector<std::uint8_t> screenBytes(const PhotographThumbnail& thumbnail,
                                      const std::string& encoding) {
  const std::array<TransferCurve, 3> curves = curvesOf(encoding);
  const TransferCurve& screen = builtInColorSpace("sRGB").matrix->curves[0];
  std::vector<std::uint8_t> bytes;
  bytes.reserve(thumbnail.rgb.size());
  for (std::size_t k = 0; k < thumbnail.rgb.size(); ++k) {
    const float number = thumbnail.rgb[k];
    const double light = number > 0.0f ? curves[k % 3].toLight(double{number}) : 0.0;
    bytes.push_back(static_cast<std::uint8_t>(
        std::lround(255.0 * screen.fromLight(std::clamp(light, 0.0, 1.0)))));
  }
  return bytes;
}

bool areTilesOrFrames(const std::vector<fs::path>& files) {
  if (files.size() < 2) return false;
  const fs::path& first = files.front();
  const std::string pattern = withoutNumber(first.stem().string());
  return pattern != first.stem().string() &&
         std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
           return withoutNumber(file.stem().string()) == pattern &&
                  file.extension() == first.extension();
         });
}

}  // namespace cutis
