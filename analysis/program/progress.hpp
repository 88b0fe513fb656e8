// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace shortfall {

/// Is told, now and then, what a long piece of work is doing and how much of that part is done: `done` of
/// `of`. Empty means that nobody wants to know.
using Progress = std::function<void(const std::string& doing, int done, int of)>;

}  // namespace shortfall
