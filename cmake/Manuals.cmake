# SPDX-License-Identifier: GPL-3.0-or-later
# Manual pages and completion files, written by the program itself from its help, and installed with it.
set(folder "${PROJECT_BINARY_DIR}/share")
find_program(GZIP_PROGRAM gzip REQUIRED)
mark_as_advanced(GZIP_PROGRAM)
add_custom_command(
  OUTPUT "${folder}/made"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${folder}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
  COMMAND shortfall manual --all -o "${folder}/man1"
  COMMAND sh -c "\"${GZIP_PROGRAM}\" -9n share/man1/*.1"
  COMMAND shortfall completion bash -o "${folder}/shortfall"
  COMMAND shortfall completion zsh -o "${folder}/_shortfall"
  COMMAND shortfall completion fish -o "${folder}/shortfall.fish"
  COMMAND "${CMAKE_COMMAND}" -E touch "${folder}/made"
  DEPENDS shortfall WORKING_DIRECTORY "${folder}/.." COMMENT "Writing manual pages and completion files" VERBATIM)
add_custom_target(manuals ALL DEPENDS "${folder}/made")

install(DIRECTORY "${folder}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" ${shortfall_readable} COMPONENT runtime)
install(FILES "${folder}/shortfall" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT runtime)
install(FILES "${folder}/_shortfall" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT runtime)
install(FILES "${folder}/shortfall.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT runtime)
