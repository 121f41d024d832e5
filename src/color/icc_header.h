#pragma once  // internal to src/color

// The header that every ICC profile begins with (ICC.1:2022, section 7.2).

#include <cstddef>

namespace cutis {

inline constexpr std::size_t kIccHeaderBytes = 128;

}  // namespace cutis
