#pragma once

// Help for a name that nobody knows: what it may have been meant to be.

#include <string>
#include <vector>

namespace cutis {

// The way out of an unknown name: "did you mean 'D65'?" if one is close, else "known: A, D50, …".
std::string suggestName(const std::string& wrong, const std::vector<std::string>& known);

}  // namespace cutis
