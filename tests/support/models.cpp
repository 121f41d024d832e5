#include "tests/support/models.h"

#include <cstdio>
#include <cstdlib>

#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "src/files/spectral_library.h"

namespace cutis::test {
namespace {

template <typename T>
T require(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.failed() ? result.error().text().c_str() : "cancelled");
    std::abort();
  }
  return std::move(result).value();
}

}  // namespace

const SkinModel& li2024() {
  static const SkinModel model(require(loadProfile("li2024", "test")));
  return model;
}

const Rig& monitorRig() {
  static const Rig rig = require(loadRig("monitor", {}, "test"));
  return rig;
}

const Rig& albedoRig() {
  static const Rig rig = require(loadRig("albedo", {}, "test"));
  return rig;
}

Spectrum light(const std::string& name) {
  return require(loadLight({name, {}, "test"}));
}

const Sensor& cie1931() {
  static const Camera observer = require(loadCamera({"cie1931", {}, "test"}));
  return observer.sensor;
}

Eigen::Vector3d daylightWhite() {
  return whitePoint(light("D65"), cie1931());
}

}  // namespace cutis::test
