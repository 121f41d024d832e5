#include "src/bench/subject.h"

#include <cstdint>
#include <string>

#include "core/fit/population.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

constexpr std::uint64_t kPeopleSeed = 1;

}  // namespace

Status checkHoldsProtocol(const Profile& profile) {
  const ParameterBox box = protocolPopulation();
  for (const Parameter parameter : kParameters) {
    if (box.high[parameter] > profile.axes[static_cast<std::size_t>(parameter)].maximum) {
      return inputError(profile.name, "the range of " + std::string(parameterName(parameter)) +
                                          " does not hold the population of the error protocol; "
                                          "use another profile");
    }
  }
  return {};
}

Result<std::shared_ptr<const ErrorMeter>> protocolMeter(const SkinModel& model) {
  CUTIS_TRY(d65, loadLight({"D65", {}, {}}));
  CUTIS_TRY(a, loadLight({"A", {}, {}}));
  CUTIS_TRY(observer, loadCamera({"cie1931", {}, {}}));
  return std::make_shared<const ErrorMeter>(model, d65, a, observer.sensor);
}

std::vector<ParameterVector> benchPeople(std::size_t count) {
  return drawPopulation(protocolPopulation(), static_cast<int>(count), kPeopleSeed);
}

}  // namespace cutis
