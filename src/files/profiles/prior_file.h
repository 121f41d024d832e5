#pragma once

// A prior in JSON, in a profile or in a file of its own (--prior):
//
//   {"scale": "linear" | "log", "mean": {NAME: x}, "sd": {NAME: x},
//    "linear": [NAME…], "correlation": {"NAME,NAME": r}}
//
// "linear" names parameters that stay linear on the log scale, besides the blend, which always
// does; "correlation" has pairs in any order, of what sd refers to (logarithms, or parameters that
// are linear); pairs it leaves out are not correlated.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/base/result.h"
#include "core/skin/profile/prior.h"
#include "src/files/io/json_file.h"

namespace cutis {

// The prior in a profile: all means and deviations must be named. Checked with validate() as part
// of the profile, not here.
Result<Prior> parsePrior(const JsonValue& object);

// A file of its own. Of the same "scale" as `base`, a parameter neither "mean" nor "sd" nor
// "linear" names stays as it is in `base`, its own scale included, and of those named once the
// other number stays, unless their scale is another: numbers of one scale mean nothing on the
// other. Of another "scale", all must be named. Without "correlation", parameters whose scale stays
// keep theirs.
Result<Prior> readPrior(const std::string& path, const Prior& base);

// The object that parsePrior() reads the same prior from; pairs that are not correlated are left
// out.
nlohmann::ordered_json priorJson(const Prior& prior);

}  // namespace cutis
