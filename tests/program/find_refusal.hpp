// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall::testing {

/// What a user reads who asks for an integrator that is not there.
inline std::string refusal(const std::string& word) {
  try {
    return "found " + find_integrator(word).name;
  } catch (const Error& e) {
    return e.what();
  }
}

}  // namespace shortfall::testing
