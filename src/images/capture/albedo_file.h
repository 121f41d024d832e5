#pragma once

// Albedo textures: a colour image taken as skin seen by a colour-matching observer under one light.
//
// RGB → linear Rec.709 → tristimulus values under the white of the rig's light → divided by that
// white, so that each channel of the rig reads 1 for a perfect diffuser, and neutral texels read
// the same in all three. Colours outside the spectral gamut (negative X, Y or Z) are invalid,
// texels with alpha 0 are masked (gutters between UDIM islands), texels with a channel at the end
// of an integer range are saturated. Grey counts as equal red, green and blue. Colours that are
// stored multiplied by alpha are divided by it first. What an OpenEXR file stores around its
// display window is part of the texture.

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/measurements.h"
#include "src/images/image_file.h"

namespace cutis {

struct AlbedoOptions {
  // Empty: what the file says (src/images/color/color_statement.h).
  std::string colorSpace = {};
  std::filesystem::path mask = {};       // may be empty
  std::string layer = {};                // of an OpenEXR file, see src/images/image_layers.h
  const PreviewSink* preview = nullptr;  // as for readImage()
};

struct Albedo {
  Measurements measurements;
  // All channels of the file, untouched, for what is written later.
  Image source;
  ColorDecision colors;
};

// `rig` has an observer as its camera and one light. Notices say how the colours are read where
// that is not the usual way, and what the file's statements have against each other.
Result<Albedo> readAlbedo(const std::filesystem::path& path, const AlbedoOptions& options,
                          const Rig& rig, const std::shared_ptr<TileStore>& store,
                          const JobContext& context);

}  // namespace cutis
