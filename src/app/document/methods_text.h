#pragma once

// How the maps of a document came about, in the words of a paper: a paragraph for its section on
// methods, and a line for the caption of a figure. In English, whatever the user's language.
//
// Pure functions.

#include <string>

#include "src/app/document/scene.h"
#include "src/app/open/fit_choice.h"

namespace cutis {

// version: of the program. Names profile, rig, lights, noise, prior, method and version, and cites
// the paper of the model.
std::string methodsText(const Scene& scene, const FitChoice& choice, const std::string& version);
// "Profile skin2026 · rig monitor (white, white+blue) · noise 0.0001 + 0.5 % · …"
std::string captionText(const Scene& scene, const FitChoice& choice, const std::string& version);

}  // namespace cutis
