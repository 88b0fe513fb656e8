// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/libraries.hpp"

#include <gmp.h>
#include <mpfr.h>

#include "analysis/algebra/flint.hpp"

namespace shortfall {

std::vector<std::pair<std::string, std::string>> arithmetic_libraries() {
  return {{"gmp", gmp_version}, {"mpfr", mpfr_get_version()}, {"flint", flint_version}};
}

}  // namespace shortfall
