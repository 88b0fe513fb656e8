# SPDX-License-Identifier: GPL-3.0-or-later
# The catalogue against a second implementation of the language, which needs nothing but Python's standard library.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3)
  add_test(NAME independent_catalogue
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/catalogue.py" "${PROJECT_SOURCE_DIR}/integrators")
  # Its steps of a damped, driven spring are what tests/data holds.
  add_test(NAME independent_spring_steps
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/spring_steps.py" "${PROJECT_SOURCE_DIR}/integrators"
      "${PROJECT_SOURCE_DIR}/tests/data/spring_steps.txt")
  # The order conditions of the bank of published methods, from the textbook.
  add_test(NAME independent_order_conditions
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/order_conditions.py" "${PROJECT_SOURCE_DIR}/tests/data/methods")
  # The planted misprints are wrong as they stand and right with their mends.
  add_test(NAME independent_misprints
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/misprints.py" "${PROJECT_SOURCE_DIR}/tests/data/misprints")
  # What the command answers about the catalogue.
  if(TARGET shortfall)
    add_test(NAME independent_answers
      COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/answers.py" $<TARGET_FILE:shortfall> "${PROJECT_SOURCE_DIR}/integrators")
    # Hundreds of commands: not under the sanitizers, whose other tests run the same code.
    set_tests_properties(independent_answers PROPERTIES LABELS "independent;slow")
  endif()
  set_tests_properties(independent_catalogue independent_spring_steps independent_order_conditions independent_misprints PROPERTIES LABELS independent)
else()
  message(STATUS "python3 is not installed: the tests of tests/independent are left out")
endif()
