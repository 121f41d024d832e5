#include "ui/edits/preset_catalogue.h"

#include <QCoreApplication>

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("PresetCatalogue", text);
}

}  // namespace

const std::vector<PresetDescription>& presetCatalogue() {
  static const std::vector<PresetDescription> all = {
      {"tan", tr("Tan"), tr("More melanin, as after weeks in the sun")},
      {"pale", tr("Pale"), tr("Half the blood, deep and near the surface")},
      {"flushed", tr("Flushed"), tr("More blood, as after running")},
      {"less_stubble", tr("Less stubble"),
       tr("Less of the dark melanin that hair below the surface shows")},
      {"more_stubble", tr("More stubble"),
       tr("More of the dark melanin that hair below the surface shows")},
      {"carotenaemia", tr("Carotenaemia"), tr("Three times the carotene: golden to orange skin")},
  };
  return all;
}

}  // namespace cutis
