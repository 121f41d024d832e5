#pragma once  // internal to src/files/profiles

// Changes to the text of a profile.json that leave the rest of it as it is, order included.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/discrepancy.h"
#include "core/skin/profile/prior.h"

namespace cutis {

// Fields by their path: "epidermis.blood.oxygenation".
struct ProfileEdits {
  std::vector<std::pair<std::string, double>> numbers;
  std::string name;         // empty: as it was
  std::string description;  // empty: as it was
  std::optional<Prior> prior;
  Discrepancies discrepancies;  // none: as it was
  // Field → where its value is from, for "sources".
  std::vector<std::pair<std::string, std::string>> sources;
};

// The number a profile has in a field. An error if there is none. Precondition: parseProfile(text)
// passed.
Result<double> profileNumber(std::string_view text, const std::string& field,
                             const std::string& place);

// Preconditions: parseProfile(text) passed; profileNumber() of all fields did. The outcome need not
// be a valid profile. Numbers are written in as few digits as tell them apart.
std::string editedProfile(std::string_view text, const ProfileEdits& edits);

}  // namespace cutis
