# SPDX-License-Identifier: GPL-3.0-or-later
# The pictures that lessons show before they are run are those of today's cells.
find_program(SHORTFALL_PYTHON3 python3)
if(SHORTFALL_PYTHON3 AND TARGET shortfall)
  add_test(NAME lessons_pictures
    COMMAND "${SHORTFALL_PYTHON3}" -B "${PROJECT_SOURCE_DIR}/lessons/draw_pictures.py" $<TARGET_FILE:shortfall> --check)
  set_tests_properties(lessons_pictures PROPERTIES LABELS export)
endif()
