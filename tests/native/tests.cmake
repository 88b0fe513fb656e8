# SPDX-License-Identifier: GPL-3.0-or-later
foreach(program test_native test_native_slow)
  if(TARGET ${program})
    target_link_libraries(${program} PRIVATE shortfall::native quadmath MPFR::MPFR GMP::GMP Boost::headers)
  endif()
endforeach()
# The whole catalogue in eight number types; what is compared is bits, not speed.
set_source_files_properties(native/small_formats_slow.cpp native/wide_formats_slow.cpp native/hardware_formats_slow.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # long enough by themselves
# Compilers may break floating point where they optimise, so there the bits are looked at.
set_source_files_properties(native/hardware_formats_slow.cpp PROPERTIES COMPILE_OPTIONS -O2 SKIP_PRECOMPILE_HEADERS ON)
get_target_property(native_definitions shortfall_native COMPILE_DEFINITIONS)
if("SHORTFALL_AVX2" IN_LIST native_definitions)
  add_test(NAME native_shared_functions
           COMMAND "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DLIBRARY=$<TARGET_FILE:shortfall_native>"
                   -P "${CMAKE_CURRENT_LIST_DIR}/shared_functions.cmake")
  set_tests_properties(native_shared_functions PROPERTIES LABELS native)
endif()
