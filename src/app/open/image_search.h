#pragma once

// Images as their names tell them: those of a folder, and those that are masks of others.

#include <filesystem>
#include <vector>

namespace cutis {

// The images that lie in a folder, in the order of their names; masks by their names are left out.
std::vector<std::filesystem::path> photographsIn(const std::filesystem::path& folder);

// Whether its name ends in the word "mask", as those of "face_mask.png" and "mask.png" do.
bool isNamedMask(const std::filesystem::path& file);

// "face_mask.png" or "mask.png" in the folder of a photograph "face.png"; empty if there is none.
std::filesystem::path maskBeside(const std::filesystem::path& photograph);

// Whether the word "mask" stands anywhere in the name of an image: "Mask2.png", "mask of face.png".
// Enough to ask somebody, not more.
bool mayBeMask(const std::filesystem::path& file);

}  // namespace cutis
