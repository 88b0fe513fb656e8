# SPDX-License-Identifier: GPL-3.0-or-later
# Eigen is the numerical cross-check of exact eigenvalues. Without it those tests say that they were not run.
find_package(Eigen3 3.3 CONFIG QUIET)
if(TARGET Eigen3::Eigen)
  foreach(program test_stability test_stability_slow)
    if(TARGET ${program})  # the slow ones are not built under the sanitizers
      target_link_libraries(${program} PRIVATE Eigen3::Eigen)
      target_compile_definitions(${program} PRIVATE SHORTFALL_WITH_EIGEN)
    endif()
  endforeach()
else()
  message(STATUS "Eigen is missing (on Debian: libeigen3-dev): eigenvalues are not compared with it")
endif()
