# SPDX-License-Identifier: GPL-3.0-or-later
# Every command that a document shows is run again, and its output compared.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3 AND TARGET shortfall)
  file(GLOB_RECURSE documents CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/*.md")
  list(APPEND documents "${PROJECT_SOURCE_DIR}/README.md")
  add_test(NAME docs_commands
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/run_blocks.py" $<TARGET_FILE:shortfall> ${documents})
  # The C++ of documents compiles.
  add_test(NAME docs_cpp
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/compile_blocks.py" "${CMAKE_CXX_COMPILER}" "${PROJECT_SOURCE_DIR}"
      "${PROJECT_BINARY_DIR}/native" ${documents})
  # The reference of the command is what the command says of itself.
  add_test(NAME docs_reference
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/make_commands.py" --check $<TARGET_FILE:shortfall>
      "${PROJECT_SOURCE_DIR}/docs/commands.md")
  add_test(NAME docs_architecture
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/make_architecture.py" --check "${PROJECT_SOURCE_DIR}"
      "${PROJECT_SOURCE_DIR}/docs/images/architecture.svg")
  set_tests_properties(docs_commands docs_cpp docs_reference docs_architecture PROPERTIES LABELS docs)
  # Hundreds of commands: not under the sanitizers, whose other tests run the same code.
  set_tests_properties(docs_commands PROPERTIES LABELS "docs;slow")
endif()
