#pragma once

// The presets that come with the editor: files of edits below resources/presets, after Figure 7 of
// the paper. Interface thread only.

#include <vector>

#include <QString>

namespace cutis {

struct PresetDescription {
  QString id;  // of its file and its command: "less_stubble"
  QString title;
  QString toolTip;
};

const std::vector<PresetDescription>& presetCatalogue();

}  // namespace cutis
