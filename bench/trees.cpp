// SPDX-License-Identifier: GPL-3.0-or-later
// Series of trees: modified equations and order conditions, with the memory that they take. Tables of trees
// are kept from turn to turn; coefficients and results are not.
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/tree_series.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/series/modifying.hpp"
#include "analysis/series/order.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/peer.hpp"
#include "bench/harness/ratios.hpp"

using namespace shortfall;
using bench::here;
using bench::time_text;

namespace {

constexpr int kRounds = 12;

/// The largest part of the process that has been in memory so far, in megabytes; 0 where the system does not
/// say.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

void row(const std::string& what, double seconds, double target, double megabytes) {
  std::printf("  %-58s %9s   table %7.2f MB", what.c_str(), time_text(seconds).c_str(), megabytes);
  if (target > 0)
    std::printf("   target %9s   %s", time_text(target).c_str(), seconds <= target ? "met" : "MISSED");
  std::printf("\n");
  std::fflush(stdout);
}

double least(std::function<void()> work) {
  return bench::least_times({here("", std::move(work))}, kRounds, 0.02)[0];
}

void modified_equations() {
  const ButcherTableau<Rational> midpoint{{{0, 0}, {Rational(1, 2), 0}}, {0, 1}, {0, Rational(1, 2)}, {}};
  struct Case {
    int order;
    double modified, modifying;
  };
  for (const Case& c : {Case{9, 5e-3, 0}, Case{10, 0, 0}, Case{11, 0, 0}, Case{12, 0.5, 0}, Case{14, 0, 0}}) {
    const TreeTable table(Signature::first_order(), c.order);
    const std::string order = std::to_string(c.order);
    const double megabytes = static_cast<double>(table.bytes()) / 1e6;
    row("table of trees, order " + order,
        least([&] { bench::keep(TreeTable(Signature::first_order(), c.order)); }), 0, megabytes);
    row("modified equation of explicit midpoint, order " + order, least([&] {
          bench::keep(logarithm(table, ElementaryWeights<Rational>(midpoint, table).result(midpoint.b)));
        }),
        c.modified, megabytes);
    if (c.order < 14)
      row("modifying equation, order " + order, least([&] { bench::keep(modifying_field(midpoint, table)); }),
          c.modifying, megabytes);
  }
}

/// The same by the tests' second implementation, where Python is here; the seconds of both, in turns.
void beside_python(const std::string& tableau, int wrong, const std::function<void()>& ours) {
  bench::Peer python(
      "Python",
      {"/usr/bin/python3", std::string(SHORTFALL_PEERS) + "/trees.py", SHORTFALL_INDEPENDENT, tableau}, "",
      "");
  if (!python.runs()) {
    std::printf("  %s %s: left out\n", python.name().c_str(), python.reason().c_str());
    return;
  }
  const auto theirs = python.ask("wrong(8)");
  if (!theirs || theirs->empty() || std::stoi(theirs->front()) != wrong)
    throw Error("the second implementation counts other conditions");
  const std::vector<double> times = bench::least_times(
      {here("", ours), {python.name(), [&](long count) { return python.seconds(8, count); }}}, 3, 0.02);
  std::printf("    %s: %s, the same conditions do not hold; shortfall / it %.2g\n", python.name().c_str(),
              time_text(times[1]).c_str(), times[0] / times[1]);
  bench::note_ratio("200 conditions of Fehlberg's 7(8), 13 stages", python.name(), times[0], times[1]);
}

/// All conditions up to order 8 of a tableau with 13 stages, exactly.
void order_conditions() {
  const TreeTable table(Signature::first_order(), 8);
  for (const char* name : {"fehlberg-78", "prince-dormand-87-13m"}) {
    const std::string file = std::string(SHORTFALL_METHODS) + "/" + name + ".json";
    const SeriesSource source(find_integrator(file), {});
    const ButcherTableau<Rational> tableau = source.tableau<Rational>();
    int wrong = 0;
    const auto count = [&] {
      const TreeSeries<Rational> map = ElementaryWeights<Rational>(tableau, table).result(tableau.b),
                                 exact = exact_flow<Rational>(table);
      wrong = 0;
      for (TreeId t = 0; t < table.size(); ++t) wrong += map[t] == exact[t] ? 0 : 1;
      bench::keep(wrong);
    };
    const double seconds = least(count);
    row("200 conditions of " + std::string(name) + " (" + std::to_string(wrong) + " not exact)", seconds,
        20e-3, static_cast<double>(table.bytes()) / 1e6);
    if (std::string(name) == "fehlberg-78") beside_python(file, wrong, count);
  }
}

void commands() {
  const std::vector<Program>& all = catalogue();
  row("order by all classes, whole catalogue (" + std::to_string(all.size()) + ")", least([&] {
        for (const Program& p : all) bench::keep(order(SeriesSource(p, {})));
      }),
      0, 0);
}

}  // namespace

int main() try {
  std::printf(
      "Least processor time of %d turns; tables of trees are kept, coefficients and results are not.\n",
      kRounds);
  modified_equations();
  order_conditions();
  commands();
  std::printf("  largest part in memory during all this: %.0f MB\n", peak_megabytes());
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "bench: %s\n", e.what());
  return 1;
}
