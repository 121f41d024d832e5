#include "src/files/spectral_library.h"

#include <algorithm>
#include <optional>

#include "core/base/echoed_text.h"
#include "src/files/io/suggestion.h"
#include "src/files/resources.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kIlluminants[] = "spectra/illuminants";
constexpr char kDisplays[] = "spectra/displays";
constexpr char kCameras[] = "spectra/cameras";
constexpr char kObservers[] = "spectra/observers";
constexpr std::string_view kCiePrefix = "cie_";

std::vector<std::string> merged(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

std::optional<std::string> builtIn(const std::string& folder, const std::string& stem) {
  const std::string name = folder + "/" + stem + ".csv";
  return resource(name) ? std::optional(name) : std::nullopt;
}

// The resource a name stands for, searched in these folders.
std::optional<std::string> findBuiltIn(const std::string& name,
                                       const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    if (auto found = builtIn(folder, name)) return found;
    if (auto found = builtIn(folder, std::string(kCiePrefix) + name)) return found;
  }
  return std::nullopt;
}

bool looksLikePath(const std::string& name) {
  return name.find('/') != std::string::npos || name.find('\\') != std::string::npos ||
         name.ends_with(".csv");
}

Result<SpectralTable> loadTable(const Reference& reference, const char* what,
                                const std::vector<std::string>& folders,
                                const std::vector<std::string>& known) {
  if (!looksLikePath(reference.name)) {
    if (const auto found = findBuiltIn(reference.name, folders)) {
      return parseSpectralCsv(*resource(*found), "built-in " + reference.name);
    }
  }
  const fs::path path = reference.folder / reference.name;
  std::error_code ignored;
  if (!looksLikePath(reference.name) && !fs::exists(path, ignored)) {
    return inputError(reference.place,
                      std::string("unknown ") + what + " " + inQuotes(reference.name) + "; " +
                          suggestName(reference.name, known) + ", or name a CSV file");
  }
  CUTIS_TRY(table, readSpectralCsv(path));
  for (const std::string& note : table.notes) {
    if (reference.notice) reference.notice(note);
  }
  return std::move(table);
}

// Positions of three named columns; nothing if one is missing.
std::optional<std::array<std::size_t, 3>> columnsNamed(const SpectralTable& table,
                                                       const std::array<std::string, 3>& names) {
  std::array<std::size_t, 3> columns = {};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto found = std::find(table.names.begin(), table.names.end(), names[k]);
    if (found == table.names.end()) return std::nullopt;
    columns[k] = static_cast<std::size_t>(found - table.names.begin());
  }
  return columns;
}

}  // namespace

std::vector<std::string> lightNames() {
  std::vector<std::string> names;
  for (std::string& stem : resourceStems(kIlluminants, ".csv")) {
    names.push_back(stem.starts_with(kCiePrefix) ? stem.substr(kCiePrefix.size()) : stem);
  }
  return merged(std::move(names), displayNames());
}

std::vector<std::string> cameraNames() {
  return resourceStems(kCameras, ".csv");
}
std::vector<std::string> observerNames() {
  return resourceStems(kObservers, ".csv");
}
std::vector<std::string> displayNames() {
  return resourceStems(kDisplays, ".csv");
}

Result<Spectrum> loadLight(const Reference& reference) {
  CUTIS_TRY(table, loadTable(reference, "light", {kIlluminants, kDisplays}, lightNames()));
  Spectrum power = Spectrum::Zero();
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    power += table.onGrid(c);
  if ((power < 0.0).any() || power.sum() <= 0.0) {
    return inputError(
        table.place,
        "the light has negative or no power between 300 and 1000 nm; correct the file");
  }
  return power;
}

Result<Camera> loadCamera(const Reference& reference) {
  CUTIS_TRY(table, loadTable(reference, "camera or observer", {kObservers, kCameras},
                             merged(observerNames(), cameraNames())));
  Camera camera;
  camera.name = reference.name;
  auto columns = columnsNamed(table, {"R", "G", "B"});
  if (!columns) {
    camera.isObserver = true;
    camera.channelNames = {"X", "Y", "Z"};
    columns = columnsNamed(table, camera.channelNames);
  }
  if (!columns) {
    return inputError(table.place,
                      "the header must name columns R, G, B (camera) or X, Y, Z (observer)");
  }
  for (int c = 0; c < 3; ++c) {
    camera.sensor.sensitivity.row(c) =
        table.onGrid((*columns)[static_cast<std::size_t>(c)]).transpose();
  }
  return camera;
}

Result<std::array<Spectrum, 3>> loadPrimaries(const Reference& reference) {
  CUTIS_TRY(table, loadTable(reference, "display", {kDisplays}, displayNames()));
  const auto columns = columnsNamed(table, {"R", "G", "B"});
  if (!columns) {
    return inputError(table.place, "the header must name columns R, G, B, one per primary");
  }
  std::array<Spectrum, 3> primaries;
  for (std::size_t c = 0; c < 3; ++c)
    primaries[c] = table.onGrid((*columns)[c]);
  return primaries;
}

Result<SpectralTable> loadChromophores(const Reference& reference) {
  return loadTable(reference, "table of chromophores", {"spectra"}, {"chromophores"});
}

}  // namespace cutis
