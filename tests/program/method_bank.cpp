// SPDX-License-Identifier: GPL-3.0-or-later
// The bank of published methods, tests/data/methods: every file is read and becomes an integrator whose step
// is the one that the tableau says. Their orders are checked by tests/independent/order_conditions.py.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/tableau_file.hpp"

using namespace shortfall;

namespace {

namespace fs = std::filesystem;

const std::vector<TableauFile>& bank() {
  static const std::vector<TableauFile> files = [] {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(SHORTFALL_SOURCE_DIR) / "tests/data/methods"))
      if (entry.path().extension() == ".json") paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<TableauFile> read;
    for (const fs::path& path : paths) read.push_back(parse_tableau_file(path.string()));
    return read;
  }();
  return files;
}

/// An entry made of numbers and square roots, in exact numbers: evaluated here and not by the library.
Surd exact(const Expr& e) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t i) { return exact(e->operands[i]); };
  switch (e->op) {
    case Op::number:
      return e->value;
    case Op::negate:
      return -operand(0);
    case Op::add:
      return operand(0) + operand(1);
    case Op::subtract:
      return operand(0) - operand(1);
    case Op::multiply:
      return operand(0) * operand(1);
    case Op::divide:
      return operand(0) / operand(1);
    default:
      REQUIRE(e->op == Op::call);
      REQUIRE(e->name == "sqrt");
      return Surd::sqrt(operand(0).rational_part());
  }
}

Surd exact(const TableauEntry& entry) { return entry.exact ? Surd(*entry.exact) : exact(entry.value); }

std::vector<Surd> exact(const std::vector<TableauEntry>& row) {
  std::vector<Surd> values;
  for (const TableauEntry& entry : row) values.push_back(exact(entry));
  return values;
}

std::vector<std::vector<Surd>> exact(const std::vector<std::vector<TableauEntry>>& rows) {
  std::vector<std::vector<Surd>> values;
  for (const auto& row : rows) values.push_back(exact(row));
  return values;
}

double rounded(const Surd& s) {
  return s.rational_part().to_double() + s.root_part().to_double() * std::sqrt(s.radicand().to_double());
}

/// How far apart a step with the coefficients as written and one with the decimals of the program may be.
Surd slack(const TableauFile& file) {
  int fewest = 1000;
  for (const Approximation& a : file.program.approximations)
    fewest = std::min(fewest, static_cast<int>(a.text.size() - a.text.find('.')) - 1);
  return file.exact() ? Surd(0) : Surd(Rational(1000) / Rational(10).pow(fewest));
}

bool near(const Surd& a, const Surd& b, const Surd& allowed) {
  const Surd d = a - b;
  return !(allowed < d) && !(allowed < -d);
}

struct Start {
  Rational x{3, 7}, v{-5, 11}, t{2, 3}, h{1, 5};
  Rational stiffness{-13, 4}, damping{-3, 8};  ///< a = stiffness x + damping v + t^2
};

/// One step straight from the tableau: all stages together solve a linear system.
std::pair<Surd, Surd> step_of_tableau(const TableauFile& file, const Start& s) {
  const std::size_t n = file.stages();
  const auto a = exact(file.a);
  const auto b = exact(file.b), c = exact(file.c);
  const Surd h = s.h, stiffness = s.stiffness, damping = s.damping;
  std::vector<std::vector<Surd>> m(n, std::vector<Surd>(n));
  std::vector<Surd> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    m[i][i] = 1;
    Surd sum;
    for (std::size_t j = 0; j < n; ++j) {
      sum += a[i][j];
      if (file.nystroem) {
        m[i][j] -= stiffness * h * h * a[i][j];
        continue;
      }
      m[i][j] -= damping * h * a[i][j];
      for (std::size_t l = 0; l < n; ++l) m[i][l] -= stiffness * h * h * a[i][j] * a[j][l];
    }
    const Surd t = Surd(s.t) + c[i] * h;
    right[i] =
        stiffness * (Surd(s.x) + h * (file.nystroem ? c[i] : sum) * Surd(s.v)) + damping * Surd(s.v) + t * t;
  }
  const auto solution = solve_linear<Surd>(m, right).solution;
  REQUIRE(solution);
  const std::vector<Surd>& k = *solution;
  Surd x = s.x, v = s.v;
  if (file.nystroem) x += h * Surd(s.v);
  for (std::size_t i = 0; i < n; ++i) {
    v += h * b[i] * k[i];
    if (file.nystroem) {
      x += h * h * exact(file.b_position[i]) * k[i];
      continue;
    }
    Surd u = s.v;
    for (std::size_t j = 0; j < n; ++j) u += h * a[i][j] * k[j];
    x += h * b[i] * u;
  }
  return {x, v};
}

double anharmonic(double x, double v, double t) { return x * (1 - x * x) - v * x / 5 + std::cos(t); }

