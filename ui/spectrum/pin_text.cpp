#include "ui/spectrum/pin_text.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "ui/spectrum/spectrum_text.h"

namespace cutis {
namespace {

constexpr int kPinDigits = 7;

constexpr std::array<std::pair<const char*, double SkinIndices::*>, 4> kIndices = {
    {{"ita_degrees", &SkinIndices::typologyAngle},
     {"melanin_index", &SkinIndices::melanin},
     {"erythema_index", &SkinIndices::erythema},
     {"dawson_erythema_index", &SkinIndices::dawsonErythema}}};

std::string pinNumberText(double value) {
  return std::isfinite(value) ? formatNumber(value, kPinDigits) : std::string();
}

std::vector<std::string> pinHeader(const PinSet& set) {
  std::vector<std::string> fields = {"pin", "name", "x", "y", "pixels"};
  for (const Parameter parameter : kParameters) {
    const std::string name(parameterName(parameter));
    for (const char* kind : {"", "_sd", "_edited"})
      fields.push_back(name + kind);
  }
  for (const auto& [name, index] : kIndices) {
    fields.emplace_back(name);
    fields.push_back(std::string(name) + "_edited");
  }
  fields.push_back(set.reference.empty() ? "delta_e2000" : "delta_e2000_to_" + set.reference);
  return fields;
}

std::vector<std::string> pinRow(const PinReading& reading) {
  const Pin& pin = reading.pin;
  std::vector<std::string> fields = {pin.letter, pin.name, std::to_string(pin.x),
                                     std::to_string(pin.y)};
  if (!reading.place) return fields;
  const PlaceSpectra& place = *reading.place;
  fields.push_back(std::to_string(place.pixelCount));
  for (const Parameter parameter : kParameters) {
    fields.push_back(pinNumberText(place.originalParameters[parameter]));
    fields.push_back(place.parameterDeviation
                         ? pinNumberText((*place.parameterDeviation)[parameter])
                         : std::string());
    fields.push_back(pinNumberText(place.editedParameters[parameter]));
  }
  for (const auto& [name, index] : kIndices) {
    fields.push_back(pinNumberText(reading.original.*index));
    fields.push_back(pinNumberText(reading.edited.*index));
  }
  fields.push_back(reading.difference ? pinNumberText(*reading.difference) : std::string());
  return fields;
}

}  // namespace

std::string pinsText(const std::vector<PinReading>& readings, const PinSet& set, char separator) {
  std::vector<std::string> fields = pinHeader(set);
  const std::size_t width = fields.size();
  std::string text = tableRow(fields, separator);
  for (const PinReading& reading : readings) {
    fields = pinRow(reading);
    fields.resize(width);
    text += tableRow(fields, separator);
  }
  return text;
}

}  // namespace cutis
