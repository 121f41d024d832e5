#include "ui/docks/fit_catalogue.h"

#include <QCoreApplication>

#include "src/files/profiles/profile_file.h"

namespace cutis {
namespace {

constexpr char kWithoutDiscrepancy[] = "skin2026";

QString tr(const char* text) {
  return QCoreApplication::translate("FitCatalogue", text);
}

std::vector<MethodDescription> makeMethods() {
  return {
      {FitMethod::refined, tr("Refined"),
       tr("The most probable skin under the exact model: the most accurate, for all that counts")},
      {FitMethod::network, tr("Network"),
       tr("What a trained network answers: the fastest, for a look at large pictures")},
      {FitMethod::threeStage, tr("Three-stage"),
       tr("The paper's search in a table of skin, in three steps: to compare with it")},
      {FitMethod::fullSearch, tr("Full search"),
       tr("The nearest of all skins in the table: to compare with, its maps have steps")},
  };
}

}  // namespace

const std::vector<MethodDescription>& methodCatalogue() {
  static const std::vector<MethodDescription> catalogue = makeMethods();
  return catalogue;
}

QString profileToolTip(const QString& profile) {
  if (profile == kDefaultProfile) {
    return tr(
        "Calibrated on measured skin, and knows what its model leaves over: use it unless you "
        "compare with the paper");
  }
  if (profile == kWithoutDiscrepancy) {
    return tr("The same without what its model leaves over of measured skin: the default before");
  }
  if (profile == kPaperProfile) {
    return tr("The paper's model: to compare with it; far too bright in the ultraviolet");
  }
  return {};
}

}  // namespace cutis
