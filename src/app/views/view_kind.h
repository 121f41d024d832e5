#pragma once

// The views of a scene, what each is made of, and which of them a scene can be shown as.
//
// Thread-safe: pure functions.

#include <optional>

#include "core/skin/profile/free_constants.h"
#include "core/skin/profile/parameter.h"
#include "src/app/document/scene.h"

namespace cutis {

enum class ViewKind {
  photograph,    // linear Rec.709
  editedAlbedo,  // linear Rec.709: what an export writes
  skin,          // under the chosen light, linear Rec.709 or a camera's channels
  melanin,       // one channel each, in the parameter's unit, with edits
  melaninBlend,
  haemoglobinDermal,
  haemoglobinEpidermal,
  carotene,
  ultraviolet,  // one channel: mean reflectance
  nearInfrared,
  band,  // one channel: reflectance at one wavelength
  // What a fit says of its values, one channel each, without edits: posterior standard deviations
  // in the parameters' units,
  melaninDeviation,
  melaninBlendDeviation,
  haemoglobinDermalDeviation,
  haemoglobinEpidermalDeviation,
  caroteneDeviation,
  residual,  // root mean square over the channels of (measured − modelled) / noise,
  shading,   // and the factor on all channels.
  // Constants that were found for each pixel, without edits.
  oxygenation,
  thickness,
  // Photographs of a capture, in the order of the rig's lights, at most kMaximumLights of them:
  // linear Rec.709 as far as the colours of the first light hold for the others.
  firstLight = 100,
};

// The parameter that it is a map of; nothing for the others.
std::optional<Parameter> parameterOf(ViewKind view);
// The parameter whose deviation it shows.
std::optional<Parameter> deviationOf(ViewKind view);
std::optional<SkinConstant> constantOf(ViewKind view);
// The photograph under a light of the rig, and the way back.
ViewKind lightView(int light);
std::optional<int> lightOf(ViewKind view);

// Whether it shows what was measured and nothing else.
bool isPhotograph(ViewKind view);
// Whether it shows what a fit says of its values (src/app/document/fit_evidence.h).
bool isJudgement(ViewKind view);
// Whether it shows light: concentrations are never averaged.
bool canBeAveraged(ViewKind view);

// Whether the scene has what the view is made of.
bool canShow(const Scene& scene, ViewKind view);

}  // namespace cutis
