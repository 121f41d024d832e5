#pragma once

// The extension of a file's name, by which formats are told apart without regard to case.

#include <filesystem>
#include <string>

namespace cutis {

// With its dot and in lower case: ".exr" of "Face.EXR"; empty where there is none.
std::string lowerExtension(const std::filesystem::path& path);

}  // namespace cutis