/// The same with doubles for a force that is not linear: the stages by plain iteration.
std::pair<double, double> iterated_step(const TableauFile& file, double h, double x, double v, double t) {
  const std::size_t n = file.stages();
  std::vector<std::vector<double>> a(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a[i][j] = rounded(exact(file.a[i][j]));
  std::vector<double> k(n), u(n, v);
  for (int round = 0; round < 60; ++round) {
    std::vector<double> slopes(n), speeds(n, v);
    for (std::size_t i = 0; i < n; ++i) {
      const double c = rounded(exact(file.c[i]));
      double place = file.nystroem ? x + c * h * v : x;
      for (std::size_t j = 0; j < n; ++j) {
        place += file.nystroem ? h * h * a[i][j] * k[j] : h * a[i][j] * u[j];
        if (!file.nystroem) speeds[i] += h * a[i][j] * k[j];
      }
      slopes[i] = anharmonic(place, file.nystroem ? v : speeds[i], t + c * h);
    }
    k = slopes;
    u = speeds;
  }
  double x1 = file.nystroem ? x + h * v : x, v1 = v;
  for (std::size_t i = 0; i < n; ++i) {
    const double b = rounded(exact(file.b[i]));
    x1 += file.nystroem ? h * h * rounded(exact(file.b_position[i])) * k[i] : h * b * u[i];
    v1 += h * b * k[i];
  }
  return {x1, v1};
}

template <class T>
std::pair<T, T> step_of_program(const Program& program, std::function<T(const T&, const T&, const T&)> force,
                                const T& h, const T& x, const T& v, const T& t) {
  Numbers<T> problem;
  problem.force = std::move(force);
  const Tape tape = lower(program);
  Run<Numbers<T>> run(tape, problem, h);
  run.begin(x, v, t);
  run.step();
  return run.read_out();
}

}  // namespace

TEST_CASE("the bank holds a hundred published methods, each with a source and an order") {
  CHECK(bank().size() >= 100);
  for (const TableauFile& file : bank()) {
    CAPTURE(file.name);
    CHECK_FALSE(file.program.sources.empty());
    CHECK(file.claims.order.has_value());
    CHECK(fs::path(file.program.file).stem() == file.name);
    CHECK(file.program.aliases.empty());
  }
}

TEST_CASE("a method of the bank has as many stages as its authors say") {
  const std::map<std::string, std::size_t> stages{{"euler", 1},
                                                  {"rk4", 4},
                                                  {"fehlberg-45", 6},
                                                  {"dormand-prince-54", 7},
                                                  {"fehlberg-78", 13},
                                                  {"ssprk104", 10},
                                                  {"prince-dormand-87-13m", 13},
                                                  {"verner-76-robust", 10},
                                                  {"lobatto-iiia-6", 4},
                                                  {"kvaerno-5-4", 7},
                                                  {"ark5-4-8l2sa-esdirk", 8},
                                                  {"nystroem-rkn5", 4},
                                                  {"butcher6b", 7},
                                                  {"verner-65-dverk", 8}};
  std::size_t found = 0;
  for (const TableauFile& file : bank()) {
    CAPTURE(file.name);
    CHECK(file.a.size() == file.stages());
    CHECK(file.c.size() == file.stages());
    for (const auto& row : file.a) CHECK(row.size() == file.stages());
    CHECK(file.program.tableau.has_value() != file.nystroem);
    if (file.program.tableau) CHECK(file.program.tableau->b.size() == file.stages());
    if (!stages.contains(file.name)) continue;
    ++found;
    CHECK(file.stages() == stages.at(file.name));
  }
  CHECK(found == stages.size());
}

TEST_CASE("the times of the stages are the row sums, exactly or to the digits printed") {
  for (const TableauFile& file : bank()) {
    if (file.nystroem) continue;
    CAPTURE(file.name);
    const auto a = exact(file.a);
    for (std::size_t i = 0; i < file.stages(); ++i) {
      Surd sum;
      for (const Surd& e : a[i]) sum += e;
      CHECK(near(sum, exact(file.c[i]), slack(file)));
    }
  }
}

TEST_CASE("one step of every method of the bank is what its tableau says, in exact numbers") {
  const Start s;
  for (const TableauFile& file : bank()) {
    CAPTURE(file.name);
    const auto [x, v] = step_of_program<Surd>(
        file.program,
        [&](const Surd& q, const Surd& u, const Surd& t) {
          return Surd(s.stiffness) * q + Surd(s.damping) * u + t * t;
        },
        s.h, s.x, s.v, s.t);
    const auto [x1, v1] = step_of_tableau(file, s);
    CHECK(near(x, x1, slack(file)));
    CHECK(near(v, v1, slack(file)));
    CHECK_FALSE(near(x, Surd(s.x), Surd(Rational(1, 100))));
  }
}

TEST_CASE("one step for an anharmonic force agrees with the tableau in double precision") {
  for (const TableauFile& file : bank()) {
    CAPTURE(file.name);
    const auto [x, v] = step_of_program<double>(file.program, anharmonic, 0.02, 0.7, -0.4, 0.3);
    const auto [x1, v1] = iterated_step(file, 0.02, 0.7, -0.4, 0.3);
    CHECK(x == doctest::Approx(x1).epsilon(2e-13));
    CHECK(v == doctest::Approx(v1).epsilon(2e-13));
  }
}

TEST_CASE("a method of the bank that is in the catalogue too is the same step there") {
  const std::map<std::string, std::string> twins{{"rk4", "rk4"},
                                                 {"dormand-prince-54", "dormand-prince"},
                                                 {"bogacki-shampine-32", "bogacki-shampine"},
                                                 {"gauss6", "gauss6"},
                                                 {"radau-iia-5", "radau-iia-5"},
                                                 {"sdirk4", "sdirk4"},
                                                 {"kutta3", "kutta3"}};
  std::size_t found = 0;
  for (const TableauFile& file : bank()) {
    if (!twins.contains(file.name)) continue;
    ++found;
    CAPTURE(file.name);
    Program expected = find_integrator(twins.at(file.name));
    Program both = expected;
    both.step = file.program.step;
    both.tableau = file.program.tableau;
    CHECK(print(both) == print(expected));
    CHECK(same(both, expected));
  }
  CHECK(found == twins.size());
}

TEST_CASE("what is printed of a tableau file is an integrator that reads back as the same") {
  for (const TableauFile& file : bank()) {
    CAPTURE(file.name);
    CHECK(same(parse(print(file.program), "printed.integrator"), file.program));
  }
}
