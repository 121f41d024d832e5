#pragma once

// A project: what was opened and how, how it is fitted, how it is edited and how it is looked at.
//
// Paths are absolute here; the manifest names them from its own folder
// (src/app/project/manifest.h).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/edit/edit_stack.h"
#include "src/app/open/fit_choice.h"
#include "src/app/open/source.h"
#include "src/app/project/pin.h"
#include "src/app/project/source_file.h"

namespace cutis {

enum class SourceKind { sample, image, capture, maps };

struct ProjectSource {
  SourceKind kind = SourceKind::sample;
  std::filesystem::path path;  // empty for the sample
  SourceOptions options;       // exposure and surface are the fit's
  // All that is read: the path itself, photographs, mask, rig and what these name.
  std::vector<SourceFile> files;
};

// A place in the picture: its middle in pixels, and how many pixels of the screen one of the
// picture fills.
struct ViewPlace {
  double x = 0.0;
  double y = 0.0;
  double zoom = 1.0;
  bool operator==(const ViewPlace&) const = default;
};

struct ProjectView {
  std::string view;                // its id: "melanin"; empty: the usual one
  std::optional<ViewPlace> place;  // none: the whole picture
  std::string light;               // names or paths; empty: the usual ones
  std::string observer;
  std::string adaptation;  // of the eyes to the light; empty: the usual one
  bool operator==(const ProjectView&) const = default;
};

struct Project {
  ProjectSource source;
  FitChoice fit;
  EditStack edits;
  ProjectView view;
  // The file of the fitted maps, named by the content hash of its bytes; empty: not fitted.
  std::filesystem::path maps;
  // In a journal: the project that these are unsaved edits of; empty: they were of none.
  std::filesystem::path editsOf = {};
  PinSet pins = {};
};

}  // namespace cutis
