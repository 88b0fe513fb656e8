// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/traced.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {
namespace {

std::string body(const Program& p) {
  const std::string text = print(p);
  return text.substr(text.find("\nstep\n") + 6);
}

/// Three steps in a format, under a force that reads everything.
template <class T>
std::vector<T> stepped(const Program& program, const Values& given, const T& h) {
  Numbers<T> problem;
  problem.force = [&problem](const T& x, const T& v, const T& t) {
    return problem.number(Rational(1, 3)) - problem.number(2) * x * x - x * v / problem.number(7) + t;
  };
  const Tape tape = lower(program, given);
  Run<Numbers<T>> run(tape, problem, h);
  run.begin(problem.number(Rational(1, 5)), problem.number(Rational(-2, 3)), problem.number(Rational(1, 4)));
  std::vector<T> seen;
  for (int i = 0; i < 3; ++i) {
    run.step();
    const auto [x, v] = run.read_out();
    seen.push_back(x);
    seen.push_back(v);
  }
  return seen;
}

void same_bits(const Program& a, const Program& b) {
  CAPTURE(print(a));
  CHECK(stepped<double>(a, {}, 0.3) == stepped<double>(b, {}, 0.3));
  CHECK(stepped<float>(a, {}, 0.3F) == stepped<float>(b, {}, 0.3F));
}

TEST_CASE("a loop of C++ becomes the integrator that its author wrote") {
  const Program mine = traced("my-loop", [](auto& x, auto& v, auto t, auto h, auto a) {
    v += h * a(x, v, t);
    x += h * v;
  });
  CHECK(print(mine) == "integrator my-loop\n\nstep\n  v = v + h*a(x, v, t)\n  x = x + h*v\n");
  CHECK(same(parse(print(mine), "again"), mine));
  same_bits(mine, find_integrator("symplectic-euler"));
}

TEST_CASE("formulas of the literature, traced, are the catalogue's to the last bit") {
  same_bits(traced("explicit",
                   [](auto& x, auto& v, auto t, auto h, auto a) {
                     const auto force = a(x, v, t);
                     x += h * v;
                     v += h * force;
                   }),
            find_integrator("explicit-euler"));
  same_bits(traced("drift-kick",
                   [](auto& x, auto& v, auto t, auto h, auto a) {
                     x += h * v;
                     v += h * a(x, v, t + h);
                   }),
            find_integrator("symplectic-euler-drift-kick"));
  const Program verlet = Tracing("verlet")
                             .state("a0", "L/T^2")
                             .start([](auto& x, auto& v, auto t, auto, auto a, auto& carried) {
                               carried.vector("a0") = a(x, v, t);
                             })
                             .step([](auto& x, auto& v, auto t, auto h, auto a, auto& carried) {
                               auto& a0 = carried.vector("a0");
                               x = x + h * v + pow(h, 2) / 2 * a0;
                               const auto a1 = a(x, v + h * a0, t + h);
                               v = v + h / 2 * (a0 + a1);
                               a0 = a1;
                             });
  CHECK(body(verlet) ==
        body(parse(print(find_integrator("velocity-verlet")), "v")).substr(0, body(verlet).size()));
  same_bits(verlet, find_integrator("velocity-verlet"));
}

TEST_CASE("the order of operations is the author's") {
  const auto of = [](auto make) {
    const std::string text =
        body(traced("test", [&](auto& x, auto& v, auto t, auto h, auto) { x += make(h, t) * v; }));
    return text.substr(0, text.find('\n'));
  };
  CHECK(of([](auto h, auto t) { return h + (h + t); }) == "  x = x + (h + (h + t))*v");
  CHECK(of([](auto h, auto t) { return h / (h / t); }) == "  x = x + h/(h/t)*v");
  CHECK(of([](auto h, auto) { return -pow(h, 2) / h; }) == "  x = x + (-h^2/h*v)");
  CHECK(of([](auto h, auto) { return h * Rational(1, 3); }) == "  x = x + h*(1/3)*v");
  CHECK(of([](auto h, auto) { return 0.1 * h; }) == "  x = x + 0.1*h*v");
  CHECK(of([](auto h, auto) { return 0.1F * h; }) == "  x = x + 0.1*h*v");
}

/// Values are what was done to them: a program run so is traced.
struct Traces {
  using Scalar = TracedScalar;
  using Vector = TracedVector;
  TracedForce force;
  const Carried* carried = nullptr;
  const Tape* tape = nullptr;
  Vector nothing;

