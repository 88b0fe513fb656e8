# SPDX-License-Identifier: GPL-3.0-or-later
# One test: what is installed is enough for somebody else's project. (A library built with sanitizers would force them
# upon its user, so that stage leaves this test out.)
if(NOT SHORTFALL_SANITIZE)
  add_test(NAME consumer
    COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" "-DSOURCE=${PROJECT_SOURCE_DIR}/tests/consumer" "-DEXAMPLES=${PROJECT_SOURCE_DIR}/examples"
            "-DWORK=${CMAKE_CURRENT_BINARY_DIR}/consumer" "-DGENERATOR=${CMAKE_GENERATOR}"
            "-DCOMPILER=${CMAKE_CXX_COMPILER}" -P "${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake")
  set_tests_properties(consumer PROPERTIES LABELS consumer)
endif()
