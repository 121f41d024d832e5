#pragma once

// Places of errors about what somebody chose, in words that hold for window and command line alike;
// the command line names its options instead.

namespace cutis {

inline constexpr char kColorSpaceChoice[] = "colour space";
inline constexpr char kExposureChoice[] = "exposure";
inline constexpr char kLayerChoice[] = "layer";
inline constexpr char kLightsChoice[] = "lights";
inline constexpr char kRigChoice[] = "rig";
inline constexpr char kSurfaceChoice[] = "surface reflection";

}  // namespace cutis
