# SPDX-License-Identifier: GPL-3.0-or-later
# Parse once what all files include: shortfall_precompile(<target> [<header>]) uses the precompiled form of
# cmake/<header>.hpp (default: precompiled), which is compiled when it is first asked for.
option(SHORTFALL_PRECOMPILE "Precompile the headers that all files include" ON)

function(shortfall_precompile target)
  set(header precompiled)
  if(ARGC GREATER 1)
    set(header ${ARGV1})
  endif()
  if(NOT SHORTFALL_PRECOMPILE)
    return()
  endif()
  set(holder shortfall_${header})
  if(NOT TARGET ${holder})
    set(source "${PROJECT_BINARY_DIR}/${header}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "")
    add_library(${holder} OBJECT EXCLUDE_FROM_ALL "${source}")
    target_precompile_headers(${holder} PRIVATE "${PROJECT_SOURCE_DIR}/cmake/${header}.hpp")
    target_compile_features(${holder} PUBLIC cxx_std_20)
    # The tests are compiled with -O1, and newer compilers use a header only under the options that made it.
    if(header STREQUAL precompiled_test AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
      target_compile_options(${holder} PRIVATE -O1)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${holder})
endfunction()
