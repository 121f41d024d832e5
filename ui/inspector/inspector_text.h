#pragma once  // internal to ui/inspector

// What an inspected pixel is called and how its numbers are written.

#include <vector>

#include <QString>

#include "src/app/document/inspected_place.h"
#include "ui/color/display_curve.h"

namespace cutis {

struct InspectorRow {
  QString name;
  QString value;         // "6.4 % ± 0.8 %"
  QString edited = {};   // where an edit changes it
  QString toolTip = {};  // of the row
  bool isHeading = false;
  bool isAssumed = false;  // the photographs say little about it
};

struct InspectedScene {
  bool isImage = false;                  // and no photographs of a capture
  std::optional<double> skinDifference;  // median ΔE of the reconstruction over the skin
  QString reference;                     // letter of the pin that colours are compared with
  ViewAdjustment adjustment;
};

// The rows for a place, in an order that does not depend on it; none for what the document does not
// have at all.
std::vector<InspectorRow> inspectorRows(const InspectedPlace& place, const InspectedScene& scene);
// "assumed, edited 9.6 %"; empty where there is nothing to remark.
QString remarkOf(const InspectorRow& row);
// As lines of name, value and remark with tabs between them, for the clipboard.
QString textOf(const std::vector<InspectorRow>& rows);

}  // namespace cutis
