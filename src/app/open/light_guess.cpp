#include "src/app/open/light_guess.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

namespace cutis {
namespace {

using Chromaticity = Eigen::Vector2d;  // log R/G and log B/G

// Photographs that were each divided by their own light's white differ less than this.
constexpr double kDifferentLights = 0.1;

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// "03_WhiteBlue" → {"white", "blue"}.
std::set<std::string> wordsOf(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    const bool letter = k < text.size() && isLetter(text[k]);
    const bool camel = letter && k > 0 && std::isupper(static_cast<unsigned char>(text[k])) != 0 &&
                       std::islower(static_cast<unsigned char>(text[k - 1])) != 0;
    if ((!letter || camel) && !word.empty()) {
      words.insert(word);
      word.clear();
    }
    if (letter) word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[k])));
  }
  return words;
}

bool mentions(const std::set<std::string>& words, const std::string& word) {
  return words.contains(word) || words.contains(word.substr(0, 1));
}

// The light with the most words among those whose words all stand in the name; -1 if none or more
// than one.
int lightByName(const std::string& name, const Rig& rig) {
  const std::set<std::string> words = wordsOf(name);
  int best = -1;
  std::size_t mostWords = 0;
  bool unique = false;
  for (std::size_t k = 0; k < rig.lights.size(); ++k) {
    const std::set<std::string> wanted = wordsOf(rig.lights[k].name);
    const bool all =
        !wanted.empty() && std::all_of(wanted.begin(), wanted.end(),
                                       [&](const auto& word) { return mentions(words, word); });
    if (!all || wanted.size() < mostWords) continue;
    unique = wanted.size() > mostWords;
    mostWords = wanted.size();
    best = static_cast<int>(k);
  }
  return unique ? best : -1;
}

void guessByName(const std::vector<PhotographClues>& photographs, const Rig& rig,
                 std::vector<LightGuess>& guesses) {
  std::vector<int> named;
  for (const PhotographClues& photograph : photographs)
    named.push_back(lightByName(photograph.name, rig));
  for (std::size_t i = 0; i < named.size(); ++i) {
    // Two photographs of one name tell nothing.
    if (named[i] >= 0 && std::count(named.begin(), named.end(), named[i]) == 1) {
      guesses[i] = {named[i], LightClue::name};
    }
  }
}

Chromaticity chromaticity(const Eigen::Vector3d& color) {
  return {std::log(color[0] / color[1]), std::log(color[2] / color[1])};
}

// The colour of a perfect diffuser, as the camera sees it before any white balance.
Eigen::Vector3d colorOfLight(const Rig& rig, int light) {
  const Spectrum& power = rig.lights[static_cast<std::size_t>(light)].power;
  Eigen::Vector3d color;
  for (int c = 0; c < 3; ++c)
    color[c] = (rig.camera.sensor.sensitivity.row(c).transpose() * power.array()).sum();
  return color;
}

void takeMeanOff(std::vector<Chromaticity>& colors) {
  Chromaticity mean = Chromaticity::Zero();
  for (const Chromaticity& color : colors)
    mean += color / static_cast<double>(colors.size());
  for (Chromaticity& color : colors)
    color -= mean;
}

double spread(const std::vector<Chromaticity>& colors) {
  double widest = 0.0;
  for (const Chromaticity& color : colors)
    widest = std::max(widest, color.norm());
  return widest;
}

// The photographs and lights that are left.
struct Open {
  std::vector<std::size_t> photographs;
  std::vector<int> lights;
};

Open openOf(const std::vector<LightGuess>& guesses, const Rig& rig) {
  Open open;
  std::set<int> taken;
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    if (guesses[i].light < 0) open.photographs.push_back(i);
    taken.insert(guesses[i].light);
  }
  for (int k = 0; k < static_cast<int>(rig.lights.size()); ++k) {
    if (!taken.contains(k)) open.lights.push_back(k);
  }
  return open;
}

// The nearest pairs first. The camera's balance is unknown and the skin the same everywhere: both
// go with the mean. Precondition: as many photographs as lights are open.
void guessByColor(const std::vector<PhotographClues>& photographs, const Rig& rig, const Open& open,
                  std::vector<LightGuess>& guesses) {
  std::vector<Chromaticity> seen, expected;
  for (const std::size_t i : open.photographs) {
    if (!(photographs[i].color.minCoeff() > 0.0)) return;
    seen.push_back(chromaticity(photographs[i].color));
  }
  for (const int k : open.lights) {
    const Eigen::Vector3d color = colorOfLight(rig, k);
    if (!(color.minCoeff() > 0.0)) return;
    expected.push_back(chromaticity(color));
  }
  takeMeanOff(seen);
  takeMeanOff(expected);
  if (spread(seen) < kDifferentLights || spread(expected) < kDifferentLights) return;
  std::vector<bool> isTaken(open.lights.size(), false);
  for (std::size_t step = 0; step < open.photographs.size(); ++step) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t photograph = 0, light = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (guesses[open.photographs[i]].light >= 0) continue;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const double distance = (seen[i] - expected[k]).norm();
        if (isTaken[k] || !(distance < nearest)) continue;
        nearest = distance;
        photograph = i;
        light = k;
      }
    }
    isTaken[light] = true;
    guesses[open.photographs[photograph]] = {open.lights[light], LightClue::color};
  }
}

void guessByOrder(const Open& open, std::vector<LightGuess>& guesses) {
  const std::size_t count = std::min(open.photographs.size(), open.lights.size());
  for (std::size_t k = 0; k < count; ++k)
    guesses[open.photographs[k]] = {open.lights[k], LightClue::order};
}

}  // namespace

std::vector<LightGuess> guessLights(const std::vector<PhotographClues>& photographs,
                                    const Rig& rig) {
  std::vector<LightGuess> guesses(photographs.size());
  guessByName(photographs, rig, guesses);
  const Open open = openOf(guesses, rig);
  if (open.photographs.size() == 1 && open.lights.size() == 1) {
    guesses[open.photographs.front()] = {open.lights.front(), LightClue::order};
    return guesses;
  }
  if (open.photographs.size() == open.lights.size()) {
    guessByColor(photographs, rig, open, guesses);
  }
  guessByOrder(openOf(guesses, rig), guesses);
  return guesses;
}

}  // namespace cutis
