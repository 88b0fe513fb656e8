# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -P: installs the build in BUILD into a prefix below WORK, then configures, builds and runs the projects in
# SOURCE and EXAMPLES against nothing but that prefix. What an example prints is what stands beside it.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(build project folder)
  run("${CMAKE_COMMAND}" -S "${project}" -B "${folder}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
      "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run("${CMAKE_COMMAND}" --build "${folder}")
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
build("${SOURCE}" "${WORK}/build")
run("${WORK}/build/consumer")

build("${EXAMPLES}" "${WORK}/examples")
file(GLOB expected "${EXAMPLES}/*.txt")
list(FILTER expected EXCLUDE REGEX "CMakeLists")
if(NOT expected)
  message(FATAL_ERROR "no example says what it prints")
endif()
foreach(file IN LISTS expected)
  cmake_path(GET file STEM example)
  execute_process(COMMAND "${WORK}/examples/${example}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${file}" text)
  if(NOT printed STREQUAL text)
    message(FATAL_ERROR "examples/${example} printed\n${printed}and not\n${text}")
  endif()
endforeach()
