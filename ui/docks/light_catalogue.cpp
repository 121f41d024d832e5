#include "ui/docks/light_catalogue.h"

#include <algorithm>
#include <utility>

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
  static const std::pair<const char*, QString> titles[] = {
      {"cie1931", tr("CIE 1931 2°")},
      {"cie1964", tr("CIE 1964 10°")},
      {"A", tr("Tungsten lamp (A)")},
      {"iset_Tungsten", tr("Tungsten lamp, measured")},
      {"D50", tr("Horizon daylight (D50)")},
      {"D55", tr("Mid-morning daylight (D55)")},
      {"D65", tr("Noon daylight (D65)")},
      {"E", tr("Equal energy (E)")},
      {"FL2", tr("Cool white tube (FL2)")},
      {"FL11", tr("Three-band tube (FL11)")},
      {"LED_B3", tr("White LED, 4100 K (LED-B3)")},
      {"LED_B5", tr("White LED, 6600 K (LED-B5)")},
      {"LED_RGB1", tr("Red, green, blue LEDs (LED-RGB1)")},
      {"iset_LCD_HP", tr("HP LCD")},
      {"iset_LCD_Gechic", tr("Gechic LCD")},
      {"Sony_ILCE-7M3", tr("Sony α7 III (ILCE-7M3)")},
  };
  for (const auto& [known, title] : titles) {
    if (name == known) return title;
  }
  // Files that name themselves well have underscores for blanks.
  return QString(name).replace('_', ' ');
}

bool isCamera(const QString& observer) {
  return toList(cameraNames()).contains(observer);
}

QStringList observerChoices() {
  return toList(observerNames()) + toList(cameraNames());
}

}  // namespace cutis
