# SPDX-License-Identifier: GPL-3.0-or-later
# How every target of this project is compiled.
# Libraries of one machine's kind stand where Debian has them.
if(EXISTS /etc/debian_version AND CMAKE_LIBRARY_ARCHITECTURE)
  set(CMAKE_INSTALL_LIBDIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}" CACHE PATH "Object code libraries")
endif()
include(GNUInstallDirs)
# Whole folders are installed for everybody to read, whatever the umask was when they were unpacked.
set(shortfall_readable
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
    DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_SCAN_FOR_MODULES OFF)  # there are none, and newer CMake reads each file once more to see

# No NDEBUG anywhere: an assertion that costs too much is written differently, not switched off.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-Og -g1 -fno-omit-frame-pointer")

# Tests are compiled more often than run: a third of the time at -O1 is the optimiser's.
set(SHORTFALL_TEST_OPTIMIZATION -O0)

# One operation, one rounding: a fused multiply-add would change the trajectories that we make statements about.
add_compile_options(-Wall -Wextra -Wpedantic -ffp-contract=off)

# False alarms of g++ 12 to 14 inside their own standard library.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  add_compile_options(-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# clang links g++'s libquadmath and does not look for its header, which stands among g++'s own.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  file(GLOB quadmath_folders "/usr/lib/gcc/*/*/include/quadmath.h")
  if(quadmath_folders)
    list(SORT quadmath_folders COMPARE NATURAL ORDER DESCENDING)
    list(GET quadmath_folders 0 quadmath_header)
    cmake_path(GET quadmath_header PARENT_PATH quadmath_folder)
    add_compile_options("SHELL:-idirafter ${quadmath_folder}")
  endif()
endif()

if(SHORTFALL_SANITIZE)
  # What is left out of the undefined-behaviour checks are those before each access to memory, which the address
  # sanitizer watches in its own way: with them a file takes twice as long to compile, and with all debugging information
  # (-g in place of -g1) twice as long again, as measured.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment,object-size,vptr
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=address,undefined)
endif()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The sloppiness is what ccache needs to cache at all where a precompiled header is used.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
endif()
