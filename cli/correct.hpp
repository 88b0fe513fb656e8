// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.hpp"

namespace shortfall::cli {

/// What `shortfall correct` answers.
struct CorrectionAnswer {
  std::string text;
  int code = kDone;
};

/// The kit for a force that has a formula, as text or JSON.
///
/// throws  Unable, BadInput, SyntaxError
CorrectionAnswer correction_answer(const Question& q);

/// The same as code of a language, named by the user.
///
/// param   height  to which the code jumps when it checks itself; empty for none
std::string correction_code(const Question& q, const std::string& language, const std::string& height);

}  // namespace shortfall::cli
