#include "ui/compare/comparison.h"

#include <QCoreApplication>

#include "ui/view/view_catalogue.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Comparison", text);
}

ComparedView withoutEdits(ViewKind view, const Document& document) {
  return {view, std::make_shared<const EditStack>(),
          tr("%1, without edits").arg(viewName(view, document))};
}

ComparedView asItIs(ViewKind view, const Document& document) {
  return {view, nullptr, viewName(view, document)};
}

}  // namespace

bool isColor(ViewKind view) {
  return !describe(view).scale.has_value();
}

ComparedView partnerOf(ViewKind view, Partner partner, const std::shared_ptr<const EditStack>& kept,
                       const Document& document) {
  const bool hasPhotograph = document.scene().source != nullptr;
  if (partner == Partner::kept && kept != nullptr) {
    const ViewKind same = isPhotograph(view) ? ViewKind::editedAlbedo : view;
    return {same, kept, tr("%1, as kept").arg(viewName(same, document))};
  }
  if (!isColor(view) || !hasPhotograph) return withoutEdits(view, document);
  if (partner == Partner::reconstruction) return withoutEdits(ViewKind::skin, document);
  const ViewKind wanted =
      partner == Partner::edited ? ViewKind::editedAlbedo : ViewKind::photograph;
  const ViewKind other = partner == Partner::edited ? ViewKind::photograph : ViewKind::editedAlbedo;
  return asItIs(view == wanted ? other : wanted, document);
}

}  // namespace cutis
