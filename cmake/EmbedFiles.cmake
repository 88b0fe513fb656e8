# SPDX-License-Identifier: GPL-3.0-or-later
# Two uses. Included: shortfall_embed(<name> <header> <folder> <pattern>...) adds the rule that turns every file below
# <folder> that fits a pattern into <name>.cpp in the current binary folder, when the build runs. That file includes
# <header> and defines `std::span<const EmbeddedFile> shortfall::<name>()`, sorted by path; of a .png file it has the
# bytes as hexadecimal digits. Run as a script (cmake -P), with FOLDER, LIST, OUTPUT, HEADER and FUNCTION defined: writes
# that file.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  function(shortfall_embed name header folder)
    list(TRANSFORM ARGN PREPEND "${folder}/" OUTPUT_VARIABLE patterns)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${folder}" ${patterns})
    list(SORT files)
    # Written only when the names change, so that a removed file writes the others again as well.
    set(list "${CMAKE_CURRENT_BINARY_DIR}/${name}.txt")
    list(JOIN files "\n" lines)
    file(CONFIGURE OUTPUT "${list}" CONTENT "${lines}" @ONLY)
    list(TRANSFORM files PREPEND "${folder}/")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${folder}" "-DLIST=${list}" "-DOUTPUT=${output}"
              "-DHEADER=${header}" "-DFUNCTION=${name}" -P "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
      DEPENDS ${files} "${list}" "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
      COMMENT "Embedding ${folder}"
      VERBATIM)
    add_custom_target(embed_${name} DEPENDS "${output}")
    if(NOT TARGET embedded_files)
      add_custom_target(embedded_files)
    endif()
    add_dependencies(embedded_files embed_${name})
  endfunction()
  return()
endif()

set(delimiter "embedded")
file(STRINGS "${LIST}" files)
set(entries "")
set(count 0)
foreach(file IN LISTS files)
  if(file MATCHES "\\.png$")
    file(READ "${FOLDER}/${file}" text HEX)
  else()
    file(READ "${FOLDER}/${file}" text)
  endif()
  string(FIND "${text}" ")${delimiter}\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${FOLDER}/${file}: contains )${delimiter}\", which would end the embedded text")
  endif()
  string(APPEND entries "    {\"${file}\", R\"${delimiter}(${text})${delimiter}\"},\n")
  math(EXPR count "${count} + 1")
endforeach()

file(WRITE "${OUTPUT}" "// Written by cmake/EmbedFiles.cmake.
#include \"${HEADER}\"

#include <array>

namespace shortfall {

std::span<const EmbeddedFile> ${FUNCTION}() {
  static constexpr std::array<EmbeddedFile, ${count}> kFiles{{
${entries}  }};
  return kFiles;
}

}  // namespace shortfall
")
