# SPDX-License-Identifier: GPL-3.0-or-later
# Every command that a document shows is run again, and its output compared.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3 AND TARGET shortfall)
  set(documents README.md)
  foreach(name index frames linear tableau audit clock lessons order modified floats engines mathematics how-we-know output)
    list(APPEND documents docs/${name}.md)
  endforeach()
  foreach(name my-jump-is-too-low jump-height-and-frame-rate damping-at-30-hz which-integrator is-float-enough teach-it)
    list(APPEND documents docs/tutorial/${name}.md)
  endforeach()
  list(TRANSFORM documents PREPEND "${PROJECT_SOURCE_DIR}/")
  add_test(NAME docs_commands
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/run_blocks.py" $<TARGET_FILE:shortfall> ${documents})
  # The reference of the command is what the command says of itself.
  add_test(NAME docs_reference
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/make_commands.py" --check $<TARGET_FILE:shortfall>
      "${PROJECT_SOURCE_DIR}/docs/commands.md")
  add_test(NAME docs_architecture
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/make_architecture.py" --check "${PROJECT_SOURCE_DIR}"
      "${PROJECT_SOURCE_DIR}/docs/images/architecture.svg")
  set_tests_properties(docs_commands docs_reference docs_architecture PROPERTIES LABELS docs)
endif()
