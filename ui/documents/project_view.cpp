#include "ui/documents/project_view.h"

#include <array>
#include <utility>

#include "ui/docks/light_controller.h"
#include "ui/documents/document_page.h"
#include "ui/view/view_catalogue.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

constexpr std::array<std::pair<const char*, ChromaticAdaptation>, 3> kAdaptations = {
    {{"none", ChromaticAdaptation::none},
     {"bradford", ChromaticAdaptation::bradford},
     {"cat16", ChromaticAdaptation::cat16}}};

}  // namespace

ProjectView projectViewOf(DocumentPage& page) {
  ProjectView view;
  view.view = describe(page.views().current()).id.toStdString();
  const Viewport& viewport = page.viewport();
  if (!viewport.fitted()) {
    const QPointF middle = viewport.middle();
    view.place = ViewPlace{middle.x(), middle.y(), viewport.zoom()};
  }
  const LightChoice& light = page.light().light();
  view.light = light.light.toStdString();
  view.observer = light.observer.toStdString();
  for (const auto& [name, adaptation] : kAdaptations) {
    if (adaptation == light.adaptation) view.adaptation = name;
  }
  return view;
}

void showProjectView(DocumentPage& page, const ProjectView& view) {
  if (!view.light.empty() && !view.observer.empty()) {
    LightChoice light = page.light().light();
    light.light = QString::fromStdString(view.light);
    light.observer = QString::fromStdString(view.observer);
    light.kind = LightChoice::Kind::colour;
    for (const auto& [name, adaptation] : kAdaptations) {
      if (name == view.adaptation) light.adaptation = adaptation;
    }
    page.light().setLight(light);
  }
  if (const auto kind = viewById(QString::fromStdString(view.view))) page.views().show(*kind);
  if (view.place) page.viewport().showPlace({view.place->x, view.place->y}, view.place->zoom);
}

}  // namespace cutis
