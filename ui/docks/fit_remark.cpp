#include "ui/docks/fit_remark.h"

#include <QCoreApplication>

namespace cutis {
namespace {

// More would be seen in the maps.
constexpr double kPercentToMention = 1.0;

QString tr(const char* text) {
  return QCoreApplication::translate("FitRemark", text);
}

}  // namespace

FitRemark remarkOn(const FitStatistics& statistics) {
  const FitStatistics::Pixels& pixels = statistics.pixels;
  if (pixels.total == 0) return {};
  if (pixels.solved + pixels.duplicate == 0) {
    return {tr("No pixel could be fitted: all are masked, black or saturated"), true};
  }
  const double rough =
      100.0 * static_cast<double>(pixels.noConvergence) / static_cast<double>(pixels.total);
  if (rough <= kPercentToMention) return {};
  return {tr("%1 % of the pixels did not settle; their values are rough").arg(rough, 0, 'f', 0),
          false};
}

}  // namespace cutis
