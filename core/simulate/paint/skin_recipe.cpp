#include "core/simulate/paint/skin_recipe.h"

#include <charconv>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

namespace cutis {
namespace {

constexpr std::size_t kLongestList = 64;

struct Bounds {
  const char* name;
  double value;
  double from;
  double to;
};

// Both ends are allowed.
constexpr double kPlaceFrom = -1.0;
constexpr double kPlaceTo = 2.0;
constexpr double kSmallest = 0.001;

std::string shortest(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc() ? std::string(text, end) : std::string();
}

// Keeps the first error.
class Checker {
 public:
  explicit Checker(std::string place) : place_(std::move(place)) {}

  void fields(const std::string& group, std::initializer_list<Bounds> fields) {
    for (const Bounds& field : fields) {
      // NaN fails both comparisons.
      if (field.value >= field.from && field.value <= field.to) continue;
      refuse("skin." + group + field.name + " must be between " + shortest(field.from) + " and " +
             shortest(field.to));
    }
  }
  void parameters(const std::string& group, const std::array<double, kParameterCount>& values) {
    for (const Parameter parameter : kParameters) {
      const std::string name(parameterName(parameter));
      fields(group, {{name.c_str(), values[static_cast<std::size_t>(parameter)], 0.0, 1.0}});
    }
  }
  void area(const std::string& group, const SoftArea& area) {
    fields(group, {{"x", area.x, kPlaceFrom, kPlaceTo},
                   {"y", area.y, kPlaceFrom, kPlaceTo},
                   {"radius_x", area.radiusX, kSmallest, 10.0},
                   {"radius_y", area.radiusY, kSmallest, 10.0},
                   {"angle", area.angle, -360.0, 360.0}});
  }
  template <typename Item, typename Check>
  void list(const std::string& name, const std::vector<Item>& items, Check check) {
    if (items.size() > kLongestList) {
      refuse("skin." + name + " has " + std::to_string(items.size()) + " entries; at most " +
             std::to_string(kLongestList) + " are allowed");
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
      check(name + "[" + std::to_string(i) + "].", items[i]);
    }
  }
  void refuse(const std::string& sentence) {
    if (!error_) error_ = inputError(place_, sentence);
  }
  Status status() const {
    if (error_) return *error_;
    return {};
  }

