// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "analysis/motion/derivation.hpp"
#include "analysis/program/catalogue.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"

namespace shortfall::cli {

namespace {

/// One thing that must hold on this machine for our answers to be right.
struct Finding {
  std::string what;
  bool sound;
};

/// a*b + c with two roundings. The volatile values keep the compiler from doing it beforehand.
bool no_contraction() {
  volatile double a = 1.0 + 0x1p-30;
  volatile double b = 1.0 - 0x1p-30;
  volatile double c = -1.0;
  const double x = a;
  const double y = b;
  const double z = c;
  return x * y + z == 0.0;  // a fused operation would give -2^-60
}

std::vector<Finding> findings() {
  std::vector<Finding> list;
  list.push_back({"float is binary32 and double is binary64 (IEEE 754)",
                  std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559});
  list.push_back({"one operation, one rounding: a*b + c is not fused", no_contraction()});
  volatile double tiny = std::numeric_limits<double>::min();
  list.push_back({"subnormal numbers are not flushed to zero", tiny / 2 > 0});
  volatile double one = 1.0;
  list.push_back(
      {"rounding is to nearest, ties to even", one + 0x1p-53 == one && one + 3 * 0x1p-53 == one + 0x1p-51});
  int proved = 0;
  for (const Program& p : catalogue()) proved += derivation(p, 1, {}, 1, false).proved() ? 1 : 0;
  list.push_back({fmt::format("{} of {} integrators derived and proved for a force linear in t", proved,
                              catalogue().size()),
                  proved == static_cast<int>(catalogue().size())});
  return list;
}

}  // namespace

void add_doctor(CLI::App& app, int& code) {
  CLI::App* command =
      new_command(app, "Set-up", "doctor",
                  "Is this set-up sound?  Floating point, the catalogue, its proofs.", {"doctor"});
  command->callback([&code] {
    std::string text;
    bool sound = true;
    for (const Finding& f : findings()) {
      text += fmt::format("{}  {}\n", f.sound ? "ok  " : "FAIL", f.what);
      sound = sound && f.sound;
    }
    write_output(text);
    code = sound ? kDone : kRefuted;
  });
}

}  // namespace shortfall::cli
