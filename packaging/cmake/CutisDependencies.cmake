# Third-party libraries. Everything found here is permissively licensed or LGPL.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(Imath REQUIRED Imath)

# Imath's half alone, which is all headers: nothing of it is linked.
add_library(cutis_half INTERFACE)
target_include_directories(cutis_half SYSTEM INTERFACE ${Imath_INCLUDEDIR})

# From SSE4 to AVX-512; the sets left out in between gain nothing for our kernels.
add_library(cutis_simd INTERFACE)
target_link_libraries(cutis_simd INTERFACE PkgConfig::hwy)
target_compile_definitions(cutis_simd INTERFACE "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3_DL)")

add_library(cutis_eigen INTERFACE)
target_link_libraries(cutis_eigen INTERFACE Eigen3::Eigen)
# The same result for any thread count: Eigen never starts threads of its own.
target_compile_definitions(cutis_eigen INTERFACE EIGEN_DONT_PARALLELIZE)

if(NOT CUTIS_CORE_ONLY)
  # Their CMake configurations on Debian 12 do not work without extra packages; pkg-config does.
  pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
  pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
  pkg_check_modules(libjpeg REQUIRED IMPORTED_TARGET libjpeg)
  pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO)
  pkg_check_modules(lcms2 REQUIRED IMPORTED_TARGET lcms2)
  find_package(ZLIB REQUIRED)
  find_package(CLI11 2.1 REQUIRED)
endif()
find_package(nlohmann_json 3.11 REQUIRED)

set(cutis_qt_components Core Test)
if(NOT CUTIS_CORE_ONLY)
  list(APPEND cutis_qt_components Gui Widgets Svg)
endif()
find_package(Qt6 6.4 REQUIRED COMPONENTS ${cutis_qt_components})

if(CUTIS_BUILD_BENCHMARKS)
  find_package(benchmark QUIET)
endif()
