#pragma once

// Places in the picture that are kept: each has a letter that stands beside its marker and its
// curve, and perhaps a name.
//
// Plain data and pure functions.

#include <array>
#include <string>
#include <vector>

namespace cutis {

struct Pin {
  std::string letter;  // "A" to "Z"
  std::string name;    // "cheek"; may be empty
  int x = 0, y = 0;    // pixel of the picture

  bool operator==(const Pin&) const = default;
};

// Sides of the squares of pixels whose mean a pin shows.
inline constexpr std::array kPinSizes = {1, 3, 5, 11};

struct PinSet {
  std::vector<Pin> pins;  // in the order in which they were set; letters differ
  int size = kPinSizes.front();
  std::string reference;  // the letter of the pin that colours are compared with; empty: none

  bool operator==(const PinSet&) const = default;
};

inline constexpr int kMostPins = 26;

// From 0, for colours. Precondition: a letter of a pin.
inline int pinNumber(const std::string& letter) {
  return letter.front() - 'A';
}

// The first that no pin has; empty where all are taken.
std::string freeLetter(const PinSet& set);
// The position of a pin in the list; the number of pins if there is none of that letter.
std::size_t pinIndex(const PinSet& set, const std::string& letter);

}  // namespace cutis
