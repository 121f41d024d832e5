#include "ui/spectrum/pixel_readout.h"

#include <QCoreApplication>

#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("PixelReadout", text);
}

// Shares in per cent, as the sliders' limits are.
QString valueText(Parameter parameter, double value) {
  if (parameter == kCarotene) {
    return QString("%1 %2").arg(value, 0, 'g', 2).arg(parameterUnitText(parameter));
  }
  return tr("%1 %").arg(100 * value, 0, 'g', 100 * value < 10 ? 2 : 3);
}

}  // namespace

QString pixelReadout(const Document& document, const QPoint& pixel,
                     const std::optional<ParameterVector>& deviation) {
  const auto parameters = document.parametersAt(pixel.x(), pixel.y());
  const QString place = QString("%1, %2").arg(pixel.x()).arg(pixel.y());
  if (!parameters) return tr("%1   no estimate here").arg(place);
  const bool isIncomplete = !document.isFitted() && !document.isFitting();
  QString text = isIncomplete ? tr("%1   incomplete").arg(place) : place;
  for (const Parameter parameter : kParameters) {
    const QString original = valueText(parameter, parameters->original[parameter]);
    const QString edited = valueText(parameter, parameters->edited[parameter]);
    text += QString("   %1 %2").arg(parameterTitle(parameter), original);
    if (deviation) text += tr(" ± %1").arg(valueText(parameter, (*deviation)[parameter]));
    if (edited != original) text += tr(", edited %1").arg(edited);
  }
  return text;
}

}  // namespace cutis
