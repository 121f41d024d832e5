#pragma once

// Curves of video that no profile's parameters describe (ITU-T H.273, table 3): PQ, HLG and the two
// logarithmic ones.
//
// Light is 1 for diffuse white: for PQ, which counts light of a display in cd/m², 203 of them, and
// for HLG, which counts light of a scene, what the signal 0.75 stands for (ITU-R BT.2408). Both
// reach beyond 1. Pure functions.

#include "src/color/transfer_curve.h"

namespace cutis {

// ITU-R BT.2100, table 4 (SMPTE ST 2084).
TransferCurve pqCurve();
// ITU-R BT.2100, table 5: the inverse of the camera's curve, without the system gamma of a display.
TransferCurve hlgCurve();
// A number falls by 1 over so many decades of light, 2 or 2.5; 0 is no light.
TransferCurve logarithmicCurve(bool isLonger);

}  // namespace cutis
