#include "src/color/ocio_config.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>

#include <Eigen/Core>
#include <OpenColorIO/OpenColorIO.h>

#include "core/base/echoed_text.h"
#include "core/spectra/rgb_primaries.h"
#include "src/color/ocio_cycles.h"

namespace cutis {

namespace fs = std::filesystem;
namespace ocio = OCIO_NAMESPACE;

namespace {

constexpr std::uintmax_t kLargestConfigBytes = std::uintmax_t{64} << 20;
constexpr char kSceneLinear[] = "linear Rec.709 of a scene";
constexpr char kDisplayLinear[] = "linear Rec.709 of a display";

// What configurations without interchange roles call linear Rec.709.
constexpr std::array<const char*, 7> kLinearRec709Names = {"lin_rec709",
                                                           "lin_rec709_scene",
                                                           "lin_srgb",
                                                           "Linear Rec.709 (sRGB)",
                                                           "Utility - Linear - Rec.709",
                                                           "Utility - Linear - sRGB",
                                                           "Linear Rec.709"};

// Exact arithmetic; tables are inverted at their own resolution.
constexpr auto kQuality = static_cast<ocio::OptimizationFlags>(
    ocio::OPTIMIZATION_LOSSLESS | ocio::OPTIMIZATION_LUT_INV_FAST | ocio::OPTIMIZATION_COMP_LUT1D);

std::string oneLine(const char* text) {
  std::string line = text;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line.substr(0, 200);
}

void setMatrix(const Eigen::Matrix3d& matrix, ocio::MatrixTransform& transform) {
  double m44[16] = {};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      m44[4 * row + column] = matrix(row, column);
  }
  m44[15] = 1.0;
  transform.setMatrix(m44);
}

// A space whose numbers are linear Rec.709, tied to the reference by a matrix.
ocio::ColorSpaceRcPtr linearSpace(const char* name, ocio::ReferenceSpaceType reference,
                                  const Eigen::Matrix3d& toReference) {
  auto transform = ocio::MatrixTransform::Create();
  setMatrix(toReference, *transform);
  auto space = ocio::ColorSpace::Create(reference);
  space->setName(name);
  space->setTransform(transform, ocio::COLORSPACE_DIR_TO_REFERENCE);
  return space;
}

// Ties another configuration to our numbers: linear Rec.709 as a space of scenes, by ACES2065-1,
// and as a space of displays, by XYZ under D65.
ocio::ConstConfigRcPtr makeInterchange() {
  auto config = ocio::Config::Create();
  auto aces = ocio::ColorSpace::Create(ocio::REFERENCE_SPACE_SCENE);
  aces->setName("ACES2065-1");
  config->addColorSpace(aces);
  config->setRole(ocio::ROLE_INTERCHANGE_SCENE, "ACES2065-1");
  config->addColorSpace(
      linearSpace(kSceneLinear, ocio::REFERENCE_SPACE_SCENE, rgbFromRgb(kAces2065, kRec709)));
  auto xyz = ocio::ColorSpace::Create(ocio::REFERENCE_SPACE_DISPLAY);
  xyz->setName("CIE-XYZ-D65");
  config->addColorSpace(xyz);
  config->setRole(ocio::ROLE_INTERCHANGE_DISPLAY, "CIE-XYZ-D65");
  config->addColorSpace(
      linearSpace(kDisplayLinear, ocio::REFERENCE_SPACE_DISPLAY, xyzFromRgb(kRec709)));
  return config;
}

ColorConverter converterOf(const ocio::ConstProcessorRcPtr& processor) {
  const ocio::ConstCPUProcessorRcPtr cpu = processor->getOptimizedCPUProcessor(kQuality);
  return [cpu](std::span<float> rgb) -> Status {
    try {
      ocio::PackedImageDesc pixels(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
      cpu->apply(pixels);
      return {};
    } catch (const std::exception& error) {
      return inputError("$OCIO", "the colour conversion failed (" + oneLine(error.what()) +
                                     "); correct the configuration or unset $OCIO");
    }
  };
}

Status checkFile(const std::string& path) {
  std::error_code error;
  const std::string place = "$OCIO";
  if (!fs::exists(path, error)) {
    return inputError(place, "there is no file " + inQuotes(path) + "; correct or unset $OCIO");
  }
  if (!fs::is_regular_file(path, error)) {
    return inputError(place, inQuotes(path) + " is not a file; name a config.ocio or unset $OCIO");
  }
  if (fs::file_size(path, error) > kLargestConfigBytes) {
    return inputError(place, inQuotes(path) +
                                 " is larger than 64 MiB and cannot be a configuration; "
                                 "correct or unset $OCIO");
  }
  return {};
}

}  // namespace

struct OcioConfig::Impl {
  ocio::ConstConfigRcPtr config;
  ocio::ConstConfigRcPtr interchange;

