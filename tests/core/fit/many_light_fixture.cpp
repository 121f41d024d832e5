#include "tests/core/fit/many_light_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/skin/layers/polynomial_fit.h"
#include "core/skin/layers/table.h"
#include "core/skin/profile/absorption.h"
#include "src/files/profiles/profile_file.h"

namespace cutis::test {
namespace {

Spectrum bell(double middleNm, double widthNm) {
  Spectrum curve;
  for (int i = 0; i < kSampleCount; ++i) {
    const double away = (wavelengthNm(i) - middleNm) / widthNm;
    curve[i] = std::exp2(-4.0 * away * away);
  }
  return curve;
}

// A narrow light, dark from 16 nm beside its middle.
Spectrum tent(double middleNm) {
  Spectrum curve;
  for (int i = 0; i < kSampleCount; ++i)
    curve[i] = std::max(0.0, 1.0 - std::abs(wavelengthNm(i) - middleNm) / 16.0);
  return curve;
}

// Thicknesses a crowd shares, since each costs a table.
constexpr int kThicknesses = 9;

double thicknessOf(const Profile& profile, int person) {
  const double low = profile.layerOptics == LayerOpticsKind::diffusion ? 0.92 : 0.6;
  const double share = static_cast<double>(person % kThicknesses) / (kThicknesses - 1);
  return profile.epidermalThicknessMm * (low + (1.4 - low) * share);
}

// Tables of the layers by thickness, for any oxygenation of people who are no extremes.
class Oracle {
 public:
  Oracle(const Profile& profile, const SpectrumRows& rows) : profile_(profile) {
    for (int s = 0; s < kSampleCount; ++s) {
      if ((rows.col(s) != 0.0).any()) samples_.push_back(s);
    }
  }

  Spectrum reflectance(const Person& person) {
    const Profile own = withConstants(profile_, person.constants);
    const AbsorptionLaw law(own);
    const LayerOptics& optics = opticsOf(own);
    Spectrum reflectance = Spectrum::Zero();
    for (const int s : samples_) {
      const LayerPair absorption = law.at(s, person.parameters);
      reflectance[s] = optics.reflectance(s, absorption.epidermal, absorption.dermal);
    }
    return reflectance;
  }

 private:
  const LayerOptics& opticsOf(const Profile& own) {
    auto& optics = optics_[own.epidermalThicknessMm];
    if (optics != nullptr) return *optics;
    optics = own.layerOptics == LayerOpticsKind::diffusion
                 ? makeDiffusionOptics(own)
                 : makeTabulatedOptics(
                       std::make_shared<const LayerTable>(LayerTable::make(own, samples_).value()));
    return *optics;
  }

  Profile profile_;
  std::vector<int> samples_;
  std::map<double, std::unique_ptr<const LayerOptics>> optics_;
};

}  // namespace

std::shared_ptr<const SkinModel> profileModel(const std::string& name) {
  static const auto make = [](const char* profile) {
    return SkinModel::create(loadProfile(profile, "test").value()).value();
  };
  static const std::shared_ptr<const SkinModel> own = make("li2024"), other = make("skin2026");
  return name == "li2024" ? own : other;
}

Rig manyLightRig() {
  Rig rig;
  rig.name = "diodes";
  rig.camera.name = "test";
  constexpr std::array<std::array<double, 2>, 3> curves = {
      {{620.0, 320.0}, {540.0, 300.0}, {460.0, 340.0}}};
  for (int c = 0; c < 3; ++c) {
    const auto& [middle, width] = curves[static_cast<std::size_t>(c)];
    rig.camera.sensor.sensitivity.row(c) = (bell(middle, width) + 0.05).transpose();
  }
  for (const double nm : {405.0, 450.0, 500.0, 545.0, 580.0, 630.0, 760.0, 940.0}) {
    rig.lights.push_back({std::to_string(static_cast<int>(nm)), tent(nm), {}});
  }
  return rig;
}

std::vector<Person> crowd(const SkinModel& model, const FreeConstants& free, int count) {
  const Profile& profile = model.profile();
  const auto drawn = drawFromPrior(profile.prior, profile.axes, count, 17);
  Random random(5);
  std::vector<Person> people;
  for (int i = 0; i < count; ++i) {
    Person person{drawn[static_cast<std::size_t>(i)], constantsOf(profile)};
    if (free.oxygenation) person.constants.oxygenation = random.uniform(0.4, 0.95);
    if (free.thickness) person.constants.thicknessMm = thicknessOf(profile, i);
    people.push_back(person);
  }
  return people;
}

PixelSet photographCrowd(const SkinModel& model, const Rig& rig, const std::vector<Person>& people,
                         double noise) {
  const SpectrumRows rows = responseRows(rig);
  Oracle oracle(model.profile(), rows);
  Random random(99);
  std::vector<std::vector<float>> pixels;
  for (const Person& person : people) {
    std::vector<float> pixel;
    for (const double value : rows.matrix() * oracle.reflectance(person).matrix()) {
      pixel.push_back(static_cast<float>(value * (1.0 + noise * random.normal())));
    }
    pixels.push_back(std::move(pixel));
  }
  return pixelsOf(pixels);
}

}  // namespace cutis::test
