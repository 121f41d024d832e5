#include "core/skin/profile/chromophore_table.h"

#include <cstddef>

#include "core/skin/profile/absorption.h"
#include "core/skin/profile/profile.h"

namespace cutis {
namespace {

constexpr auto kEpidermis = SkinLayer::epidermis;
constexpr auto kDermis = SkinLayer::dermis;

// A pigment in solid tissue, of which a layer is but the dry part; displaces tissue.
Spectrum inDryPart(const Profile& profile, SkinLayer layer, const Spectrum& pigment) {
  return (1.0 - waterIn(profile, layer)) * pigment - tissueIn(profile, layer);
}

Spectrum eumelanin(const Profile& profile) {
  return inDryPart(profile, kEpidermis, onGrid(profile.eumelanin));
}

Spectrum pheomelanin(const Profile& profile) {
  return inDryPart(profile, kEpidermis, onGrid(profile.pheomelanin));
}

Spectrum dermalBlood(const Profile& profile) {
  return inDryPart(profile, kDermis, bloodIn(profile, profile.dermalBlood));
}

Spectrum epidermalBlood(const Profile& profile) {
  return inDryPart(profile, kEpidermis, bloodIn(profile, profile.epidermalBlood));
}

// A concentration, which the water of the layer does not dilute.
Spectrum carotene(const Profile& profile) {
  const CaroteneInSkin& skin = profile.caroteneInSkin;
  return skin.scale * shiftedAndSmoothed(profile.carotene, skin.shiftNm, skin.smoothingNm) -
         tissueIn(profile, kEpidermis);
}

constexpr auto kLinear = EditLaw::linear;
constexpr auto kByIndex = EditLaw::byIndex;

}  // namespace

const std::array<Chromophore, kParameterCount>& chromophoreTable() {
  static const std::array table = {
      Chromophore{"melanin",
                  "C_m",
                  "volume fraction",
                  kEpidermis,
                  eumelanin,
                  {0.5, 51, 3},
                  kLinear,
                  PriorScale::log},
      Chromophore{"melanin_blend",
                  "β_m",
                  "share of eumelanin",
                  kEpidermis,
                  pheomelanin,
                  {1.0, 11, 1},
                  kLinear,
                  PriorScale::linear},
      Chromophore{"haemoglobin_dermal",
                  "C_hd",
                  "volume fraction",
                  kDermis,
                  dermalBlood,
                  {0.5, 51, 3},
                  kByIndex,
                  PriorScale::log},
      Chromophore{"haemoglobin_epidermal",
                  "C_he",
                  "volume fraction",
                  kEpidermis,
                  epidermalBlood,
                  {0.3, 4, 1},
                  kByIndex,
                  PriorScale::log},
      Chromophore{
          "carotene", "C_bc", "g/L", kEpidermis, carotene, {0.01, 5, 3}, kLinear, PriorScale::log}};
  static_assert(table.size() == kParameterCount, "one row for each Parameter, in its order");
  return table;
}

std::string parameterNames(const std::string& between) {
  std::string names;
  for (const Chromophore& row : chromophoreTable())
    names += (names.empty() ? "" : between) + row.name;
  return names;
}

ParameterAxes paperAxes() {
  ParameterAxes axes;
  for (std::size_t k = 0; k < axes.size(); ++k)
    axes[k] = chromophoreTable()[k].range;
  return axes;
}

}  // namespace cutis
