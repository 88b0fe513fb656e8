// SPDX-License-Identifier: GPL-3.0-or-later
// Every number and every sign of every catalogue file is changed, one at a time; each change that acts under
// any smooth force, or changes an entry of a tableau, must turn a test red: the claims of the file, the
// shortfalls in tests/data, or the steps of a spring there.
#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue_data.hpp"
#include "analysis/series/order_claims.hpp"
#include "analysis/series/step_series.hpp"
#include "analysis/stability/stability_claims.hpp"
#include "tests/motion/golden_shortfalls.hpp"
#include "tests/series/golden_spring.hpp"

using namespace shortfall;

namespace {

/// A part of a file that is to be replaced, and what by.
struct Mutation {
  std::size_t begin;
  std::size_t length;
  std::string with;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_a_name(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Where the coefficients of a line lie: behind the sign of an assignment or a bar, or all of a line that
/// goes on.
std::size_t coefficients_begin(const std::string& line, const std::string& block) {
  if (block == "expect" || line.find('#') != std::string::npos) return std::string::npos;
  if (block == "tableau" || block == "splitting") return 0;
  const std::size_t equals = line.find('=');
  if (block.empty()) {
    const std::size_t word = line.find_first_not_of(' ');
    if (word == std::string::npos) return word;
    if (line.compare(word, 5, "root ") == 0) return line.find(" of ");
    return line.compare(word, 6, "param ") == 0 || line.compare(word, 7, "approx ") == 0 ? equals
                                                                                         : std::string::npos;
  }
  return equals == std::string::npos ? 0 : equals;
}

/// Three changes of every number, one of every sign.
void mutate_line(const std::string& line, std::size_t offset, std::size_t from,
                 std::vector<Mutation>& mutations) {
  for (std::size_t i = from; i < line.size(); ++i) {
    if (is_of_a_name(line[i]) && !is_digit(line[i])) {
      while (i + 1 < line.size() && is_of_a_name(line[i + 1])) ++i;
    } else if (is_digit(line[i])) {
      std::size_t end = i;
      while (end < line.size() && is_digit(line[end])) ++end;
      const std::string number = line.substr(i, end - i);
      for (const char* change : {"+1/7)", "*2)", "-1)"})
        mutations.push_back({offset + i, end - i, "(" + number + change});
      i = end - 1;
    } else if (line[i] == '+' || line[i] == '-') {
      mutations.push_back({offset + i, 1, line[i] == '+' ? "-" : "+"});
    }
  }
}

std::vector<Mutation> mutations(const std::string& text) {
  static const std::vector<std::string> blocks{"start", "step", "finish", "tableau", "splitting", "expect"};
  std::vector<Mutation> result;
  std::string block;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    if (std::ranges::find(blocks, line) != blocks.end()) {
      block = line;
    } else if (const std::size_t from = coefficients_begin(line, block); from != std::string::npos) {
      mutate_line(line, begin, from, result);
    }
    begin = end + 1;
  }
  return result;
}

/// What is reported after the first steps under a force polynomial of degree 8: with the parameters as
/// letters, and with their defaults.
std::vector<LinearForm> first_steps(const Program& program) {
  std::vector<LinearForm> result;
  for (const Values& given : {Values(), parameter_values(program)}) {
    const StepMap map = step_map(lower(program, given), 8);
    int n = 0;
    for (const auto& state : stepped(map, 8)) {
      result.push_back(reported(map.position, state, n, map.force.states));
      result.push_back(reported(map.velocity, state, n, map.force.states));
      ++n;
    }
    if (program.parameters.empty()) break;
  }
  return result;
}

bool all_hold(const std::vector<ClaimVerdict>& verdicts) {
  return std::ranges::all_of(verdicts, &ClaimVerdict::holds);
}

struct Count {
  int tried = 0;
  int refused = 0;  ///< no longer an integrator: a test that reads the catalogue turns red
  int acting = 0;
  int acting_otherwise = 0;  ///< of these, not under a(t): entries of A and bhat, forces that read x and v
  int by_claims = 0;
  int by_order = 0;  ///< the claims about every smooth force
  int by_shortfalls = 0;
  int by_spring = 0;
  std::vector<std::string> escaped;
};

/// Every entry of a tableau: a force a(t) sees neither A nor the embedded weights.
std::vector<Fraction> entries(const Program& program) {
  if (!program.tableau) return {};
  const ButcherTableau<Fraction> t = SeriesSource(program, {}).tableau<Fraction>();
  std::vector<Fraction> all = t.embedded;
  for (const std::vector<Fraction>& row : t.a) all.insert(all.end(), row.begin(), row.end());
  for (const std::vector<Fraction>* row : {&t.b, &t.c}) all.insert(all.end(), row->begin(), row->end());
  return all;
}

/// What a step does for every smooth force, which sees more of it than a(t); empty when it has no series.
std::vector<Fraction> first_trees(const Program& program) {
  std::vector<Fraction> all;
  try {
    const SeriesSource source(program, {});
    const TreeTable table(Signature::mechanical(true, true), 3);
    const OneStep<Fraction> step = source.step<Fraction>(table);
    for (TreeId t = 0; t < table.size(); ++t)
      for (const TreeSeries<Fraction>* series : {&step.map, &step.start}) all.push_back((*series)[t]);
  } catch (const Error&) {
    all.clear();
  }
  return all;
}

/// What tells a program from its mutant.
struct Original {
  std::vector<LinearForm> steps;
  std::vector<Fraction> entries;
  std::vector<Fraction> trees;
};

void try_mutation(const EmbeddedFile& file, const Mutation& mutation, const Original& original,
                  const testing::GoldenShortfall& golden, const testing::GoldenSpring& spring, Count& count) {
  ++count.tried;
  std::string text(file.text);
  text.replace(mutation.begin, mutation.length, mutation.with);
  Program mutant;
  try {
    mutant = parse(text, std::string(file.path));
    lower(mutant);
  } catch (const Error&) {
    ++count.refused;
    return;
  }
  try {
    if (first_steps(mutant) == original.steps) {
      if (entries(mutant) == original.entries && first_trees(mutant) == original.trees) return;
      ++count.acting_otherwise;
    }
  } catch (const Undefined&) {  // a stage has become singular
  }
  ++count.acting;
  const auto caught = [](const auto& test) {
    try {
      return !test();
    } catch (const Error&) {
      return true;
    }
  };
  // The dearest test comes last: a limit of a mutant with roots takes seconds.
  if (caught([&] { return all_hold(claims(mutant)); })) {
    ++count.by_claims;
  } else if (caught([&] { return all_hold(order_claims(mutant)); })) {
    ++count.by_order;
  } else if (caught([&] { return golden.agrees(mutant); })) {
    ++count.by_shortfalls;
  } else if (caught([&] { return spring.agrees(mutant); })) {
    ++count.by_spring;
  } else if (caught([&] { return all_hold(stability_claims(mutant)); })) {
    ++count.by_claims;
  } else {
    const auto line = std::ranges::count(text.substr(0, mutation.begin), '\n') + 1;
    count.escaped.push_back(std::string(file.path) + ":" + std::to_string(line) + ": " +
                            std::string(file.text.substr(mutation.begin, mutation.length)) + " -> " +
                            mutation.with);
  }
}

}  // namespace

TEST_CASE(
    "every changed coefficient of the catalogue that acts, and every entry of a tableau, turns a test red") {
  const auto golden = testing::golden_shortfalls();
  const auto spring = testing::golden_spring_steps();
  Count count;
  for (const EmbeddedFile& file : catalogue_files()) {
    if (file.path.starts_with("engines/")) continue;  // held by recordings, and changed there
    const std::string text(file.text);
    const Program program = parse(text, std::string(file.path));
    const Original original{first_steps(program), entries(program), first_trees(program)};
    for (const Mutation& mutation : mutations(text))
      try_mutation(file, mutation, original, golden.at(program.name), spring.at(program.name), count);
  }
  MESSAGE(count.tried << " mutations: " << count.refused << " are no integrator any more, "
                      << count.tried - count.refused - count.acting << " do not act, " << count.acting
                      << " act (" << count.acting_otherwise << " not under a(t)); of these "
                      << count.by_claims << " are caught by the claims, " << count.by_order
                      << " by order and structure, " << count.by_shortfalls << " by the shortfalls, "
                      << count.by_spring << " by the spring, " << count.escaped.size() << " escape");
  for (const std::string& escaped : count.escaped) {
    CAPTURE(escaped);
    CHECK(false);
  }
  CHECK(count.acting >= 2400);
}
