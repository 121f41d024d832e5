#pragma once

// recipe.json: a procedural patch of skin. The built-in resources/sample/recipe.json shows all
// fields. One that is left out keeps the sample's value; a list replaces the sample's, and a field
// left out in an entry of it has the default of core/simulate/paint/skin_recipe.h.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/simulate/paint/skin_recipe.h"

namespace cutis {

inline constexpr char kSampleRecipe[] = "sample";

struct RecipeFile {
  SkinRecipe skin;
  // What simulateSkin() takes besides, unless the user asks for something else.
  int width = 1024;
  int height = 1024;
  std::uint64_t seed = 1;
};

// "sample" or a path to a file. Checked with validate(). `place` stands in front of an error about
// the name itself.
Result<RecipeFile> loadRecipe(const std::string& nameOrPath, const std::string& place);
Result<RecipeFile> parseRecipe(std::string_view text, const std::string& place);

}  // namespace cutis
