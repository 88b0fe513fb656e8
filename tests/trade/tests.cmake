# SPDX-License-Identifier: GPL-3.0-or-later
# Elliptic integrals and steppers of GSL stand beside ours.
target_link_libraries(test_trade PRIVATE GSL::gsl MPFR::MPFR GMP::GMP Boost::headers)
