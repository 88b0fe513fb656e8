// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/identify/identification.hpp"

namespace shortfall {

/// What a log says about the map that made it, for people.
///
/// param   most  how many maps are listed in full
std::string as_text(const Log& log, const Identification& found, std::size_t most = 12);

/// The same for programs: schema shortfall.identify/1.
nlohmann::ordered_json as_json(const Log& log, const Identification& found);

/// "c = 0.5, a_y = -9.81", with what is not told left out.
std::string parameters_text(const Log& log, const Match& match);

}  // namespace shortfall
