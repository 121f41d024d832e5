#pragma once  // internal to src/app/project

// The pins of a project as JSON:
//
//   "pins": [ {"letter": "A", "name": "cheek", "place": [812, 440]} ],
//   "pin_size": 3, "pin_reference": "A"
//
// Fields that would say what is usual are left out, so that a project without pins is as it was
// before there were any.

#include <nlohmann/json_fwd.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/project/pin.h"
#include "src/files/io/json_file.h"

namespace cutis {

inline constexpr char kPins[] = "pins";
inline constexpr char kPinSize[] = "pin_size";
inline constexpr char kPinReference[] = "pin_reference";

void addPinsTo(nlohmann::ordered_json& root, const PinSet& set);
// Errors name the field: a letter that is none or comes twice, a size that is not offered.
Result<PinSet> parsePins(const JsonValue& root, const Notice& notice);

}  // namespace cutis
