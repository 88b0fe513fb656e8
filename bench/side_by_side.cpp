// SPDX-License-Identifier: GPL-3.0-or-later
// The targets of speed beside what is measured, and the sums of powers beside the same sums in SymPy, Maxima,
// FLINT and PARI.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/motion/faulhaber.hpp"
#include "analysis/program/catalogue.hpp"
#include "bench/harness/flint_sums.hpp"
#include "bench/harness/interleaved.hpp"
#include "bench/harness/peer.hpp"
#include "bench/harness/ratios.hpp"
#include "notebooks-export/result_text.hpp"

using namespace shortfall;
using bench::Contender;
using bench::here;
using bench::time_text;

namespace {

constexpr int kHighestSum = 50;
constexpr int kHighestForce = 6;
constexpr int kRounds = 12;

void sums() { bench::keep(power_sums(kHighestSum)); }

void n_step_map() {
  static const Program program = find_integrator("symplectic-euler");
  bench::keep(closed_form(step_map(lower(program), 20)));
}

/// The loops of engines have parameters that stay letters: every coefficient is a rational function of them.
enum class Part { methods, engines };
bool belongs(const Program& program, Part part) {
  return (family(program) == "engines") == (part == Part::engines);
}

/// What the command `derive` does, for the integrators of a part and all forces; how many were derived.
int catalogue_derived(Part part, bool with_kit) {
  int count = 0;
  for (const Program& program : catalogue())
    for (int degree = 0; degree <= kHighestForce && belongs(program, part); ++degree) try {
        const Derivation d = derivation(program, degree);
        if (!d.proved()) throw Error(program.name + " was not proved");
        ++count;
        if (!with_kit) continue;
        const CorrectionKit kit = correction_kit(d);
        bench::keep(as_text(d, &kit, Style::unicode));
      } catch (const Unable&) {
        // It says why, and that takes its time too.
      }
  return count;
}

void target_row(const std::string& what, double seconds, double target) {
  std::printf("  %-66s %9s   target %9s   %s\n", what.c_str(), time_text(seconds).c_str(),
              time_text(target).c_str(), seconds <= target ? "met" : "MISSED");
  std::fflush(stdout);
}

/// One after another, "0 1/6 -1/2 1/3": the coefficients of S_m, lowest power first.
std::vector<std::string> our_sums() {
  std::vector<std::string> lines;
  const auto all = power_sums(kHighestSum);
  for (std::size_t m = 1; m < all.size(); ++m) {
    std::string line;
    for (const Rational& c : all[m]) line += (line.empty() ? "" : " ") + c.str();
    lines.push_back(std::move(line));
  }
  return lines;
}

/// The same without brackets and commas, as each system writes its lists.
std::string plain(std::string line) {
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
  std::string result;
  for (const char c : line)
    if (c != ' ' || (!result.empty() && result.back() != ' ')) result += c;
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

int different(const std::vector<std::string>& theirs, const std::vector<std::string>& ours) {
  if (theirs.size() != ours.size()) return static_cast<int>(ours.size());
  int count = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) count += theirs[i] != ours[i];
  return count;
}

/// How many of the sums that a peer gives are not ours.
int different(bench::Peer& peer, int way, const std::vector<std::string>& ours) {
  const auto theirs = peer.ask("show(" + std::to_string(way) + ")");
  if (!theirs) throw Error(peer.name() + " " + peer.reason());
  std::vector<std::string> lines;
  for (const std::string& line : *theirs)
    if (std::string text = plain(line); !text.empty()) lines.push_back(std::move(text));
  return different(lines, ours);
}

const char* way_text(bool own) { return own ? ", its own function" : ", our recurrence"; }

int peers_table() {
  std::printf(
      "\nThe same sums elsewhere, in the running program each (its start is not counted), taking turns\n");
  const std::vector<std::string> ours = our_sums();
  const auto peers = bench::peers("sums");
  std::vector<Contender> contenders{here("shortfall", sums)};
  std::vector<std::string> notes{""};
  int wrong = 0;
  const auto add = [&](Contender contender, int differences) {
    wrong += differences;
    contenders.push_back(std::move(contender));
    notes.push_back(differences == 0 ? "the same polynomials"
                                     : std::to_string(differences) + " POLYNOMIALS DIFFER");
  };
  for (const bool own : {true, false})
    add(here(bench::flint_name() + way_text(own), [own] { bench::make_flint_sums(kHighestSum, own); }),
        different(bench::flint_sums(kHighestSum, own), ours));
  for (const auto& peer : peers) {
    if (!peer->runs()) {
      std::printf("  %s %s: left out (./dev bench --peers installs it)\n", peer->name().c_str(),
                  peer->reason().c_str());
      continue;
    }
    for (const int way : {1, 2}) {
      add({peer->name() + way_text(way == 1),
           [p = peer.get(), way](long times) { return p->seconds(way, times); }},
          different(*peer, way, ours));
    }
  }
  const std::vector<double> least = bench::least_times(contenders, kRounds, 0.02);
  std::printf("  %-50s %9s   %s\n", "", "time", "shortfall / it");
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::printf("  %-50s %9s   %-10.2g  %s\n", contenders[i].name.c_str(), time_text(least[i]).c_str(),
                least[0] / least[i], notes[i].c_str());
    if (i > 0)
      bench::note_ratio("all sums of powers of degree 1 to 50", contenders[i].name, least[0], least[i]);
  }
  return wrong;
}

}  // namespace

int main() try {
  std::printf("Processor time, least of %d rounds, in process\n", kRounds);
  const auto small = bench::least_times({here("", sums), here("", n_step_map)}, 4 * kRounds, 0.005);
  target_row("all sums of powers of degree 1 to 50", small[0], 0.2e-3);
  target_row("n-step map of symplectic Euler under poly:20", small[1], 0.7e-3);
  for (const auto& [part, name] :
       {std::pair{Part::methods, "methods"}, std::pair{Part::engines, "engines"}}) {
    const auto asked =
        std::ranges::count_if(catalogue(), [p = part](const Program& q) { return belongs(q, p); }) *
        (kHighestForce + 1);
    const int derived = catalogue_derived(part, false);
    const auto whole = bench::least_times({here("", [p = part] { catalogue_derived(p, false); }),
                                           here("", [p = part] { catalogue_derived(p, true); })},
                                          part == Part::methods ? kRounds : 3, 0);
    target_row(std::string("derivation and proofs, ") + name + ", poly:0 to 6 (" + std::to_string(derived) +
                   " of " + std::to_string(asked) + ")",
               whole[0], 2);
    target_row("  the same with correction kits, as text: all that derive does", whole[1], 2);
  }
  return peers_table() == 0 ? 0 : 1;
} catch (const std::exception& e) {
  std::fprintf(stderr, "bench: %s\n", e.what());
  return 1;
}
