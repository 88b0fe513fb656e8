# SPDX-License-Identifier: GPL-3.0-or-later
if(SHORTFALL_MPI)
  target_compile_definitions(test_cli PRIVATE SHORTFALL_MPIRUN="${SHORTFALL_MPIRUN}")
endif()

# What commands print with --json, held against the schemas of share/output.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3 AND TARGET shortfall)
  add_test(NAME cli_output_schemas
    COMMAND "${SHORTFALL_PYTHON3}" -B "${CMAKE_CURRENT_LIST_DIR}/output_schemas.py" $<TARGET_FILE:shortfall> "${PROJECT_SOURCE_DIR}")
  # Hundreds of commands: not under the sanitizers, whose other tests run the same code.
  set_tests_properties(cli_output_schemas PROPERTIES LABELS "cli;slow" SKIP_REGULAR_EXPRESSION "^skipped: " TIMEOUT 900)
endif()
