// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include "analysis/motion/numeric_motion.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall::numeric {

inline NumericQuestion question(const char* force, const char* h, const char* steps) {
  NumericQuestion q;
  q.force = force_named(force);
  q.h = Rational::parse(h);
  q.x0 = Rational(3, 2);
  q.v0 = Rational(-2, 3);
  q.steps = Rational::parse(steps);
  return q;
}

/// The same by stepping: the interpreter of programs, no matrix.
inline std::pair<Rational, Rational> stepped_exactly(const Program& program, const NumericQuestion& q,
                                                     int steps) {
  const Rational k = q.force.stiffness().constant(), c = q.force.damping().constant();
  Numbers<Rational> problem{[&](const Rational& x, const Rational& v, const Rational& t) {
    Rational f;
    for (int d = q.force.degree; d >= 0; --d) f = f * t + q.force.push.at(d);
    return f - k * x - c * v;
  }};
  const Tape tape = lower(substepped(program, q.substeps), q.parameters);
  Run<Numbers<Rational>> run(tape, problem, q.h);
  run.begin(q.x0, q.v0, 0);
  for (int n = 0; n < steps; ++n) run.step();
  return run.read_out();
}

inline Rational shown(const CertainNumber& n) {
  REQUIRE(n.decimal);
  return Rational::parse(*n.decimal);
}

inline bool near(const Rational& a, const Rational& b, int digits) {
  return (a - b).abs() <= b.abs() * Rational(10).pow(-digits);
}

}  // namespace shortfall::numeric
