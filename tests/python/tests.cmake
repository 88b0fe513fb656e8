# SPDX-License-Identifier: GPL-3.0-or-later
# The Python client with the command that was just built; needs nothing but Python's standard library.
find_program(SHORTFALL_PYTHON3 python3)
if(NOT TARGET shortfall)
  return()
endif()
set(python_tests docs tracing refusals results random_steps)
foreach(name IN LISTS python_tests)
  if(SHORTFALL_PYTHON3)
    add_test(NAME python_${name} COMMAND "${SHORTFALL_PYTHON3}" -B -W error "${CMAKE_CURRENT_LIST_DIR}/${name}.py")
  else()
    add_test(NAME python_${name} COMMAND "${CMAKE_COMMAND}" -E echo "skipped: python3 is not installed")
    set_tests_properties(python_${name} PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")
  endif()
  set_tests_properties(python_${name} PROPERTIES LABELS python TIMEOUT 300
    ENVIRONMENT "SHORTFALL=$<TARGET_FILE:shortfall>;PYTHONPATH=${PROJECT_SOURCE_DIR}/python")
endforeach()
