#pragma once

// What the editor calls its views and how it shows them.

#include <optional>
#include <vector>

#include <QString>

#include "src/app/document/document.h"
#include "src/app/views/view_part.h"
#include "ui/color/color_scale.h"

namespace cutis {

struct ViewDescription {
  ViewKind kind = ViewKind::photograph;
  QString id;     // "melanin": in scripts and settings
  QString name;   // "Melanin"
  QString group;  // "Maps": what stands together in the strip and in the menu
  QString shortcut;
  bool isUsual = false;  // every document with photographs has it
  QString toolTip;
  // False colour, for views of one channel; colour pictures have none.
  std::optional<ScaleKind> scale;
  QString unit;  // of the values, with a scale
};

// In the order of the views strip.
const std::vector<ViewDescription>& viewCatalogue();

const ViewDescription& describe(ViewKind kind);
// What a view of this document is called: of a texture, nothing is a photograph; those under the
// lights of a rig have their names.
QString viewName(ViewKind kind, const Document& document);
std::optional<ViewKind> viewById(const QString& id);
// Why the view is not there; empty where the scene can be shown so.
QString viewObjection(ViewKind kind, const Scene& scene);

}  // namespace cutis
