#pragma once

// A small texture and projects of it, for tests of what is saved.

#include <filesystem>
#include <string>

#include "src/app/project/project.h"
#include "src/images/maps/maps_file.h"

namespace cutis::test {

inline constexpr int kTextureWidth = 24;
inline constexpr int kTextureHeight = 16;

// A PNG of one skin colour; another shade is another file.
void writeTexture(const std::filesystem::path& path, float shade = 1.0f);

// An image opened as it is, with one edit, not fitted.
Project projectOf(const std::filesystem::path& image);

// Maps that could have been fitted to the texture with the default profile. Another exposure makes
// other bytes.
MapsFile mapsOfTexture(double exposure = 1.0);

// The names of what lies in a folder and below, sorted: "face.cutis.data/…".
std::vector<std::string> allNames(const std::filesystem::path& folder);

}  // namespace cutis::test
