#pragma once  // internal to src/images/maps

// Names that stand in maps files. For the files of this folder.

#include <cstddef>
#include <string>

namespace cutis::maps_format {

inline constexpr int kNewestVersion = 1;

inline constexpr char kChromophoresPart[] = "chromophores";
inline constexpr char kStatePart[] = "state";
inline constexpr char kDeviationPart[] = "deviation";
inline constexpr char kResidualPart[] = "residual";
inline constexpr char kShadingPart[] = "shading";
inline constexpr char kConstantsPart[] = "constants";
inline constexpr char kConstantsDeviationPart[] = "constants_deviation";

inline constexpr char kDiscrepancyPart[] = "discrepancy";

inline constexpr char kVersion[] = "cutis:version";
inline constexpr char kProfile[] = "cutis:profile";
inline constexpr char kProfileJson[] = "cutis:profile_json";
inline constexpr char kRig[] = "cutis:rig";
inline constexpr char kMethod[] = "cutis:method";
inline constexpr char kExposure[] = "cutis:exposure";
inline constexpr char kSpecularShare[] = "cutis:specular_share";
inline constexpr char kSurface[] = "cutis:surface";
inline constexpr char kFit[] = "cutis:fit";
inline constexpr char kSources[] = "cutis:sources";
inline constexpr char kSourceColorSpace[] = "cutis:source_colorspace";

// The channel of a coefficient.
inline std::string coefficientName(std::size_t coefficient) {
  return "d." + std::to_string(coefficient);
}

}  // namespace cutis::maps_format
