// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/force.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/motion/force.hpp"

namespace shortfall::cli {

int force_degree(const std::string& text) {
  const Force force = force_named(text);
  if (force.linear())
    throw Unable("this is answered for constant and poly:D; for '" + text.substr(0, 60) +
                 "' ask derive or correct");
  return force.degree;
}

}  // namespace shortfall::cli