  ocio::ConstProcessorRcPtr processor(const std::string& name, bool toLinear) const {
    if (refersToItself(*config, name)) throw ocio::Exception("its definition leads back to itself");
    const bool display = config->getColorSpace(name.c_str())->getReferenceSpaceType() ==
                         ocio::REFERENCE_SPACE_DISPLAY;
    if (config->hasRole(display ? ocio::ROLE_INTERCHANGE_DISPLAY : ocio::ROLE_INTERCHANGE_SCENE)) {
      const char* linear = display ? kDisplayLinear : kSceneLinear;
      return toLinear
                 ? ocio::Config::GetProcessorFromConfigs(config, name.c_str(), interchange, linear)
                 : ocio::Config::GetProcessorFromConfigs(interchange, linear, config, name.c_str());
    }
    for (const char* linear : kLinearRec709Names) {
      if (!config->getColorSpace(linear)) continue;
      return toLinear ? config->getProcessor(name.c_str(), linear)
                      : config->getProcessor(linear, name.c_str());
    }
    throw ocio::Exception("it has neither the role aces_interchange nor a space lin_rec709");
  }

  Result<ColorConverter> converter(const std::string& name, bool toLinear,
                                   const std::string& place) const try {
    return converterOf(processor(name, toLinear));
  } catch (const std::exception& error) {
    return inputError(place, "the configuration of $OCIO cannot convert " + inQuotes(name) + " (" +
                                 oneLine(error.what()) +
                                 "); correct it, unset $OCIO or use another colour space");
  }
};

Result<std::shared_ptr<const OcioConfig>> OcioConfig::fromEnvironment() {
  static std::mutex mutex;
  static std::string loadedPath;
  static std::shared_ptr<const OcioConfig> loaded;

  const char* variable = std::getenv("OCIO");
  if (variable == nullptr || *variable == '\0') return std::shared_ptr<const OcioConfig>();
  const std::string path = variable;
  const std::scoped_lock lock(mutex);
  if (loaded && loadedPath == path) return loaded;
  CUTIS_CHECK(checkFile(path));
  try {
    // Its warnings would go to stderr, where only our own sentences belong.
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    auto impl = std::make_shared<Impl>();
    impl->config = ocio::Config::CreateFromFile(path.c_str());
    impl->interchange = makeInterchange();
    loaded = std::shared_ptr<const OcioConfig>(new OcioConfig(std::move(impl)));
    loadedPath = path;
    return loaded;
  } catch (const std::exception& error) {
    return inputError("$OCIO", inQuotes(path) + " is not a configuration that OpenColorIO reads (" +
                                   oneLine(error.what()) + "); correct or unset $OCIO");
  }
}

bool OcioConfig::has(const std::string& name) const {
  return impl_->config->getColorSpace(name.c_str()) != nullptr;
}

std::string OcioConfig::canonicalName(const std::string& name) const {
  const auto space = impl_->config->getColorSpace(name.c_str());
  return space ? space->getName() : name;
}

std::vector<std::string> OcioConfig::names() const {
  std::vector<std::string> names;
  for (int i = 0; i < impl_->config->getNumColorSpaces(); ++i) {
    names.emplace_back(impl_->config->getColorSpaceNameByIndex(i));
  }
  return names;
}

Result<ColorConverter> OcioConfig::toLinearRec709(const std::string& name,
                                                  const std::string& place) const {
  return impl_->converter(name, true, place);
}

Result<ColorConverter> OcioConfig::fromLinearRec709(const std::string& name,
                                                    const std::string& place) const {
  return impl_->converter(name, false, place);
}

}  // namespace cutis