  Scalar number(const Rational& value) const { return value; }
  std::optional<Scalar> parameter(int index, bool) const {
    return carried->number(tape->parameters[static_cast<std::size_t>(index)].name);
  }
  Vector zero() const { return nothing; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const { return force(x, v, t); }
  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    throw Unable("implicit");
  }
  Scalar function(Function f, const Scalar& a, const Scalar& b) const {
    if (f == Function::sqrt) return sqrt(a);
    if (f == Function::exp) return exp(a);
    if (f == Function::pow) return pow(a, b);
    return f == Function::max ? max(a, b) : min(a, b);
  }
  Scalar root(const RealRoot&, const std::string&) const { throw Unable("root"); }
  bool longer(const Vector&, const Scalar&, bool) const { throw Unable("length"); }
  Vector shortened(const Vector&, const Vector&, const Scalar&) const { throw Unable("length"); }
};

TEST_CASE("every explicit integrator of the catalogue, run on traced values, is traced to the same bits") {
  int traced_ones = 0;
  for (const Program& p : catalogue()) {
    if (!p.states.empty() || p.impulse || p.holds_force || !p.approximations.empty()) continue;
    CAPTURE(p.name);
    const Tape tape = lower(p);
    Tracing tracing("copy");
    for (const Parameter& q : p.parameters)
      tracing.parameter(q.name, parameter_values(p).at(q.name), q.dimension.str());
    const auto run = [&](bool read_out) {
      return [&tape, read_out](TracedVector& x, TracedVector& v, const TracedScalar& t, const TracedScalar& h,
                               TracedForce a, Carried& carried) {
        Traces problem{a, &carried, &tape, v - v};  // NOLINT(misc-redundant-expression): zero is traced
        Run<Traces> steps(tape, problem, h);
        steps.begin(x, v, t);
        if (read_out) {
          std::tie(x, v) = steps.read_out();
          return;
        }
        steps.step();
        x = steps.state(0);
        v = steps.state(1);
      };
    };
    if (!p.start.empty()) continue;
    if (!p.finish.empty()) tracing.finish(run(true));
    try {
      same_bits(tracing.step(run(false)), p);
      ++traced_ones;
    } catch (const Unable&) {  // implicit, a root, a limit
    }
  }
  CHECK(traced_ones >= 15);
}

TEST_CASE("parameters, assumptions and what is meant") {
  const Program damped = Tracing("damped")
                             .parameter("c", Rational(1, 10), "1/T")
                             .assume("1 - c*h > 0")
                             .solves("a(x, v, t) - c*v")
                             .step([](auto& x, auto& v, auto t, auto h, auto a, auto& carried) {
                               v = (v + h * a(x, v, t)) * max(0, 1 - carried.number("c") * h);
                               x += h * v;
                             });
  CHECK(damped.parameter("c") != nullptr);
  CHECK(damped.assumptions.size() == 1);
  CHECK(body(damped) == "  v = (v + h*a(x, v, t))*max(0, 1 - c*h)\n  x = x + h*v\n");
}

TEST_CASE("what was rounded, kept or never given is refused in a sentence") {
  const auto refused = [](auto step) -> std::string {
    try {
      traced("test", step);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  CHECK(refused([](auto& x, auto& v, auto, auto h, auto) { x += 1.0 / 3 * h * v; }) ==
        "the floating-point number 0.3333333333333333 is not exact; write shortfall::Rational(1, 3), or "
        "divide by 3");
  CHECK(refused([](auto& x, auto& v, auto, auto h, auto) { x += 1.0F / 6 * h * v; }).find("Rational(1, 6)") !=
        std::string::npos);
  CHECK(refused([](auto& x, auto& v, auto, auto h, auto) { x += std::sqrt(2.0) * h * v; }).find("sqrt") !=
        std::string::npos);
  CHECK(refused([](auto& x, auto& v, auto, auto h, auto) {
          std::decay_t<decltype(v)> k;
          x += h * k;
        }) == "the step reads a value before it gives it one");
  int calls = 0;
  CHECK(refused([&](auto& x, auto& v, auto, auto h, auto) { x += ++calls * h * v; }).find("called again") !=
        std::string::npos);
  std::vector<TracedVector> kept;
  CHECK(refused([&](auto& x, auto& v, auto t, auto h, auto a) {
          kept.push_back(a(x, v, t));
          v += h * kept.front();
        }).find("earlier call") != std::string::npos);
  CHECK(refused([](auto& x, auto& v, auto, auto, auto) {
          x += v;
        }).find("cannot add vector [L] and vector [L T^-1]") != std::string::npos);
  CHECK_THROWS_AS(Tracing("test").state("a0", "L/T^2").step([](auto&, auto&, auto, auto, auto) {}), BadInput);
}

TEST_CASE("what would depend on values does not compile, and the message says what to write") {
  namespace fs = std::filesystem;
  if (std::system("command -v g++ >/dev/null 2>&1") != 0) {
    MESSAGE("skipped: g++ is not installed");
    return;
  }
  const fs::path folder = fs::temp_directory_path() / ("shortfall-traced-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "wrong.cpp") << "#include \"analysis/program/traced.hpp\"\n"
                                         "using namespace shortfall;\n"
                                         "void f(TracedScalar h, TracedVector v) {\n"
                                         "  if (h) {}\n"
                                         "  if (h > 0) {}\n"
                                         "  (void)v[0];\n"
                                         "  (void)(v * v);\n"
                                         "  (void)(h + true);\n"
                                         "}\n"
                                         "#ifdef CONVERTS\n"
                                         "double g(TracedScalar h) { return h; }\n"
                                         "#endif\n";
  const auto said = [&](const std::string& flags) {
    const std::string out = (folder / "said").string();
    const int code =
        std::system(("g++ -std=c++20 -fsyntax-only " + flags + " -I'" SHORTFALL_SOURCE_DIR "' '" +
                     (folder / "wrong.cpp").string() + "' > '" + out + "' 2>&1")
                        .c_str());
    CHECK(code != 0);
    std::ifstream in(out);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string text = said("-DCONVERTS");
  for (const char* message : {"a step may not branch on it", "a step may not compare traced values",
                              "a traced vector has no components", "two vectors may not be multiplied",
                              "true and false are no numbers", "cannot convert"})
    CHECK_MESSAGE(text.find(message) != std::string::npos, message << "\n" << text);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace shortfall
