// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "cli/command.hpp"

namespace shortfall::cli {

/// What turns `derive` from formulas to numbers: how many steps, and from where.
struct NumbersOptions {
  std::string steps;
  std::string until;
  std::string x0 = "0";
  std::string v0 = "0";

  bool wanted() const { return !steps.empty() || !until.empty(); }
};

/// --steps, --until, --x0, --v0, --dt, --g.
void add_numbers(CLI::App& command, Question& q, NumbersOptions& o);

/// Where so many steps lead, in numbers of which every digit is certain.
///
/// throws  BadInput  for a letter without a number
int derive_numbers(const Question& q, const NumbersOptions& o);

}  // namespace shortfall::cli
