# SPDX-License-Identifier: GPL-3.0-or-later
# The catalogue against a second implementation of the language, which needs nothing but Python's standard library.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3)
  add_test(NAME independent_catalogue
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/catalogue.py" "${PROJECT_SOURCE_DIR}/integrators")
  set_tests_properties(independent_catalogue PROPERTIES LABELS independent)
else()
  message(STATUS "python3 is not installed: the test independent_catalogue is left out")
endif()
