// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue_data.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tape.hpp"

using namespace shortfall;

namespace {

/// Characters that mean something, bytes that mean nothing, and halves of UTF-8 characters.
rc::Gen<std::string> morsel() {
  return rc::gen::oneOf(
      rc::gen::map(rc::gen::elementOf(std::string("()+-*/^=,:&|{}# \n\t0129.ehvxatLT_")),
                   [](char c) { return std::string(1, c); }),
      rc::gen::map(rc::gen::inRange(0, 256), [](int c) { return std::string(1, static_cast<char>(c)); }),
      rc::gen::elementOf(std::vector<std::string>{"step", "start", "solve k : L/T^2 = ", "substeps 2 {\n",
                                                  "tableau\n", "expect\n", "param p = ", "state s : L\n",
                                                  "a(x, v, t)", "1e99999", "^999", "((((", "\xc2", "½",
                                                  "integrator b\n", "& ", "exact 3\n", "1/0", "-"}));
}

std::string mutated(std::string text) {
  const int changes = *rc::gen::inRange(1, 6);
  for (int k = 0; k < changes; ++k) {
    const std::size_t place = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const std::size_t length = std::min<std::size_t>(
        *rc::gen::oneOf(rc::gen::just(0), rc::gen::inRange(0, 4), rc::gen::inRange(0, 80)),
        text.size() - place);
    const std::string with = *rc::gen::oneOf(rc::gen::just(std::string()), morsel());
    text.replace(place, length, with);
  }
  return text;
}

}  // namespace

TEST_CASE("a catalogue file with random damage is read or refused with a place, and nothing else happens") {
  CHECK(rc::check([] {
    const EmbeddedFile file =
        *rc::gen::elementOf(std::vector<EmbeddedFile>(catalogue_files().begin(), catalogue_files().end()));
    const std::string text = mutated(std::string(file.text));
    try {
      const Program program = parse(text, "mutated.integrator");
      RC_ASSERT(same(parse(print(program), "printed.integrator"), program));
      lower(program);
      RC_TAG("read");
    } catch (const SyntaxError& e) {
      RC_ASSERT(e.line() >= 1);
      RC_ASSERT(e.column() >= 1);
      RC_ASSERT(std::string(e.what()).starts_with("mutated.integrator:" + std::to_string(e.line()) + ":" +
                                                  std::to_string(e.column()) + ": "));
      RC_TAG("refused");
    }
  }));
}
