#pragma once  // internal to src/images/color

// An ICC profile as a JPEG file holds it (ICC.1:2022, Annex B.4): in APP2 segments of at most
// 65,519 bytes each. OpenImageIO writes a profile that needs more than one of them wrongly, so that
// they are made here. A pure function.

#include <string>

namespace cutis {

// The segments, one behind the other; empty for a profile that is too large for 255 of them.
std::string profileSegments(const std::string& profile);

}  // namespace cutis