 private:
  std::string place_;
  std::optional<Error> error_;
};

void checkComplexion(const SkinRecipe& recipe, Checker& checker) {
  const SilhouetteRecipe& shape = recipe.silhouette;
  checker.fields("silhouette.", {{"radius_x", shape.radiusX, 0.01, 10.0},
                                 {"radius_y", shape.radiusY, 0.01, 10.0},
                                 {"exponent", shape.exponent, 0.5, 50.0},
                                 {"wobble", shape.wobble, 0.0, 1.0}});
  if (recipe.tones.empty()) checker.refuse("skin.tones is empty; give at least one");
  checker.list("tones", recipe.tones, [&](const std::string& group, const SkinTone& tone) {
    checker.fields(group, {{"x", tone.x, kPlaceFrom, kPlaceTo},
                           {"y", tone.y, kPlaceFrom, kPlaceTo},
                           {"reach", tone.reach, 0.01, 10.0}});
    checker.parameters(group + "parameters.", tone.parameters);
  });
  checker.fields("", {{"warp", recipe.warp, 0.0, 1.0}});
  for (const Parameter parameter : kParameters) {
    const NoiseRecipe& noise = recipe.noise[static_cast<std::size_t>(parameter)];
    checker.fields("noise." + std::string(parameterName(parameter)) + ".",
                   {{"deviation", noise.deviation, 0.0, 2.0},
                    {"largest", noise.largest, kSmallest, 10.0},
                    {"octaves", static_cast<double>(noise.octaves), 1.0, 16.0},
                    {"gain", noise.gain, 0.01, 1.0}});
  }
  const FurrowRecipe& furrows = recipe.furrows;
  checker.fields("furrows.", {{"size", furrows.size, kSmallest, 1.0},
                              {"melanin", furrows.melanin, 0.0, 10.0},
                              {"epidermal", furrows.epidermal, 0.0, 10.0}});
}

void checkBlood(const SkinRecipe& recipe, Checker& checker) {
  checker.list("flushes", recipe.flushes, [&](const std::string& group, const FlushRecipe& flush) {
    checker.area(group + "area.", flush.area);
    checker.fields(group, {{"dermal", flush.dermal, 0.0, 1.0},
                           {"epidermal", flush.epidermal, 0.0, 1.0},
                           {"blotches", flush.blotches, 0.0, 2.0}});
  });
  checker.area("carotene.area.", recipe.carotene.area);
  checker.fields("carotene.", {{"carotene", recipe.carotene.carotene, 0.0, 1.0}});
  checker.list("veins", recipe.veins, [&](const std::string& group, const VeinRecipe& vein) {
    checker.fields(group, {{"x", vein.x, kPlaceFrom, kPlaceTo},
                           {"y", vein.y, kPlaceFrom, kPlaceTo},
                           {"angle", vein.angle, -360.0, 360.0},
                           {"length", vein.length, 0.0, 1.0},
                           {"width", vein.width, 0.0, 0.2},
                           {"dermal", vein.dermal, 0.0, 1.0},
                           {"epidermal", vein.epidermal, 0.0, 1.0},
                           {"wander", vein.wander, 0.0, 5.0},
                           {"branch_every", vein.branchEvery, 0.01, 10.0}});
  });
  const LipsRecipe& lips = recipe.lips;
  checker.fields("lips.", {{"x", lips.x, kPlaceFrom, kPlaceTo},
                           {"y", lips.y, kPlaceFrom, kPlaceTo},
                           {"angle", lips.angle, -360.0, 360.0},
                           {"half_width", lips.halfWidth, kSmallest, 2.0},
                           {"upper", lips.upper, 0.0, 1.0},
                           {"lower", lips.lower, 0.0, 1.0},
                           {"softness", lips.softness, 0.0, 0.2},
                           {"lines", lips.lines, 0.0, 2.0}});
  checker.parameters("lips.parameters.", lips.parameters);
}

void checkSpots(const SkinRecipe& recipe, Checker& checker) {
  const FreckleRecipe& freckles = recipe.freckles;
  checker.list("freckles.areas", freckles.areas,
               [&](const std::string& group, const SoftArea& area) { checker.area(group, area); });
  checker.fields("freckles.", {{"spacing", freckles.spacing, 0.002, 1.0},
                               {"chance", freckles.chance, 0.0, 1.0},
                               {"scatter", freckles.scatter, 0.0, 1.0},
                               {"radius", freckles.radius, 0.0, 0.05},
                               {"spread", freckles.spread, 0.0, 2.0},
                               {"strength", freckles.strength, 0.0, 20.0},
                               {"blend", freckles.blend, 0.0, 1.0}});
  checker.list("moles", recipe.moles, [&](const std::string& group, const MoleRecipe& mole) {
    checker.fields(group, {{"x", mole.x, kPlaceFrom, kPlaceTo},
                           {"y", mole.y, kPlaceFrom, kPlaceTo},
                           {"radius", mole.radius, 0.0, 0.5},
                           {"melanin", mole.melanin, 0.0, 1.0},
                           {"blend", mole.blend, 0.0, 1.0}});
  });
  const PoreRecipe& pores = recipe.pores;
  checker.fields("pores.", {{"spacing", pores.spacing, 0.002, 1.0},
                            {"radius", pores.radius, 0.0, 0.05},
                            {"melanin", pores.melanin, 0.0, 10.0},
                            {"dermal", pores.dermal, 0.0, 10.0},
                            {"epidermal", pores.epidermal, 0.0, 1.0}});
  const StubbleRecipe& stubble = recipe.stubble;
  checker.list("stubble.areas", stubble.areas,
               [&](const std::string& group, const SoftArea& area) { checker.area(group, area); });
  checker.fields("stubble.", {{"spacing", stubble.spacing, 0.002, 1.0},
                              {"chance", stubble.chance, 0.0, 1.0},
                              {"length", stubble.length, 0.0, 0.1},
                              {"width", stubble.width, 0.0, 0.05},
                              {"angle", stubble.angle, -360.0, 360.0},
                              {"spread", stubble.spread, 0.0, 360.0},
                              {"melanin", stubble.melanin, 0.0, 1.0},
                              {"blend", stubble.blend, 0.0, 1.0},
                              {"shade", stubble.shade, 0.0, 1.0}});
}

}  // namespace

SkinRecipe::SkinRecipe() {
  // The tones go from the light upper left to the dark lower right.
  tones = {
      {0.08, 0.10, 0.32, {0.0034, 0.30, 0.010, 0.012, 0.0010}},
      {0.38, 0.28, 0.32, {0.0075, 0.30, 0.014, 0.021, 0.0014}},
      {0.18, 0.78, 0.30, {0.0190, 0.33, 0.018, 0.027, 0.0018}},
      {0.80, 0.22, 0.30, {0.0270, 0.35, 0.018, 0.032, 0.0018}},
      {0.66, 0.84, 0.28, {0.0550, 0.40, 0.020, 0.038, 0.0018}},
      {0.97, 0.70, 0.30, {0.1500, 0.42, 0.022, 0.050, 0.0018}},
  };
  noise = {{
      {0.13, 0.10, 8, 0.78},
      {0.07, 0.20, 6, 0.70},
      {0.36, 0.09, 8, 0.78},
      {0.21, 0.06, 8, 0.86},
      {0.20, 0.20, 6, 0.70},
  }};
  // A cheek, and beside the nose.
  flushes = {
      {{0.27, 0.50, 0.24, 0.19, -20.0}, 0.05, 0.035, 0.35},
      {{0.68, 0.47, 0.11, 0.10, 0.0}, 0.03, 0.020, 0.35},
  };
  carotene.area = {0.46, 0.13, 0.26, 0.15, 10.0};
  // Two deep ones on the forehead, three fine red ones on the cheek.
  veins = {
      {0.58, 0.07, 62.0, 0.36, 0.0110, 0.26, 0.00, 0.8, 0.07},
      {0.84, 0.14, 115.0, 0.24, 0.0090, 0.26, 0.00, 1.0, 0.08},
      {0.20, 0.58, -60.0, 0.12, 0.0030, 0.10, 0.05, 1.6, 0.02},
      {0.33, 0.56, -30.0, 0.10, 0.0026, 0.10, 0.05, 1.6, 0.02},
      {0.28, 0.44, 160.0, 0.09, 0.0024, 0.10, 0.05, 1.6, 0.02},
  };
  freckles.areas = {{0.42, 0.36, 0.36, 0.19, -12.0}, {0.14, 0.40, 0.16, 0.22, 0.0}};
  moles = {
      {0.145, 0.665, 0.0100, 0.10, 0.55},
      {0.475, 0.180, 0.0075, 0.08, 0.50},
      {0.845, 0.435, 0.0120, 0.20, 0.85},
      {0.420, 0.545, 0.0050, 0.09, 0.55},
  };
  // The chin, and above the mouth.
  stubble.areas = {{0.50, 0.87, 0.48, 0.24, -8.0}, {0.57, 0.60, 0.27, 0.095, -2.0}};
}

Status validate(const SkinRecipe& recipe, const std::string& place) {
  Checker checker(place);
  checkComplexion(recipe, checker);
  checkBlood(recipe, checker);
  checkSpots(recipe, checker);
  return checker.status();
}

}  // namespace cutis
