#include "src/files/recipe_file.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/echoed_text.h"
#include "core/simulate/skin_patch.h"
#include "core/skin/profile/chromophore_table.h"
#include "src/files/io/json_file.h"
#include "src/files/io/text_file.h"
#include "src/files/resources.h"

namespace cutis {
namespace {

constexpr int kNewestRecipe = 1;

// A field of an object and what it sets; left alone where the object has no such field.
template <typename T>
struct Field {
  const char* name;
  T& value;
};
template <typename T>
Field<T> field(const char* name, T& value) {
  return {name, value};
}

Status parse(const JsonValue& object, SkinTone& tone);
Status parse(const JsonValue& object, SoftArea& area);
Status parse(const JsonValue& object, NoiseRecipe& noise);
Status parse(const JsonValue& object, SilhouetteRecipe& silhouette);
Status parse(const JsonValue& object, FlushRecipe& flush);
Status parse(const JsonValue& object, CaroteneRecipe& carotene);
Status parse(const JsonValue& object, VeinRecipe& vein);
Status parse(const JsonValue& object, FreckleRecipe& freckles);
Status parse(const JsonValue& object, MoleRecipe& mole);
Status parse(const JsonValue& object, PoreRecipe& pores);
Status parse(const JsonValue& object, FurrowRecipe& furrows);
Status parse(const JsonValue& object, LipsRecipe& lips);
Status parse(const JsonValue& object, StubbleRecipe& stubble);
Status parse(const JsonValue& object, SkinRecipe& skin);
template <typename T>
Status parse(const JsonValue& object, std::array<T, kParameterCount>& values);

Status read(const JsonValue& parent, const char* key, double& value) {
  CUTIS_TRY(number, parent.number(key));
  value = number;
  return {};
}

Status read(const JsonValue& parent, const char* key, int& value) {
  CUTIS_TRY(number, parent.integer(key));
  value = number;
  return {};
}

template <typename T>
Status read(const JsonValue& parent, const char* key, T& value) {
  CUTIS_TRY(object, parent.object(key));
  return parse(object, value);
}

template <typename T>
Status read(const JsonValue& parent, const char* key, std::vector<T>& values) {
  CUTIS_TRY(elements, parent.array(key));
  values.clear();
  for (const JsonValue& element : elements) {
    if (!element.isObject()) return element.error("an object { … }");
    T value;
    CUTIS_CHECK(parse(element, value));
    values.push_back(value);
  }
  return {};
}

template <typename... T>
Status readFields(const JsonValue& object, Field<T>... fields) {
  CUTIS_CHECK(object.allowOnly({fields.name...}));
  Status status;
  const auto readOne = [&](const auto& one) {
    if (status && object.has(one.name)) status = read(object, one.name, one.value);
  };
  (readOne(fields), ...);
  return status;
}

template <typename T, std::size_t... k>
Status parseRecipeParameters(const JsonValue& object, std::array<T, kParameterCount>& values,
                             std::index_sequence<k...>) {
  return readFields(object, field(chromophoreTable()[k].name.c_str(), values[k])...);
}

// One entry per parameter.
template <typename T>
Status parse(const JsonValue& object, std::array<T, kParameterCount>& values) {
  return parseRecipeParameters(object, values, std::make_index_sequence<kParameterCount>());
}

Status parse(const JsonValue& object, SkinTone& tone) {
  return readFields(object, field("x", tone.x), field("y", tone.y), field("reach", tone.reach),
                    field("parameters", tone.parameters));
}

Status parse(const JsonValue& object, SoftArea& area) {
  return readFields(object, field("x", area.x), field("y", area.y), field("radius_x", area.radiusX),
                    field("radius_y", area.radiusY), field("angle", area.angle));
}

Status parse(const JsonValue& object, NoiseRecipe& noise) {
  return readFields(object, field("deviation", noise.deviation), field("largest", noise.largest),
                    field("octaves", noise.octaves), field("gain", noise.gain));
}

Status parse(const JsonValue& object, SilhouetteRecipe& silhouette) {
  return readFields(object, field("radius_x", silhouette.radiusX),
                    field("radius_y", silhouette.radiusY), field("exponent", silhouette.exponent),
                    field("wobble", silhouette.wobble));
}

Status parse(const JsonValue& object, FlushRecipe& flush) {
  return readFields(object, field("area", flush.area), field("dermal", flush.dermal),
                    field("epidermal", flush.epidermal), field("blotches", flush.blotches));
}

Status parse(const JsonValue& object, CaroteneRecipe& carotene) {
  return readFields(object, field("area", carotene.area), field("carotene", carotene.carotene));
}

Status parse(const JsonValue& object, VeinRecipe& vein) {
  return readFields(object, field("x", vein.x), field("y", vein.y), field("angle", vein.angle),
                    field("length", vein.length), field("width", vein.width),
                    field("dermal", vein.dermal), field("epidermal", vein.epidermal),
                    field("wander", vein.wander), field("branch_every", vein.branchEvery));
}

Status parse(const JsonValue& object, FreckleRecipe& freckles) {
  return readFields(object, field("areas", freckles.areas), field("spacing", freckles.spacing),
                    field("chance", freckles.chance), field("scatter", freckles.scatter),
                    field("radius", freckles.radius), field("spread", freckles.spread),
                    field("strength", freckles.strength), field("blend", freckles.blend));
}

Status parse(const JsonValue& object, MoleRecipe& mole) {
  return readFields(object, field("x", mole.x), field("y", mole.y), field("radius", mole.radius),
                    field("melanin", mole.melanin), field("blend", mole.blend));
}

Status parse(const JsonValue& object, PoreRecipe& pores) {
  return readFields(object, field("spacing", pores.spacing), field("radius", pores.radius),
                    field("melanin", pores.melanin), field("dermal", pores.dermal),
                    field("epidermal", pores.epidermal));
}

Status parse(const JsonValue& object, FurrowRecipe& furrows) {
  return readFields(object, field("size", furrows.size), field("melanin", furrows.melanin),
                    field("epidermal", furrows.epidermal));
}

Status parse(const JsonValue& object, LipsRecipe& lips) {
  return readFields(object, field("x", lips.x), field("y", lips.y), field("angle", lips.angle),
                    field("half_width", lips.halfWidth), field("upper", lips.upper),
                    field("lower", lips.lower), field("softness", lips.softness),
                    field("lines", lips.lines), field("parameters", lips.parameters));
}

Status parse(const JsonValue& object, StubbleRecipe& stubble) {
  return readFields(object, field("areas", stubble.areas), field("spacing", stubble.spacing),
                    field("chance", stubble.chance), field("length", stubble.length),
                    field("width", stubble.width), field("angle", stubble.angle),
                    field("spread", stubble.spread), field("melanin", stubble.melanin),
                    field("blend", stubble.blend), field("shade", stubble.shade));
}

Status parse(const JsonValue& object, SkinRecipe& skin) {
  return readFields(
      object, field("silhouette", skin.silhouette), field("tones", skin.tones),
      field("warp", skin.warp), field("noise", skin.noise), field("flushes", skin.flushes),
      field("carotene", skin.carotene), field("veins", skin.veins),
      field("freckles", skin.freckles), field("moles", skin.moles), field("pores", skin.pores),
      field("furrows", skin.furrows), field("lips", skin.lips), field("stubble", skin.stubble));
}

}  // namespace

Result<RecipeFile> loadRecipe(const std::string& nameOrPath, const std::string& place) {
  if (nameOrPath == kSampleRecipe) {
    return parseRecipe(*resource("sample/recipe.json"), "built-in recipe sample");
  }
  if (nameOrPath.find('/') == std::string::npos && !nameOrPath.ends_with(".json")) {
    return inputError(place, "unknown recipe " + inQuotes(nameOrPath) +
                                 "; the built-in one is sample, or name a JSON file");
  }
  CUTIS_TRY(text, readTextFile(nameOrPath));
  return parseRecipe(text, nameOrPath);
}

Result<RecipeFile> parseRecipe(std::string_view text, const std::string& place) {
  CUTIS_TRY(root, parseJson(text, place));
  CUTIS_CHECK(checkVersion(root, "cutis_recipe", kNewestRecipe));
  CUTIS_CHECK(
      root.allowOnly({"cutis_recipe", "name", "description", "width", "height", "seed", "skin"}));
  RecipeFile recipe;
  for (const auto& [key, side] : {std::pair{"width", &recipe.width}, {"height", &recipe.height}}) {
    if (root.has(key)) CUTIS_CHECK(read(root, key, *side));
    if (*side >= 1 && *side <= kLargestPatch) continue;
    return root.error(key, "between 1 and " + std::to_string(kLargestPatch));
  }
  int seed = 1;
  if (root.has("seed")) CUTIS_CHECK(read(root, "seed", seed));
  if (seed < 0) return root.error("seed", "zero or positive");
  recipe.seed = static_cast<std::uint64_t>(seed);
  CUTIS_TRY(skin, root.object("skin"));
  CUTIS_CHECK(parse(skin, recipe.skin));
  CUTIS_CHECK(validate(recipe.skin, place));
  return recipe;
}

}  // namespace cutis
