#include "ui/widgets/parameter_texts.h"

#include <string>

#include <QCoreApplication>

namespace cutis {
namespace {

// The units in the table of chromophores, so that translators find them.
[[maybe_unused]] constexpr const char* kUnits[] = {
    QT_TRANSLATE_NOOP("ParameterTexts", "volume fraction"),
    QT_TRANSLATE_NOOP("ParameterTexts", "share of eumelanin"),
    QT_TRANSLATE_NOOP("ParameterTexts", "g/L")};

QString tr(const char* text) {
  return QCoreApplication::translate("ParameterTexts", text);
}

}  // namespace

QString parameterTitle(Parameter parameter) {
  static_assert(kParameterCount == 5, "a sixth has its title here");
  switch (parameter) {
    case kMelanin:
      return tr("Melanin");
    case kMelaninBlend:
      return tr("Melanin blend");
    case kHaemoglobinDermal:
      return tr("Dermal haemoglobin");
    case kHaemoglobinEpidermal:
      return tr("Epidermal haemoglobin");
    case kCarotene:
      break;
  }
  return tr("Carotene");
}

QString parameterUnitText(Parameter parameter) {
  return tr(std::string(parameterUnit(parameter)).c_str());
}

QString haemoglobinTitle() {
  return tr("Haemoglobin");
}

}  // namespace cutis
