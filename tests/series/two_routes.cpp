// SPDX-License-Identifier: GPL-3.0-or-later
// Two derivations that share nothing: trees, and brackets of drifts and kicks.
#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "analysis/series/processing.hpp"
#include "analysis/series/splitting_report.hpp"

using namespace shortfall;

TEST_CASE("trees and brackets find the same order and the same effective order for every splitting") {
  constexpr int kDegree = 7;
  int compared = 0;
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;
    const SplittingReport brackets = splitting_report(program, kDegree);
    if (!brackets.why_not.empty() || !brackets.start.empty() || !brackets.finish.empty()) continue;
    CAPTURE(program.name);
    ProcessingQuestion question;
    question.forces = &force_class("a(x)");
    question.order = kDegree;
    const Processing trees = processing(SeriesSource(program, {}), question);
    CHECK(trees.plain_order == brackets.mechanical.order);
    if (brackets.mechanical.effective_order_is_exact)
      CHECK(trees.effective_order == brackets.mechanical.effective_order);
    ++compared;
  }
  CHECK(compared >= 20);
}
