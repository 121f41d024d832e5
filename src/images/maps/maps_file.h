#pragma once

// Maps: what a fit makes of photographs, in one OpenEXR file of several parts.
//
//   chromophores  melanin, melanin_blend, haemoglobin_dermal, haemoglobin_epidermal, carotene;
//                 float32, in the parameters' units, 0 where there is no estimate
//   state         state: 0 solved, 1 masked, 2 invalid, 3 saturated, 4 no convergence
//   deviation     the five names again: posterior standard deviations   (optional)
//   residual      "light.channel": measured minus modelled              (optional)
//   shading       shading                                               (optional)
//   constants     oxygenation, thickness_mm: those that were found for each pixel instead of the
//                 profile's; 0 where there is no estimate               (optional)
//   constants_deviation  the same names: posterior standard deviations  (optional)
//   discrepancy   d.0, d.1, …: coefficients of what the profile's model leaves over of measured
//                 skin, as halves; 0 where there is no estimate         (optional)
//
// Attributes of the part chromophores: cutis:version, cutis:profile (name), cutis:profile_json (all
// of the profile, so that the maps can be read anywhere), cutis:rig (name), cutis:method,
// cutis:exposure, cutis:specular_share (where it is not 0), cutis:surface (with the part
// discrepancy: "included" or "removed", which of the profile's), cutis:fit (JSON: what a refined
// fit took for granted, src/files/profiles/fit_record_file.h), cutis:sources (JSON list of file and
// hash), cutis:source_colorspace.
//
// Channels are found by name. A pixel whose values are not finite, or whose constants lie where no
// profile can have them, is read as invalid, with a notice; a deviation, residual or shading that
// is not finite is read as 0. Pixels that another program cropped away (the data window is smaller
// than the display window) are read as masked. Errors are sentences about the file.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/plane.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"
#include "src/images/codec/metadata.h"
#include "src/images/source_reference.h"

namespace cutis {

struct MapsAttributes {
  std::string profileName;
  std::string profileJson;  // profileText() of src/files; may be empty in files of other programs
  std::string rigName;
  std::string method;          // as on the command line: "refined", …
  double specularShare = 0.0;  // reflection of the surface that was taken off the sources
  double exposure = 1.0;       // the sources were multiplied by this
  std::vector<SourceReference> sources;
  std::string sourceColorSpace;  // its name, empty for photographs
  std::string fit;  // fitRecordText() of src/files; empty where nothing is known of the estimates
};

struct MapsFile {
  ChromophoreMaps maps;
  std::vector<Plane> deviations;           // one per parameter, or none
  std::vector<Plane> constantDeviations;   // one per constant of the maps, or none
  std::vector<Plane> residuals;            // one per name below
  std::vector<std::string> residualNames;  // "white.R", …; as read, the names' order is the file's
  Plane shading;                           // may be empty
  MapsAttributes attributes;
  ImageMetadata metadata;  // of the first source
};

// Whether the file declares itself as maps; false for everything else, unreadable or not.
bool isMapsFile(const std::filesystem::path& path);

Result<MapsFile> readMaps(const std::filesystem::path& path, PixelFormat format,
                          const std::shared_ptr<TileStore>& store, const JobContext& context);

// Whether the name is that of a format that holds maps; a usage error where it is not.
Status checkMapsName(const std::filesystem::path& path);

// Replaces the file as a whole or leaves it as it was. Precondition: all planes have the size of
// the maps, deviations are none or five, those of constants none or as many as these, residuals
// match their names.
Status writeMaps(const std::filesystem::path& path, const MapsFile& file,
                 const JobContext& context);

}  // namespace cutis
