#pragma once  // internal to src/files/profiles

// The field "discrepancy" of a profile.json (core/skin/profile/discrepancy.h):
//
//   {"surface_included": {"mean": […], "components": [[…], …], "slope": [[…], …],
//                         "covariance": [[…], …], "rest": [[…], …],
//                         "independent_deviation": […], "prior": {…}},
//    "surface_removed": …}
//
// Spectra are a number every 10 nm from 300 to 1000 nm, and linear between them; a row of "slope"
// has a number for each parameter, in the order of the maps. Either kind of surface may be
// left out, and the independent deviation, which then is zero.

#include "core/base/result.h"
#include "core/skin/profile/discrepancy.h"
#include "src/files/io/json_file.h"

namespace cutis {

inline constexpr int kKnotDistanceNm = 10;
inline constexpr int kKnotCount = (kLastWavelengthNm - kFirstWavelengthNm) / kKnotDistanceNm + 1;

// The profile's, or none where it has no such field. Numbers are not checked beyond being there.
Result<Discrepancies> parseDiscrepancies(const JsonValue& profile);

}  // namespace cutis
