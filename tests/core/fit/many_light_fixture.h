#pragma once

// A capture under many narrow lights, and people whose constants differ from the profile's.

#include <memory>
#include <string>
#include <vector>

#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/free_constants.h"
#include "tests/core/fit/fit_fixture.h"

namespace cutis::test {

// "li2024" or "skin2026", made once.
std::shared_ptr<const SkinModel> profileModel(const std::string& name);

// Eight light-emitting diodes from 405 to 940 nm, 16 nm wide, in front of a colour camera that sees
// all of them: 24 channels.
Rig manyLightRig();

struct Person {
  ParameterVector parameters;
  SkinConstants constants;
};

// Parameters of the profile's prior; oxygenation from 0.4 to 0.95 and thickness within 40 % of the
// profile's, or above what diffusion can describe, as far as they are free.
std::vector<Person> crowd(const SkinModel& model, const FreeConstants& free, int count);

// Photographs by a model that is made for each person's constants.
PixelSet photographCrowd(const SkinModel& model, const Rig& rig, const std::vector<Person>& people,
                         double noise);

}  // namespace cutis::test
