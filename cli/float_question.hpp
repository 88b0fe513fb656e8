// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/floating/float_run.hpp"
#include "cli/command.hpp"

namespace shortfall::cli {

/// What commands about floating-point runs ask for besides an integrator.
struct FloatOptions : Question {
  std::string formats;
  std::string x0, v0;
};

/// The options of such a command: integrator, force, dt, x0, v0, formats, parameters, --json, -o.
///
/// param   formats  which there are, for the help
void add_float_options(CLI::App& command, FloatOptions& o, const std::string& formats);

/// A body at x = 1 m at rest unless --x0 or --v0 says otherwise; gravity for a constant force without a
/// number; --dt 0.02f means 0.02, stored in binary32.
///
/// throws  BadInput, SyntaxError
FloatQuestion float_question(const FloatOptions& o);

}  // namespace shortfall::cli
