#include "src/app/project/pins_json.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace cutis {
namespace {

// Larger numbers are no pixels.
constexpr double kFarthest = 1e6;

Result<Pin> parsePin(const JsonValue& object, const PinSet& before, const Notice& notice) {
  CUTIS_TRY(letter, object.text("letter"));
  CUTIS_TRY(name, object.text("name", std::string()));
  CUTIS_TRY(list, object.list("place"));
  CUTIS_TRY(place, list.asNumbers(2));
  object.sayUnknown({"letter", "name", "place"}, notice);
  const bool isLetter = letter.size() == 1 && letter[0] >= 'A' && letter[0] <= 'Z';
  if (!isLetter || pinIndex(before, letter) < before.pins.size())
    return object.error("letter", "a letter from \"A\" to \"Z\" that no other pin has");
  for (const double coordinate : place) {
    if (!(std::abs(coordinate) <= kFarthest)) return object.error("place", "x and y in pixels");
  }
  return Pin{letter, name, static_cast<int>(std::lround(place[0])),
             static_cast<int>(std::lround(place[1]))};
}

}  // namespace

void addPinsTo(nlohmann::ordered_json& root, const PinSet& set) {
  if (!set.pins.empty()) {
    auto& list = root[kPins] = nlohmann::ordered_json::array();
    for (const Pin& pin : set.pins) {
      nlohmann::ordered_json object;
      object["letter"] = pin.letter;
      if (!pin.name.empty()) object["name"] = pin.name;
      object["place"] = {pin.x, pin.y};
      list.push_back(std::move(object));
    }
  }
  if (set.size != kPinSizes.front()) root[kPinSize] = set.size;
  if (!set.reference.empty()) root[kPinReference] = set.reference;
}

Result<PinSet> parsePins(const JsonValue& root, const Notice& notice) {
  PinSet set;
  if (root.has(kPins)) {
    CUTIS_TRY(objects, root.array(kPins));
    for (const JsonValue& object : objects) {
      if (!object.isObject()) return root.error(kPins, "a list of pins");
      CUTIS_TRY(pin, parsePin(object, set, notice));
      set.pins.push_back(pin);
    }
  }
  if (root.has(kPinSize)) {
    CUTIS_TRY(size, root.integer(kPinSize));
    if (std::find(kPinSizes.begin(), kPinSizes.end(), size) == kPinSizes.end())
      return root.error(kPinSize, "1, 3, 5 or 11");
    set.size = size;
  }
  CUTIS_TRY(reference, root.text(kPinReference, std::string()));
  // One that is not there compares with nothing.
  if (pinIndex(set, reference) < set.pins.size()) set.reference = reference;
  return set;
}

}  // namespace cutis
