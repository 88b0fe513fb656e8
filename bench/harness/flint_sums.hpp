// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace shortfall::bench {

/// The sums of powers 0^m + 1^m + ... + (n-1)^m, m = 1 ... highest, as polynomials of FLINT.
///
/// param   own  by FLINT's Bernoulli polynomials; otherwise by the recurrence of
/// analysis/motion/faulhaber.hpp return  "0 1/6 -1/2 1/3" each: coefficients, lowest power first
std::vector<std::string> flint_sums(int highest, bool own);

/// The same without the texts, for taking the time.
void make_flint_sums(int highest, bool own);

/// "FLINT 2.9.0".
std::string flint_name();

}  // namespace shortfall::bench
