# SPDX-License-Identifier: GPL-3.0-or-later
# Every command that a document shows is run again, and its output compared.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3 AND TARGET shortfall)
  add_test(NAME docs_commands
    COMMAND "${SHORTFALL_PYTHON3}" "${CMAKE_CURRENT_LIST_DIR}/run_blocks.py" $<TARGET_FILE:shortfall> "${PROJECT_SOURCE_DIR}/README.md"
      "${PROJECT_SOURCE_DIR}/docs/frames.md" "${PROJECT_SOURCE_DIR}/docs/linear.md"
      "${PROJECT_SOURCE_DIR}/docs/tableau.md" "${PROJECT_SOURCE_DIR}/docs/audit.md" "${PROJECT_SOURCE_DIR}/docs/clock.md"
      "${PROJECT_SOURCE_DIR}/docs/lessons.md" "${PROJECT_SOURCE_DIR}/docs/order.md" "${PROJECT_SOURCE_DIR}/docs/modified.md")
  set_tests_properties(docs_commands PROPERTIES LABELS docs)
endif()
