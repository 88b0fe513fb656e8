# SPDX-License-Identifier: GPL-3.0-or-later
# replay FOLDER, the tool behind `./dev replay`: built only when it is asked for.
add_executable(replay EXCLUDE_FROM_ALL
  "${CMAKE_CURRENT_LIST_DIR}/recording.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/replay.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/table.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/tool/main.cpp")
target_link_libraries(replay PRIVATE shortfall::export)

# confusion FOLDER, the tool behind `./dev confusion`: what `identify` makes of recordings.
add_executable(confusion EXCLUDE_FROM_ALL
  "${CMAKE_CURRENT_LIST_DIR}/confusion.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/recording.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/replay.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/tool/confusion_main.cpp")
find_package(Threads REQUIRED)
target_link_libraries(confusion PRIVATE shortfall::export Threads::Threads)
