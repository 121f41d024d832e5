#include "ui/widgets/factor_text.h"

#include <cmath>
#include <optional>

#include <QCoreApplication>
#include <QLocale>

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("FactorText", text);
}

// Either mark of decimals; a text with both is none, as one of them would separate thousands.
std::optional<double> numberIn(QString text) {
  if (text.contains('.') && text.contains(',')) return std::nullopt;
  bool isNumber = false;
  const double number = QLocale::c().toDouble(text.replace(',', '.'), &isNumber);
  return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

QString factorText(double factor) {
  const double thousandths = std::round(factor * 1000);
  const int decimals = std::fmod(thousandths, 10) == 0 ? 2 : 3;
  return QString("×%1").arg(QLocale().toString(thousandths / 1000, 'f', decimals));
}

QString limitsText(const SliderScale& scale) {
  return tr("%1 to %2 (%3 % to %4 %)")
      .arg(scale.minimum)
      .arg(scale.maximum)
      .arg(100 * scale.minimum)
      .arg(100 * scale.maximum);
}

ReadFactor readFactor(const QString& text, const SliderScale& scale) {
  QString rest = text.simplified();
  const QString typed = rest;
  for (const QChar sign : {QChar(0xd7), QChar('x'), QChar('X'), QChar('*')}) {
    if (!rest.startsWith(sign)) continue;
    rest = rest.mid(1).trimmed();
    break;
  }
  const bool isPercent = rest.endsWith('%');
  if (isPercent) rest = rest.chopped(1).trimmed();
  const std::optional<double> number = numberIn(rest);
  if (!number) {
    return {scale.neutral,
            typed.isEmpty()
                ? tr("There is no number; write one from %1, or press Esc.").arg(limitsText(scale))
                : tr("“%1” is not a number; write one from %2, or press Esc.")
                      .arg(typed, limitsText(scale))};
  }
  const double factor = isPercent ? *number / 100 : *number;
  if (factor < scale.minimum || factor > scale.maximum) {
    return {scale.neutral, tr("%1 is outside the limits; write a number from %2, or press Esc.")
                               .arg(typed, limitsText(scale))};
  }
  return {factor, {}};
}

}  // namespace cutis
