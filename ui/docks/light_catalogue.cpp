#include "ui/docks/light_catalogue.h"

#include <algorithm>

#include <QCoreApplication>

#include "src/files/spectral_library.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("LightCatalogue", text);
}

QStringList toList(const std::vector<std::string>& names) {
  QStringList list;
  for (const std::string& name : names)
    list << QString::fromStdString(name);
  return list;
}

}  // namespace

QVector<LightGroup> lightGroups() {
  LightGroup daylight{tr("Daylight"), {}}, tungsten{tr("Tungsten"), {}},
      fluorescent{tr("Fluorescent"), {}}, led{tr("LED"), {}}, displays{tr("Displays, white"), {}},
      others{tr("Others"), {}};
  const QStringList displayList = toList(displayNames());
  for (const QString& name : toList(lightNames())) {
    LightGroup* group = &others;
    if (displayList.contains(name)) {
      group = &displays;
    } else if (name.startsWith("LED")) {
      group = &led;
    } else if (name.startsWith("FL")) {
      group = &fluorescent;
    } else if (name == "A" || name.contains("tungsten", Qt::CaseInsensitive)) {
      group = &tungsten;
    } else if (name.startsWith("D")) {
      group = &daylight;
    }
    group->names << name;
  }
  // The light that everything else is compared with stands first.
  std::stable_partition(daylight.names.begin(), daylight.names.end(),
                        [](const QString& name) { return name == "D65"; });
  QVector<LightGroup> groups;
  for (LightGroup* group : {&daylight, &tungsten, &fluorescent, &led, &displays, &others}) {
    if (!group->names.isEmpty()) groups << *group;
  }
  return groups;
}

QString titleOf(const QString& name) {
  if (name == "cie1931") return tr("CIE 1931, 2°");
  if (name == "cie1964") return tr("CIE 1964, 10°");
  // The CIE writes a hyphen; elsewhere the names of files stand for blanks, after who measured.
  if (name.startsWith("LED_")) return QString(name).replace('_', '-');
  return QString(name).remove("iset_").replace('_', ' ');
}

QStringList observerChoices() {
  return toList(observerNames()) + toList(cameraNames());
}

}  // namespace cutis
