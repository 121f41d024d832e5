#pragma once

// Where the checkout and its build lie. Known to one translation unit alone, so that the others
// compile to the same bytes wherever the checkout is.

#include <filesystem>

namespace cutis::test {

std::filesystem::path sourceFolder();
std::filesystem::path buildFolder();

}  // namespace cutis::test
