#include "src/app/project/pin.h"

#include <algorithm>

namespace cutis {

std::size_t pinIndex(const PinSet& set, const std::string& letter) {
  const auto found = std::find_if(set.pins.begin(), set.pins.end(),
                                  [&](const Pin& pin) { return pin.letter == letter; });
  return static_cast<std::size_t>(found - set.pins.begin());
}

std::string freeLetter(const PinSet& set) {
  for (int number = 0; number < kMostPins; ++number) {
    const std::string letter(1, static_cast<char>('A' + number));
    if (pinIndex(set, letter) == set.pins.size()) return letter;
  }
  return {};
}

}  // namespace cutis
