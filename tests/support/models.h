#pragma once

// Profiles and rigs for tests, loaded once.

#include "core/rig/rig.h"
#include "core/skin/skin_model.h"

namespace cutis::test {

const SkinModel& li2024();
const Rig& monitorRig();
const Rig& albedoRig();

}  // namespace cutis::test
