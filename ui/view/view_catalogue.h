#pragma once

// What the editor calls its layers and how it shows them.

#include <optional>
#include <vector>

#include <QString>

#include "src/app/document/view_part.h"
#include "ui/view/color_scale.h"

namespace cutis {

struct LayerDescription {
  ViewKind kind = ViewKind::photograph;
  QString id;    // "melanin": in scripts and settings
  QString name;  // "Melanin"
  QString toolTip;
  // False colour, for layers of one channel; colour pictures have none.
  std::optional<ScaleKind> scale;
  QString unit;              // of the values, with a scale
  bool needsSource = false;  // cannot be shown of maps alone
};

// In the order of the layers strip.
const std::vector<LayerDescription>& layerCatalogue();

const LayerDescription& describe(ViewKind kind);
std::optional<ViewKind> layerById(const QString& id);

}  // namespace cutis
