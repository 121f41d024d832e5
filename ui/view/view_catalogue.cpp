#include "ui/view/view_catalogue.h"

#include <algorithm>
#include <string_view>

#include <QCoreApplication>

#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("ViewCatalogue", text);
}

QString textOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

// A view of one of the parameters, in its unit.
ViewDescription mapOf(ViewKind kind, const QString& toolTip) {
  ViewDescription map;
  map.kind = kind;
  map.id = textOf(parameterName(*parameterOf(kind)));
  map.name = parameterTitle(*parameterOf(kind));
  map.toolTip = toolTip;
  map.scale = ScaleKind::sequential;
  map.unit = parameterUnitText(*parameterOf(kind));
  return map;
}

std::vector<ViewDescription> makeCatalogue() {
  constexpr auto grey = ScaleKind::grey;
  return {
      {ViewKind::photograph,
       "photograph",
       tr("Photograph"),
       tr("What was opened, as it looks under daylight"),
       std::nullopt,
       {},
       true},
      {ViewKind::editedAlbedo,
       "albedo",
       tr("Edited albedo"),
       tr("What an export writes: the source, changed by as much as the edits change the skin"),
       std::nullopt,
       {},
       true},
      {ViewKind::skin,
       "skin",
       tr("Skin"),
       tr("The skin model alone, under the chosen light"),
       std::nullopt,
       {},
       false},
      mapOf(ViewKind::melanin, tr("Share of the epidermis that is melanin")),
      mapOf(ViewKind::melaninBlend,
            tr("Share of eumelanin (brown to black); the rest is pheomelanin (red to yellow)")),
      mapOf(ViewKind::haemoglobinDermal, tr("Share of the dermis that is blood")),
      mapOf(ViewKind::haemoglobinEpidermal, tr("Share of blood near the surface")),
      mapOf(ViewKind::carotene, tr("β-Carotene in the epidermis")),
      {ViewKind::ultraviolet, "uv", tr("UV"),
       tr("Mean reflectance from 300 to 400 nm; predicted by the model, not measured"), grey,
       tr("reflectance"), false},
      {ViewKind::nearInfrared, "nir", tr("NIR"),
       tr("Mean reflectance from 700 to 1000 nm; predicted by the model, not measured"), grey,
       tr("reflectance"), false},
  };
}

}  // namespace

const std::vector<ViewDescription>& viewCatalogue() {
  static const std::vector<ViewDescription> catalogue = makeCatalogue();
  return catalogue;
}

const ViewDescription& describe(ViewKind kind) {
  const auto& all = viewCatalogue();
  return *std::find_if(all.begin(), all.end(), [kind](const auto& d) { return d.kind == kind; });
}

QString viewName(ViewKind kind, const Document& document) {
  const bool isTexture =
      document.isOpen() && document.scene().source && document.scene().source->image.has_value();
  return isTexture && kind == ViewKind::photograph ? tr("Source") : describe(kind).name;
}

std::optional<ViewKind> viewById(const QString& id) {
  for (const ViewDescription& view : viewCatalogue()) {
    if (view.id == id) return view.kind;
  }
  return std::nullopt;
}

}  // namespace cutis
