// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/trade/advice.hpp"

namespace shortfall {

/// The answer in three lines (what to step it with, what to model, what is left), and beside what a naive
/// choice costs.
///
/// param  why  the tables behind it too: what each force does, what else was good enough, the parts of the
/// error
std::string as_text(const Advice& advice, bool why);
nlohmann::ordered_json as_json(const Advice& advice);

}  // namespace shortfall
