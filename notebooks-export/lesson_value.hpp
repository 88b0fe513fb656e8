// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall {

/// What stands for {{words}} in a lesson: a formula, a number, a program or its step in Python, as shortfall
/// derives it. The words are described in lessons/README.md.
///
/// throws  BadInput  for words that mean nothing, with a suggestion; other errors of the question that is
///                   asked
std::string lesson_value(const std::string& words);

}  // namespace shortfall
