#pragma once  // internal to ui/compare

// What a view is compared with, and how the two are shown.

#include <memory>
#include <optional>

#include <QString>

#include "core/edit/edit_stack.h"
#include "src/app/document/document.h"
#include "src/app/views/view_kind.h"

namespace cutis {

enum class ComparisonMode { none, wipe, sideBySide, difference };

enum class Partner {
  original,        // a map without edits, or the photograph; for the photograph the edited albedo
  reconstruction,  // the skin model without edits
  edited,          // the edited albedo; for the edited albedo the photograph
  kept             // the same view, with edits that were kept
};

struct ComparedView {
  ViewKind view = ViewKind::photograph;
  std::shared_ptr<const EditStack> edits;  // instead of the document's; null: the document's
  QString name;
};

// What the view is compared with where this partner is chosen. A map and a band are compared with
// themselves: without edits, or with the kept ones. kept: null where none were kept; then the
// partner `kept` is the original. Precondition: the document is open.
ComparedView partnerOf(ViewKind view, Partner partner, const std::shared_ptr<const EditStack>& kept,
                       const Document& document);

// Whether the two differ by a colour, so that the difference is CIEDE2000.
bool isColor(ViewKind view);

}  // namespace cutis
