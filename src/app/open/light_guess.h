#pragma once  // internal to src/app/open

// Which photograph was taken under which light of a rig, as far as names and colours tell. A guess:
// it is shown to people before anything is made of it.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/rig/rig.h"

namespace cutis {

// What a guess rests on.
enum class LightClue { name, color, order };

struct LightGuess {
  int light = -1;  // index into the rig's lights; -1: there are more photographs than lights
  LightClue clue = LightClue::order;
};

struct PhotographClues {
  std::string name;  // of the file, without its extension
  // Mean of the three channels in linear light, in any unit; not positive where unknown.
  Eigen::Vector3d color = Eigen::Vector3d::Zero();
};

// One guess per photograph; no light is given twice. Names count first: all words of a light's name
// ("white+blue") are words of the file's name ("03_White_Blue"), or their first letters stand alone
// ("face-w-b"). The rest is matched by colour, where the photographs differ in it as lights do, and
// else in order.
std::vector<LightGuess> guessLights(const std::vector<PhotographClues>& photographs,
                                    const Rig& rig);

}  // namespace cutis
