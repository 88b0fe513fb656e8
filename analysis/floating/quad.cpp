// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/quad.hpp"

#include <quadmath.h>

namespace shortfall {

Quad fma(Quad a, Quad b, Quad c) { return Quad(fmaq(a.value(), b.value(), c.value())); }
Quad sqrt(Quad a) { return Quad(sqrtq(a.value())); }
Quad exp(Quad a) { return Quad(expq(a.value())); }
Quad log(Quad a) { return Quad(logq(a.value())); }
Quad pow(Quad a, Quad b) { return Quad(powq(a.value(), b.value())); }

}  // namespace shortfall
