#include "src/app/fit_method.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/base/echoed_text.h"
#include "src/files/io/suggestion.h"

namespace cutis {
namespace {

constexpr std::array<std::pair<const char*, FitMethod>, 4> kMethods = {
    {{"refined", FitMethod::refined},
     {"three-stage", FitMethod::threeStage},
     {"full-search", FitMethod::fullSearch},
     {"network", FitMethod::network}}};

}  // namespace

std::string fitMethodName(FitMethod method) {
  return std::find_if(kMethods.begin(), kMethods.end(),
                      [method](const auto& known) { return known.second == method; })
      ->first;
}

Result<FitMethod> fitMethodNamed(const std::string& name, const std::string& place) {
  std::vector<std::string> known;
  for (const auto& [knownName, method] : kMethods) {
    if (name == knownName) return method;
    known.emplace_back(knownName);
  }
  return usageError(place, "unknown method " + inQuotes(name) + "; " + suggestName(name, known));
}

}  // namespace cutis
