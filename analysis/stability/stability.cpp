// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability.hpp"

#include <algorithm>
#include <functional>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

/// The same windows in another unit: every edge is mapped.
void map_edges(Windows& windows, const std::function<RealRoot(const RealRoot&)>& map) {
  for (Window& w : windows.windows) {
    const bool point = w.is_point();
    if (w.from) w.from->at = map(w.from->at);
    if (w.to) w.to->at = point ? w.from->at : map(w.to->at);
  }
}

/// A number with a dimension, such as a damping per second, must be 0 or not occur in the step at all, as a
/// speed limit does not.
void check_dimensions(const Program& program, const Values& parameters) {
  const auto plain = [&](const Parameter& p) {
    return p.dimension == kPure || parameters.at(p.name).is_zero();
  };
  Values fixed;
  for (const Parameter& p : program.parameters)
    if (plain(p)) fixed[p.name] = parameters.at(p.name);
  if (fixed.size() == program.parameters.size()) return;
  const Amplification a = amplification(program, fixed, Damping::none, FreeFunctions::letters);
  for (std::size_t i = 0; i < program.parameters.size(); ++i) {
    const Parameter& p = program.parameters[i];
    const auto has_it = [&](const Fraction& f) {
      return f.contains(kFirstParameter + static_cast<Letter>(i));
    };
    for (const auto& row : a.matrix)
      if (!plain(p) && std::ranges::any_of(row, has_it))
        throw Unable("the step of " + program.name + " depends on h not only through h w and c h, because " +
                     p.name + " " + p.dimension.bracketed() +
                     " is not 0: say how long the step is, with --dt, or give --param " + p.name + "=0");
  }
}

Windows windows_of(const Amplification& a, int substeps) {
  Windows windows = bounded_windows(a.matrix, kStiffness, a.algebraic);
  map_edges(windows, [&](const RealRoot& y) { return scaled(square_root(y), substeps); });
  return windows;
}

}  // namespace

const RealRoot* Stability::limit() const {
  const WindowEdge* edge = windows.limit();
  return edge ? &edge->at : nullptr;
}

Windows oscillator_windows(const Amplification& a) { return windows_of(a, 1); }

Windows oscillator_windows(const Program& program, const Values& given) {
  const Values parameters = parameter_values(program, given);
  check_dimensions(program, parameters);
  return windows_of(amplification(program, parameters), 1);
}

std::optional<RealRoot> stability_limit(const Program& program, const Values& given) {
  return stability_limit(oscillator_windows(program, given));
}

std::optional<RealRoot> stability_limit(const Windows& windows) {
  if (!windows.from_zero()) return RealRoot(0);
  if (const WindowEdge* edge = windows.limit()) return edge->at;
  return std::nullopt;
}

Stability stability(const Program& program, const Values& given, int substeps,
                    const std::optional<Rational>& dt) {
  Stability s;
  s.integrator = program.name;
  s.substeps = substeps;
  s.parameters = parameter_values(program, given);
  s.dt = dt;
  if (!dt) check_dimensions(program, s.parameters);
  std::set<std::string> rounded;
  const auto numbers = [&](Damping damping) {
    return dt ? amplification_at(program, s.parameters, *dt / substeps, damping, &rounded)
              : amplification(program, s.parameters, damping);
  };
  // Formulas say pow(9/10, 1/60) rather than its digits.
  const auto formulas = [&](Damping damping, const Amplification& in_numbers) {
    if (rounded.empty()) return in_numbers;
    Amplification letters = amplification_at(program, s.parameters, *dt / substeps, damping);
    return letters.pair.empty() ? in_numbers : letters;
  };
  for (const Parameter& p : program.parameters)
    if (!given.contains(p.name)) s.assumed.push_back(p.name);
  s.of_substep = substeps > kSubstepsInFormulas;
  const int written = s.of_substep ? 1 : substeps;
  // Powers of a frame's matrix are powers of a substep's: they are bounded together.
  try {
    s.numbers = numbers(Damping::none);
  } catch (const Undefined& e) {
    throw Undefined("there is no step of " + program.name + " with these parameters" +
                    (dt ? " and dt = " + dt->str() + " s: " : ": ") + e.what());
  }
  s.undamped = repeated(dt ? formulas(Damping::none, s.numbers) : amplification(program, given), written);
  s.windows = windows_of(s.numbers, substeps);
  if (const WindowEdge* edge = s.windows.limit(); edge && !edge->pole) {
    s.at_limit = edge->growth;
    if (const auto square = edge->at.rational_square(); square && !s.of_substep && !dt)
      s.limit_motion = limit_motion(program, s.parameters, substeps, *square);
  }
  Amplification runaway = s.numbers;
  for (auto& row : runaway.matrix)
    for (Fraction& f : row) f = f.substitute(kStiffness, -Fraction::letter(kStiffness));
  s.runaway = windows_of(runaway, substeps);
  try {
    const Amplification damped = numbers(Damping::viscous);
    s.drag = drag(damped);
    map_edges(s.drag->windows, [&](const RealRoot& d) { return scaled(d, substeps); });
    for (Drag::Reversal& r : s.drag->reversals) {
      r.from = scaled(r.from, substeps);
      if (r.to) r.to = scaled(*r.to, substeps);
    }
    s.damped = repeated(formulas(Damping::viscous, damped), written);
    if (!dt) s.function = stability_function(program, s.parameters);
  } catch (const Undefined&) {
    // A stage that drag alone makes singular: there is nothing to report about it.
  }
  if (s.function) s.properties = stability_properties(*s.function);
  s.rounded.assign(rounded.begin(), rounded.end());
  return s;
}

}  // namespace shortfall
