# One set of rules for all of our own code.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CUTIS_CCACHE ccache)
if(CUTIS_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CUTIS_CCACHE}")
endif()

add_library(cutis_compiler INTERFACE)
if(MSVC)
  target_compile_options(cutis_compiler INTERFACE /W4 /permissive- /utf-8)
else()
  # Products and sums are contracted only where the code says so (MulAdd): a distance computed in
  # two places then has the same bits in both.
  target_compile_options(cutis_compiler INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
    -Wcast-qual -Wformat=2 -Wundef -ffp-contract=off -fno-math-errno)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # False alarms in std::string concatenation (GCC bug 105651).
    target_compile_options(cutis_compiler INTERFACE -Wno-restrict)
  endif()
  if(CUTIS_WARNINGS_AS_ERRORS)
    target_compile_options(cutis_compiler INTERFACE -Werror)
  endif()
endif()

if(CUTIS_SANITIZE)
  target_compile_options(cutis_compiler INTERFACE
    -fsanitize=${CUTIS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(cutis_compiler INTERFACE -fsanitize=${CUTIS_SANITIZE})
endif()
