# cutis_join_sources(TARGET SOURCES...)
#
# With CUTIS_JOIN_SOURCES several files are compiled as one: what they include is read and compiled
# once for all of them, which is most of the work. Names in anonymous namespaces must therefore
# differ within a library. A file compiled for several instruction sets includes itself again and
# stays alone.
function(cutis_join_sources target)
  if(NOT CUTIS_JOIN_SOURCES)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Takes every file that is included for a header, in which it warns of anonymous namespaces.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    if(NOT EXISTS "${path}")
      continue()
    endif()
    file(STRINGS "${path}" vectorised REGEX "^#include <hwy/foreach_target.h>" LIMIT_COUNT 1)
    if(vectorised)
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# cutis_library(FOLDER SOURCES ... [USES FOLDER...] [EXTERNAL TARGET...] [PRIVATE_EXTERNAL TARGET...])
#
# One static library per folder, named after it: core/skin is cutis_core_skin. USES names the
# folders it may include; tests/architecture holds these against the drawn direction.
function(cutis_library folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;EXTERNAL;PRIVATE_EXTERNAL" ${ARGN})
  cutis_target_name(target ${folder})
  add_library(${target} STATIC ${ARG_SOURCES})
  cutis_join_sources(${target} ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE cutis_compiler ${ARG_PRIVATE_EXTERNAL})
  target_link_libraries(${target} PUBLIC ${ARG_EXTERNAL})
  foreach(used IN LISTS ARG_USES)
    cutis_target_name(used_target ${used})
    target_link_libraries(${target} PUBLIC ${used_target})
  endforeach()
  cutis_report_links(${folder} "${ARG_USES}" "${ARG_EXTERNAL};${ARG_PRIVATE_EXTERNAL}")
endfunction()

# cutis_program(NAME FOLDER SOURCES ... [USES FOLDER...] [EXTERNAL TARGET...])
function(cutis_program name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;EXTERNAL" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  cutis_join_sources(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE cutis_compiler ${ARG_EXTERNAL})
  foreach(used IN LISTS ARG_USES)
    cutis_target_name(used_target ${used})
    target_link_libraries(${name} PRIVATE ${used_target})
  endforeach()
  cutis_report_links(${folder} "${ARG_USES}" "${ARG_EXTERNAL}")
endfunction()

# cutis_module(NAME FOLDER SOURCES ... [EXTERNAL TARGET...])
#
# A part of a program that is loaded when it is first needed, from beside the program or from
# ../lib/cutis/modules (moduleSymbol() of src/files/system/platform.h).
function(cutis_module name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;EXTERNAL" ${ARGN})
  add_library(${name} MODULE ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE cutis_compiler ${ARG_EXTERNAL})
  set_target_properties(${name} PROPERTIES
    PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  cutis_report_links(${folder} "" "${ARG_EXTERNAL}")
endfunction()

function(cutis_target_name out folder)
  string(REPLACE "/" "_" name "cutis_${folder}")
  set(${out} ${name} PARENT_SCOPE)
endfunction()

function(cutis_report_links folder used external)
  list(JOIN used " " used)
  list(JOIN external " " external)
  set_property(GLOBAL APPEND PROPERTY CUTIS_LINKS "${folder}: ${used} | ${external}")
endfunction()

# Leaves "folder: used used ... | external external ..." lines for the test of the architecture.
function(cutis_write_link_report)
  get_property(links GLOBAL PROPERTY CUTIS_LINKS)
  set(text "")
  foreach(line IN LISTS links)
    string(APPEND text "${line}\n")
  endforeach()
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/links.txt" CONTENT "${text}" @ONLY)
endfunction()
