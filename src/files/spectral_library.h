#pragma once

// Lights, cameras, observers and displays by name: the built-in library, or the user's own CSV
// files.
//
// A reference is a name of the library ("D65", "cie1931", "Canon_EOS_R") or a path to a CSV file.
// Names win over files; a path with a folder or ".csv" in it is always a file.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/spectra/colorimetry.h"
#include "src/files/spectra/spectral_csv.h"

namespace cutis {

// Built-in names, sorted. Lights include the displays at white.
std::vector<std::string> lightNames();
std::vector<std::string> cameraNames();
std::vector<std::string> observerNames();
std::vector<std::string> displayNames();

// `folder` is where relative paths start: the folder of the file that names them, or empty for the
// working directory. `place` stands in front of errors about the reference itself. `notice` hears
// what of a file was left out or is questionable.
struct Reference {
  std::string name;
  std::filesystem::path folder;
  std::string place;
  Notice notice = {};
};

// Relative power; a file with several columns is their sum (a display at white).
Result<Spectrum> loadLight(const Reference& reference);
// An observer or a camera; the header's names decide which: X, Y, Z or R, G, B.
Result<Camera> loadCamera(const Reference& reference);
// Three primaries, columns R, G, B.
Result<std::array<Spectrum, 3>> loadPrimaries(const Reference& reference);

// The table of pure chromophores that a profile names.
Result<SpectralTable> loadChromophores(const Reference& reference);

}  // namespace cutis
