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

ViewDescription pictureOf(ViewKind kind, const QString& id, const QString& name,
                          const QString& toolTip) {
  ViewDescription picture;
  picture.kind = kind;
  picture.id = id;
  picture.name = name;
  picture.group = tr("Pictures");
  picture.toolTip = toolTip;
  return picture;
}

// A view of one of the parameters, in its unit.
ViewDescription mapOf(ViewKind kind, const QString& toolTip) {
  const Parameter parameter = *parameterOf(kind);
  ViewDescription map;
  map.kind = kind;
  map.id = textOf(parameterName(parameter));
  map.name = parameterTitle(parameter);
  map.group = tr("Maps");
  map.toolTip = toolTip;
  map.scale = ScaleKind::sequential;
  map.unit = parameterUnitText(parameter);
  return map;
}

// One channel without edits.
ViewDescription scaleOf(ViewKind kind, const QString& id, const QString& name, const QString& group,
                        const QString& unit, const QString& toolTip) {
  ViewDescription view = pictureOf(kind, id, name, toolTip);
  view.group = group;
  view.scale = ScaleKind::sequential;
  view.unit = unit;
  return view;
}

ViewDescription deviationView(Parameter parameter) {
  const auto kind = static_cast<ViewKind>(static_cast<int>(ViewKind::melaninDeviation) + parameter);
  return scaleOf(kind, textOf(parameterName(parameter)) + "_deviation",
                 tr("±\u00a0%1").arg(parameterTitle(parameter)), tr("Uncertainty"),
                 parameterUnitText(parameter),
                 tr("Standard deviation of the value, given the photographs"));
}

ViewDescription bandView(ViewKind kind, const QString& id, const QString& name,
                         const QString& toolTip) {
  ViewDescription band =
      scaleOf(kind, id, name, tr("Predicted bands"), tr("reflectance, predicted"), toolTip);
  band.scale = ScaleKind::grey;
  return band;
}

std::vector<ViewDescription> lightViews() {
  std::vector<ViewDescription> lights;
  for (int i = 0; i < kMaximumLights; ++i) {
    lights.push_back(pictureOf(lightView(i), QString("light%1").arg(i + 1),
                               tr("Photograph %1").arg(i + 1),
                               tr("As the camera saw it under this light")));
    lights.back().group = tr("Photographs");
    lights.back().shortcut = QString("Ctrl+Alt+Shift+%1").arg((i + 1) % 10);
  }
  return lights;
}

std::vector<ViewDescription> makeCatalogue() {
  const QString maps = tr("Maps"), uncertainty = tr("Uncertainty");
  std::vector<ViewDescription> all = {
      pictureOf(ViewKind::photograph, "photograph", tr("Photograph"),
                tr("What was opened, as it looks under daylight")),
      pictureOf(ViewKind::editedAlbedo, "albedo", tr("Edited albedo"),
                tr("What an export writes: the source, changed by as much as the edits change the "
                   "skin")),
      pictureOf(ViewKind::skin, "skin", tr("Skin"),
                tr("The skin model alone, under the chosen light")),
      mapOf(ViewKind::melanin, tr("Share of the epidermis that is melanin")),
      mapOf(ViewKind::melaninBlend,
            tr("Share of eumelanin (brown to black); the rest is pheomelanin (red to yellow)")),
      mapOf(ViewKind::haemoglobinDermal, tr("Share of the dermis that is blood")),
      mapOf(ViewKind::haemoglobinEpidermal, tr("Share of blood near the surface")),
      mapOf(ViewKind::carotene, tr("β-Carotene in the epidermis")),
      bandView(ViewKind::ultraviolet, "uv", tr("UV"),
               tr("Mean reflectance from 300 to 400 nm; predicted by the model, not measured")),
      bandView(ViewKind::nearInfrared, "nir", tr("NIR"),
               tr("Mean reflectance from 700 to 1000 nm; predicted by the model, not measured")),
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].shortcut = QString("Alt+%1").arg((i + 1) % 10);
    all[i].isUsual = true;
  }
  all.push_back(bandView(ViewKind::band, "band", tr("Single band"),
                         tr("Reflectance at one wavelength from 300 to 1000 nm, as the model "
                            "predicts it; the slider in the picture chooses it")));
  all.back().shortcut = "Alt+Shift+3";
  const auto insert = [&](ViewKind after, ViewDescription view, const QString& shortcut) {
    view.shortcut = shortcut;
    const auto place =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.kind == after; });
    all.insert(place + 1, std::move(view));
  };
  insert(ViewKind::carotene,
         scaleOf(ViewKind::oxygenation, "oxygenation", tr("Oxygenation"), maps, tr("share"),
                 tr("Share of the dermis's haemoglobin that carries oxygen")),
         "Alt+Shift+1");
  insert(ViewKind::oxygenation,
         scaleOf(ViewKind::thickness, "thickness", tr("Thickness"), maps, tr("mm"),
                 tr("Thickness of the epidermis")),
         "Alt+Shift+2");
  ViewKind last = ViewKind::thickness;
  for (const Parameter parameter : kParameters) {
    const ViewDescription view = deviationView(parameter);
    insert(last, view, QString("Alt+Shift+%1").arg(4 + int{parameter}));
    last = view.kind;
  }
  ViewDescription residual =
      scaleOf(ViewKind::residual, "residual", tr("Residual"), uncertainty, tr("× noise"),
              tr("How far the photographs are from the model, root mean square over the channels"));
  insert(last, residual, "Alt+Shift+9");
  insert(ViewKind::residual,
         scaleOf(ViewKind::shading, "shading", tr("Shading"), uncertainty, tr("factor"),
                 tr("The factor on all channels that the fit has found")),
         "Alt+Shift+0");
  for (const ViewDescription& light : lightViews())
    all.push_back(light);
  return all;
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
  if (!document.isOpen() || !document.scene().source) return describe(kind).name;
  const Source& source = *document.scene().source;
  if (kind == ViewKind::photograph && source.image.has_value()) return tr("Source");
  const auto light = lightOf(kind);
  const std::vector<RigLight>& lights = source.measurements.rig.lights;
  if (!light || *light >= static_cast<int>(lights.size())) return describe(kind).name;
  return QString::fromStdString(lights[static_cast<std::size_t>(*light)].name);
}

QString viewObjection(ViewKind kind, const Scene& scene) {
  if (canShow(scene, kind)) return {};
  if (scene.source == nullptr)
    return tr("Maps alone hold no photograph; open the photographs they were fitted to");
  if (lightOf(kind)) return tr("There is no such photograph");
  if (constantOf(kind)) return tr("This constant is not found per pixel; see Fit options");
  if (kind == ViewKind::shading) return tr("The fit does not estimate shading");
  return tr("The fit is not that far yet, or its method knows no uncertainty");
}

std::optional<ViewKind> viewById(const QString& id) {
  for (const ViewDescription& view : viewCatalogue()) {
    if (view.id == id) return view.kind;
  }
  return std::nullopt;
}

}  // namespace cutis
