#pragma once

// Every number that shapes the procedural patch of skin: a close-up with all that an editor of skin
// must distinguish, at known parameters. A default-constructed recipe is the one of the sample.
//
// Places are fractions of the patch's width and height from its upper left corner; lengths are
// fractions of its shorter side, so that one recipe serves every size. Angles in degrees turn from
// the x axis towards y, which points down. Concentrations are in the units of parameter.h; where
// one is said to be relative it is a share of the skin around.

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/parameter.h"

namespace cutis {

// One complexion; between several the patch blends by distance.
struct SkinTone {
  double x = 0.5;
  double y = 0.5;
  double reach = 0.3;  // share of width and height at which its weight has fallen to an eighth
  std::array<double, kParameterCount> parameters = {0.02, 0.4, 0.015, 0.025, 0.0015};

  bool operator==(const SkinTone&) const = default;
};

// An ellipse with a soft edge: 1 at its centre, 0 from its rim.
struct SoftArea {
  double x = 0.5;
  double y = 0.5;
  double radiusX = 0.2;
  double radiusY = 0.2;
  double angle = 0.0;

  bool operator==(const SoftArea&) const = default;
};

// Variation that is correlated in space: octaves of noise, each half as large as the one before.
// Octaves too fine for the picture are left out.
struct NoiseRecipe {
  double deviation = 0.1;  // of the logarithm of a concentration, of a blend itself
  double largest = 0.1;    // size of the largest blotches
  int octaves = 8;
  double gain = 0.8;  // amplitude of an octave over that of the one before

  bool operator==(const NoiseRecipe&) const = default;
};

// Where there is skin at all: a superellipse around the centre, its outline slightly irregular.
struct SilhouetteRecipe {
  double radiusX = 0.485;  // share of the width
  double radiusY = 0.49;   // share of the height
  double exponent = 3.2;   // 2 is an ellipse; more is squarer
  double wobble = 0.007;   // relative deviation of the radius

  bool operator==(const SilhouetteRecipe&) const = default;
};

// More blood in both layers, uneven as blushing is.
struct FlushRecipe {
  SoftArea area;
  double dermal = 0.03;  // haemoglobin added at the centre
  double epidermal = 0.02;
  double blotches = 0.35;  // relative deviation of what is added

  bool operator==(const FlushRecipe&) const = default;
};

struct CaroteneRecipe {
  SoftArea area;
  double carotene = 0.006;  // added at the centre, g/L

  bool operator==(const CaroteneRecipe&) const = default;
};

// A vessel that wanders, tapers and branches. Dermal blood alone looks bluish, epidermal red.
struct VeinRecipe {
  double x = 0.5;  // where it comes up
  double y = 0.5;
  double angle = 0.0;
  double length = 0.3;
  double width = 0.01;
  double dermal = 0.26;  // haemoglobin added along its axis
  double epidermal = 0.0;
  double wander = 1.0;        // how much it winds; 0 is straight
  double branchEvery = 0.07;  // mean distance between branches

  bool operator==(const VeinRecipe&) const = default;
};

// Small brown spots, denser towards the centres of the areas.
struct FreckleRecipe {
  std::vector<SoftArea> areas;
  double spacing = 0.014;  // of the grid that may hold one spot per cell
  double chance = 0.7;     // that a cell at the centre of an area does
  double scatter = 0.01;   // that a cell anywhere does
  double radius = 0.0034;  // median
  double spread = 0.4;     // deviation of the radius' logarithm
  double strength = 2.0;   // melanin added by the strongest, relative
  double blend = 0.12;     // of that melanin

  bool operator==(const FreckleRecipe&) const = default;
};

struct MoleRecipe {
  double x = 0.5;
  double y = 0.5;
  double radius = 0.01;
  double melanin = 0.15;  // at the centre
  double blend = 0.8;

  bool operator==(const MoleRecipe&) const = default;
};

// Openings of follicles: dots a little darker and redder than the skin around.
struct PoreRecipe {
  double spacing = 0.0105;  // of the grid that holds one pore per cell
  double radius = 0.0021;
  double melanin = 0.35;     // added by the deepest, relative
  double dermal = 0.8;       // added, relative
  double epidermal = 0.016;  // added

  bool operator==(const PoreRecipe&) const = default;
};

// Fine lines between the fields of the skin's relief.
struct FurrowRecipe {
  double size = 0.011;      // of the fields
  double melanin = 0.18;    // added in the lines, relative
  double epidermal = 0.15;  // added in the lines, relative

  bool operator==(const FurrowRecipe&) const = default;
};

struct LipsRecipe {
  double x = 0.57;
  double y = 0.67;
  double angle = -4.0;
  double halfWidth = 0.19;
  double upper = 0.31;      // height of the upper lip over halfWidth
  double lower = 0.44;      // height of the lower lip over halfWidth
  double softness = 0.006;  // of the border
  double lines = 0.22;      // depth of the vertical lines: logarithm of blood and melanin
  std::array<double, kParameterCount> parameters = {0.016, 0.35, 0.09, 0.085, 0.001};

  bool operator==(const LipsRecipe&) const = default;
};

// Short dark hairs, and the shade of those still below the surface.
struct StubbleRecipe {
  std::vector<SoftArea> areas;
  double spacing = 0.0075;  // of the grid that may hold one hair per cell
  double chance = 0.9;      // that a cell at the centre of an area does
  double length = 0.0075;   // mean
  double width = 0.0009;    // mean, at the root
  double angle = 80.0;      // of growth
  double spread = 22.0;     // deviation of the angle, degrees
  double melanin = 0.38;    // of a hair
  double blend = 0.97;
  double shade = 0.007;  // melanin added around the hairs

  bool operator==(const StubbleRecipe&) const = default;
};

struct SkinRecipe {
  SkinRecipe();

  SilhouetteRecipe silhouette;
  std::vector<SkinTone> tones;
  double warp = 0.05;  // how far borders of tones and areas stray from their shapes
  std::array<NoiseRecipe, kParameterCount> noise;  // indexed by Parameter
  std::vector<FlushRecipe> flushes;
  CaroteneRecipe carotene;
  std::vector<VeinRecipe> veins;
  FreckleRecipe freckles;
  std::vector<MoleRecipe> moles;
  PoreRecipe pores;
  FurrowRecipe furrows;
  LipsRecipe lips;
  StubbleRecipe stubble;

  bool operator==(const SkinRecipe&) const = default;
};

// Checks that there is a tone, that numbers are finite and within what can be painted in bounded
// time. `place` names the source in the error, which names the field as it stands in recipe.json.
Status validate(const SkinRecipe& recipe, const std::string& place);

}  // namespace cutis
