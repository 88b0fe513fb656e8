# SPDX-License-Identifier: GPL-3.0-or-later
# shortfall_embed_texts(<output.cpp> <header> <name> FILES...): writes, in the current binary folder, a C++ file that includes <header>
# and defines the function `const std::map<std::string, std::string>& shortfall::<name>()`, file names to texts; of a .png file
# it has the bytes, as hexadecimal digits. It is written again when a file changes.
function(shortfall_embed_texts output header name)
  set(entries "")
  foreach(file IN LISTS ARGN)
    cmake_path(GET file FILENAME key)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    if(key MATCHES "\\.png$")
      file(READ "${file}" text HEX)
    else()
      file(READ "${file}" text)
    endif()
    string(FIND "${text}" ")text\"" clash)
    if(NOT clash EQUAL -1)
      message(FATAL_ERROR "${file}: contains )text\", which would end the embedded text")
    endif()
    string(APPEND entries "      {\"${key}\", R\"text(${text})text\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${output}" CONTENT
"// Written by cmake/EmbedTexts.cmake.
#include \"${header}\"

namespace shortfall {

const std::map<std::string, std::string>& ${name}() {
  static const std::map<std::string, std::string> texts{
@entries@  };
  return texts;
}

}  // namespace shortfall
" @ONLY)
endfunction()
