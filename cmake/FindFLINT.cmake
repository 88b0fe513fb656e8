# SPDX-License-Identifier: GPL-3.0-or-later
# FLINT::FLINT (FLINT 2.9 or 3) with Arb; find GMP and MPFR first. Arb is a part of FLINT 3, and a library of its own
# beside FLINT 2.
find_path(FLINT_INCLUDE_DIR flint/fmpq_mpoly.h)
find_library(FLINT_LIBRARY flint)
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY)
if(FLINT_INCLUDE_DIR AND EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
  set(arb_needs "")
else()
  find_path(ARB_INCLUDE_DIR arb.h)
  find_library(ARB_LIBRARY NAMES flint-arb arb)
  mark_as_advanced(ARB_INCLUDE_DIR ARB_LIBRARY)
  set(arb_needs ARB_LIBRARY ARB_INCLUDE_DIR)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR ${arb_needs})

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT UNKNOWN IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES
    IMPORTED_LOCATION "${FLINT_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "MPFR::MPFR;GMP::GMP")
  if(arb_needs)
    set_property(TARGET FLINT::FLINT APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR}")
    set_property(TARGET FLINT::FLINT PROPERTY INTERFACE_LINK_LIBRARIES "${ARB_LIBRARY};${FLINT_LIBRARY};MPFR::MPFR;GMP::GMP")
  endif()
endif()
