# SPDX-License-Identifier: GPL-3.0-or-later
target_link_libraries(test_native PRIVATE shortfall::native quadmath MPFR::MPFR GMP::GMP Boost::headers)
