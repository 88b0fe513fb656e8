# SPDX-License-Identifier: GPL-3.0-or-later

# shortfall_module(<name> [DEPENDS modules...] [LINK libraries...] [SOURCES generated files...])
#
# Every .cpp of the current folder becomes the static library shortfall_<name>, alias shortfall::<name>. A folder that
# has no .cpp yet becomes an interface library: its headers can be included already. Includes start at the repository's
# root. DEPENDS are seen by the users of the module; LINK is what only its .cpp files see.
function(shortfall_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;LINK;SOURCES")
  set(target shortfall_${name})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  list(APPEND sources ${arg_SOURCES})

  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PRIVATE ${arg_LINK})
    shortfall_precompile(${target})
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(shortfall::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/shortfall>")
  list(TRANSFORM arg_DEPENDS PREPEND shortfall::)
  target_link_libraries(${target} ${scope} ${arg_DEPENDS})
  install(TARGETS ${target} EXPORT shortfallTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
  set_property(GLOBAL APPEND PROPERTY SHORTFALL_MODULES ${name})
endfunction()
