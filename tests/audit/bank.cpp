// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is wrong with what is right: no claim of a published method is refuted, and none is mended.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "analysis/audit/program_audit.hpp"
#include "analysis/audit/tableau_audit.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

TEST_CASE("every claim of every published method of the bank holds, and nothing is mended") {
  int methods = 0, claims = 0, proved = 0, recognised = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods")) {
    if (entry.path().extension() != ".json") continue;
    const Audit audit = audit_tableau(parse_tableau_file(entry.path().string()));
    CAPTURE(audit.name);
    ++methods;
    for (const AuditClaim& c : audit.claims) {
      CAPTURE(c.claim);
      CAPTURE(c.found);
      CHECK(c.verdict == AuditClaim::Verdict::holds);
      CHECK((c.digits == 0) == (audit.digits == 0));  // decimals prove nothing
      ++claims;
      proved += c.digits == 0;
    }
    for (const Mend& m : audit.mends) {
      CHECK(m.kind == Mend::Kind::exact_value);
      recognised += static_cast<int>(m.changes.size());
    }
  }
  CHECK(methods >= 60);
  CHECK(claims >= 5 * methods);
  CHECK(proved >= 300);
  CHECK(recognised >= 40);
}

TEST_CASE("no integrator of the catalogue is refuted") {
  int sums = 0;
  for (const Program& p : catalogue()) {
    const Audit audit = audit_program(p, "", std::nullopt);
    CAPTURE(p.name);
    for (const AuditClaim& c : audit.claims) {
      CAPTURE(c.claim);
      CAPTURE(c.found);
      CHECK(c.verdict != AuditClaim::Verdict::refuted);
      sums += c.claim == "the drifts add up to 1";
    }
  }
  CHECK(sums >= 20);
}

TEST_CASE(
    "decimals that are all recognised are put in, and then the claims are proved or the numbers dropped") {
  const std::string text =
      R"({"A": [[0.211324865405187, 0], [0.577350269189626, 0.211324865405187]], "b": [0.5, 0.5],
          "c": [0.211324865405187, 0.788675134594813], "order": )";
  const Audit right = audit_tableau(parse_tableau(text + "3}", "three.json"));
  CHECK_FALSE(right.refuted());
  REQUIRE(right.mends.size() == 1);
  CHECK(right.mends[0].restores == "with these every claim is proved");
  CHECK(right.mends[0].changes.size() == 3);
  const Audit wrong = audit_tableau(parse_tableau(text + "4}", "four.json"));
  CHECK(wrong.refuted());
  for (const Mend& m : wrong.mends) CHECK(m.kind != Mend::Kind::exact_value);
}
