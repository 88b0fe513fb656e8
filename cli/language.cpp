// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/language.hpp"

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall::cli {

Language language_of(const std::string& word, const std::string& option, const std::string& beside) {
  if (const auto language = language_named(word)) return *language;
  throw BadInput(option + " '" + word.substr(0, 60) + "': we write " + comma_list(language_names()) + beside +
                 did_you_mean(word, language_names()));
}

}  // namespace shortfall::cli
