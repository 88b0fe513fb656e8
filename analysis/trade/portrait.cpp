// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/portrait.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/trade/interpreted_run.hpp"

namespace shortfall {

namespace {

constexpr double kOutOfSight = 1e12;  // more than this, and the motion has run away

Program of_a_frame(const Program& program, const PortraitQuestion& q) {
  return q.substeps > 1 ? substepped(program, q.substeps) : program;
}

double to_power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

/// As many primes as the modified energy and the force read.
int most_primes(const ModifiedHamiltonian& modified) {
  std::size_t most = 1;
  for (const EnergyTerm& t : modified.terms) most = std::max(most, t.in_one_dimension.size() - 1);
  return static_cast<int>(most);
}

/// The step that has the series, with what was switched off for it: both energies are those of one step.
PortraitOrbit orbit(const SeriesSource& source, const PortraitQuestion& q, EnergySurfaces& surfaces,
                    const PortraitQuestion::Start& start) {
  const auto force = [&](std::span<const double> x, std::span<const double>, double, std::span<double> a) {
    a[0] = surfaces.force(x[0]);
  };
  const auto run =
      interpreted_run<double>(source.program(), source.values(), q.h, 1, ForceReference<double>(force));
  double x = start.x.to_double(), v = start.v.to_double();
  run->begin({&x, 1}, {&v, 1}, 0);
  PortraitOrbit o;
  for (int frame = 0;; ++frame) {
    // What `start` and `finish` do belongs to the integrator; what the user gave is shown as it was given.
    if (frame > 0) {
      run->run(1);
      run->read_out({&x, 1}, {&v, 1});
    }
    const bool in_sight = std::fabs(x) < kOutOfSight && std::fabs(v) < kOutOfSight;
    const EnergySurfaces::Values e = in_sight ? surfaces.at(x, v) : EnergySurfaces::Values{};
    if (!in_sight || !std::isfinite(e.energy) || !std::isfinite(e.modified)) {
      if (frame == 0)
        throw Undefined("the potential, or a derivative of it, has no value at the start, x = " +
                        start.x.str());
      o.lost = frame;
      o.no_number = in_sight || std::isnan(x) || std::isnan(v);
      return o;
    }
    o.x.push_back(x);
    o.v.push_back(v);
    o.energy.push_back(e.energy);
    o.modified.push_back(e.modified);
    if (frame == q.steps) return o;
  }
}

}  // namespace

EnergySurfaces::EnergySurfaces(const Expr& potential, const ModifiedHamiltonian& modified,
                               const SeriesSource& source, double h)
    : tape_(potential_tape(potential, most_primes(modified))),
      derivatives_(static_cast<std::size_t>(most_primes(modified)) + 1) {
  if (!modified.exists()) return;
  for (const EnergyTerm& t : modified.terms)
    terms_.push_back({source.to_double(t.coefficient) * to_power(h, t.power), t.in_one_dimension});
}

const std::vector<double>& EnergySurfaces::derivatives(double x) {
  if (known_at_ != x) {
    const double nothing = 0;
    tape_(&x, &nothing, nothing, 1, derivatives_.data());
    known_at_ = x;
  }
  return derivatives_;
}

double EnergySurfaces::force(double x) { return -derivatives(x)[1]; }

EnergySurfaces::Values EnergySurfaces::at(double x, double v) {
  const std::vector<double>& d = derivatives(x);
  const double energy = v * v / 2 + d[0];
  double more = 0;
  for (const Term& t : terms_) {
    double term = t.factor;
    for (std::size_t i = 0; i < t.factors.size(); ++i) term *= to_power(i == 0 ? v : d[i], t.factors[i]);
    more += term;
  }
  return {energy, energy + more};
}

double PortraitOrbit::largest_change(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::fabs(value - values.front()));
  return most;
}

Portrait portrait(const Program& program, const PortraitQuestion& q) {
  if (q.starts.empty()) throw BadInput("a portrait needs a start");
  const Program frame = of_a_frame(program, q);
  const SeriesSource source(frame, q.parameters);
  Portrait p{program.name, q, modified_hamiltonian(source, q.order), source.notes(), {}};
  EnergySurfaces surfaces(q.potential, p.hamiltonian, source, q.h.to_double());
  for (const PortraitQuestion::Start& start : q.starts) p.orbits.push_back(orbit(source, q, surfaces, start));
  return p;
}

EnergySurfaces surfaces_of(const Portrait& p, const Program& program) {
  const SeriesSource source(of_a_frame(program, p.question), p.question.parameters);
  return EnergySurfaces(p.question.potential, p.hamiltonian, source, p.question.h.to_double());
}

}  // namespace shortfall
