# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(shortfall) for other projects: libraries, headers below include/shortfall/, package description.
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/shortfall")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/analysis" "${PROJECT_SOURCE_DIR}/notebooks-export"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/shortfall"
        FILES_MATCHING PATTERN "*.hpp"
        PATTERN "analysis/shortfall.hpp" EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/analysis/shortfall.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/shortfall")
install(FILES "${PROJECT_SOURCE_DIR}/share/tableau.schema.json" "${PROJECT_SOURCE_DIR}/share/scene.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/shortfall")
install(EXPORT shortfallTargets NAMESPACE shortfall:: DESTINATION "${package}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/shortfallConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/shortfallConfig.cmake" INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/shortfallConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/shortfallConfig.cmake"
              "${PROJECT_BINARY_DIR}/shortfallConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindGMP.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindMPFR.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake"
        DESTINATION "${package}")
