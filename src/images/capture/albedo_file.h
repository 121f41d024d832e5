#pragma once

// Albedo textures: a colour image taken as skin seen by a colour-matching observer under one light.
//
// RGB → linear Rec.709 → tristimulus values under the white of the rig's light → divided by that
// white, so that each channel of the rig reads 1 for a perfect diffuser, and neutral texels read
// the same in all three. Colours outside the spectral gamut (negative X, Y or Z) are invalid,
// texels with alpha 0 are masked (gutters between UDIM islands), texels with a channel at the end
// of an integer range are saturated. Colours that are stored multiplied by alpha are divided by it
// first. What an OpenEXR file stores around its display window is part of the texture.

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "src/images/image_file.h"

namespace cutis {

// Converts interleaved R, G, B in place; called from many threads at once.
using RgbConversion = std::function<Status(std::span<float> rgb)>;
// The conversion from a colour space of this name to linear Rec.709 (src/color: toLinearRec709);
// `place` stands in front of an error about the name.
using RgbConversionLookup =
    std::function<Result<RgbConversion>(const std::string& name, const std::string& place)>;

struct AlbedoOptions {
  // Empty: what the file says, else sRGB for integers and linear Rec.709 for floats.
  std::string colorSpace = {};
  std::filesystem::path mask = {};  // may be empty
  std::string layer = {};           // of an OpenEXR file, see src/images/image_layers.h
};

struct Albedo {
  Measurements measurements;
  // All channels of the file, untouched, for what is written later.
  Image source;
  std::string colorSpace;  // the name that was used
};

// `rig` has an observer as its camera and one light.
Result<Albedo> readAlbedo(const std::filesystem::path& path, const AlbedoOptions& options,
                          const RgbConversionLookup& toLinearRec709, const Rig& rig,
                          const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
