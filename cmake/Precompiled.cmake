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
    # A header is used only under the options that made it.
    if(header STREQUAL precompiled_test)
      target_compile_options(${holder} PRIVATE ${SHORTFALL_TEST_OPTIMIZATION})
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${holder})
endfunction()
