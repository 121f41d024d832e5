#include "ui/inspector/inspector_text.h"

#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

using Rows = std::vector<InspectorRow>;

QString tr(const char* text) {
  return QCoreApplication::translate("InspectorText", text);
}

InspectorRow heading(const QString& name) {
  return {name, {}, {}, {}, true};
}

QString number(double value, int digits) {
  return std::isfinite(value) ? QString::number(value, 'f', digits) : QString("–");
}

// In the sliders' own words: shares in per cent.
QString amount(Parameter parameter, double value) {
  if (parameter == kCarotene)
    return QString("%1 %2").arg(value, 0, 'g', 2).arg(parameterUnitText(parameter));
  return tr("%1 %").arg(100 * value, 0, 'g', 100 * value < 10 ? 2 : 3);
}

QString colorText(const Eigen::Vector3d& color, int digits) {
  return QString("%1  %2  %3")
      .arg(color[0], 0, 'f', digits)
      .arg(color[1], 0, 'f', digits)
      .arg(color[2], 0, 'f', digits);
}

// "white" of "white.R": photographs have three channels each, an image one row of all.
QString groupOf(const QString& channel) {
  const qsizetype dot = channel.lastIndexOf('.');
  return dot < 0 ? QString() : channel.left(dot);
}

std::vector<std::pair<QString, QString>> sourceRows(const InspectedPlace& place) {
  std::vector<std::pair<QString, QString>> rows;
  QString group, channels, values;
  const auto finish = [&] {
    if (!values.isEmpty()) rows.emplace_back(group.isEmpty() ? channels : group, values);
    channels.clear();
    values.clear();
  };
  for (const InspectedPlace::SourceValue& value : place.source) {
    const QString name = QString::fromStdString(value.name);
    if (groupOf(name) != group) finish();
    group = groupOf(name);
    channels += (channels.isEmpty() ? "" : " ") + name;
    values += (values.isEmpty() ? "" : "  ") + number(value.value, 3);
  }
  finish();
  return rows;
}

void addPicture(const InspectedPlace& place, const InspectedScene& scene, Rows& rows) {
  rows.push_back(heading(tr("Picture")));
  rows.push_back({tr("Pixel"), QString("%1, %2").arg(place.x).arg(place.y)});
  const QString unit = scene.isImage ? tr("as it stands in the file, from 0 to 1")
                                     : tr("share of the white diffuser");
  for (const auto& [name, values] : sourceRows(place))
    rows.push_back({tr("Source %1").arg(name), values, {}, unit});
  if (!place.linear) return;
  rows.push_back(
      {tr("Linear Rec.709"), colorText(*place.linear, 3), {}, tr("under daylight, D65")});
  const DisplayCurve curve(scene.adjustment);
  const auto shown = [&](int c) { return int{curve(static_cast<float>((*place.linear)[c]))}; };
  rows.push_back({tr("Displayed"),
                  QString("%1  %2  %3").arg(shown(0)).arg(shown(1)).arg(shown(2)),
                  {},
                  tr("eight bits of the photograph's view, with its exposure and gamma")});
}

void addSkin(const InspectedPlace& place, Rows& rows) {
  rows.push_back(heading(tr("Skin")));
  for (const Parameter k : kParameters) {
    InspectorRow row = {parameterTitle(k), QString("–")};
    if (place.skin) {
      const double value = place.skin->originalParameters[k];
      row.value = amount(k, value);
      if (const auto& deviation = place.skin->parameterDeviation)
        row.value += tr(" ± %1").arg(amount(k, (*deviation)[k]));
      row.isAssumed = place.isMostlyPrior[k];
      if (row.isAssumed) {
        row.toolTip = tr("The photographs say little about it: it leans on what is known of skin");
      }
      const QString edited = amount(k, place.skin->editedParameters[k]);
      if (edited != amount(k, value)) row.edited = edited;
    }
    rows.push_back(row);
  }
}

void addIndices(const InspectedPlace& place, Rows& rows) {
  rows.push_back(heading(tr("Indices")));
  const auto add = [&](const QString& name, double SkinIndices::*index, const QString& unit,
                       const QString& toolTip) {
    InspectorRow row = {name, QString("–"), {}, toolTip};
    if (place.skin) {
      row.value = number(place.original.*index, 1) + unit;
      const QString edited = number(place.edited.*index, 1) + unit;
      if (edited != row.value) row.edited = edited;
    }
    rows.push_back(row);
  };
  add(tr("ITA"), &SkinIndices::typologyAngle, "°",
      tr("Individual typology angle, Chardon et al. 1991: atan((L* − 50) / b*)"));
  add(tr("Melanin index"), &SkinIndices::melanin, {}, tr("100 · (A650 + A700) / 2"));
  add(tr("Erythema index"), &SkinIndices::erythema, {}, tr("100 · (A560 − (A650 + A510) / 2)"));
  add(tr("Dawson's index"), &SkinIndices::dawsonErythema, {},
      tr("Dawson et al. 1980, from absorbances at 510, 540, 560, 580 and 610 nm"));
}

void addDifferences(const InspectedPlace& place, const InspectedScene& scene, Rows& rows) {
  rows.push_back(heading(tr("Colour difference, ΔE 2000")));
  const auto text = [](const std::optional<double>& value) {
    return value ? number(*value, 2) : QString("–");
  };
  rows.push_back({tr("Model to photograph"),
                  text(place.reconstructionDifference),
                  {},
                  tr("Of the skin model without edits, under daylight")});
  if (scene.skinDifference)
    rows.push_back({tr("The same, median"),
                    text(scene.skinDifference),
                    {},
                    tr("Over the pixels that are like skin")});
  if (!scene.reference.isEmpty())
    rows.push_back({tr("To pin %1").arg(scene.reference),
                    text(place.referenceDifference),
                    {},
                    tr("Of the edited skin here to that at the pin")});
}

void addDisplay(const InspectedScene& scene, Rows& rows) {
  rows.push_back(heading(tr("Display")));
  rows.push_back({tr("View"), tr("sRGB")});
  rows.push_back({tr("Exposure, γ"), QString("%1, %2")
                                         .arg(scene.adjustment.stops, 0, 'f', 2)
                                         .arg(scene.adjustment.gamma, 0, 'f', 2)});
  rows.push_back({tr("Screen"),
                  tr("taken as sRGB"),
                  {},
                  tr("Cutis does not read the screen's colour profile yet")});
}

}  // namespace

std::vector<InspectorRow> inspectorRows(const InspectedPlace& place, const InspectedScene& scene) {
  Rows rows;
  addPicture(place, scene, rows);
  addSkin(place, rows);
  addIndices(place, rows);
  if (place.linear || !scene.reference.isEmpty()) addDifferences(place, scene, rows);
  addDisplay(scene, rows);
  return rows;
}

QString remarkOf(const InspectorRow& row) {
  QStringList remarks;
  if (row.isAssumed) remarks << tr("assumed");
  if (!row.edited.isEmpty()) remarks << tr("edited %1").arg(row.edited);
  return remarks.join(", ");
}

QString textOf(const std::vector<InspectorRow>& rows) {
  QStringList lines;
  for (const InspectorRow& row : rows)
    lines << (row.isHeading ? row.name
                            : QStringList{row.name, row.value, remarkOf(row)}.join('\t'));
  return lines.join('\n') + '\n';
}

}  // namespace cutis
