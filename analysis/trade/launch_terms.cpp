// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/launch_terms.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/nilpotent.hpp"
#include "analysis/trade/tape_run.hpp"

namespace shortfall {

std::string force_read_by(const SmoothTape& tape) {
  const int m = static_cast<int>(tape.outputs.size());
  bool velocity = false, time = false;
  const auto note = [&](int node) {
    velocity = velocity || (node >= m && node < 2 * m);
    time = time || node == 2 * m;
  };
  for (int output : tape.outputs) note(output);
  for (const SmoothTape::Node& n : tape.nodes) {
    if (n.op == SmoothTape::Op::input || n.op == SmoothTape::Op::constant) continue;
    note(n.a);
    if (n.op < SmoothTape::Op::negate || n.op == SmoothTape::Op::power) note(n.b);
  }
  return std::string("a(x") + (velocity ? ", v" : "") + (time ? ", t" : "") + ")";
}

std::optional<Processing> launch_for(const Program& program, const Values& parameters,
                                     const std::string& forces) {
  ProcessingQuestion question;
  question.forces = &force_class(forces);
  question.highest = 4;
  Processing found = processing(SeriesSource(program, parameters), question);
  const auto is_number = [](const FieldTerm& t) { return t.coefficient.is_constant(); };
  if (found.effective_order <= found.plain_order || found.launch.empty()) return std::nullopt;
  if (!std::ranges::all_of(found.launch, is_number) || !std::ranges::all_of(found.read_out, is_number))
    return std::nullopt;
  return found;
}

LaunchTerms::LaunchTerms(SmoothTape acceleration, const std::vector<FieldTerm>& terms)
    : tape_(std::move(acceleration)) {
  for (const FieldTerm& t : terms) {
    std::size_t next = 0;
    terms_.push_back(
        {t.component == "v", t.power, double_double(t.coefficient.constant()), tree(t.tree, next)});
  }
}

/// "a[v[a],1]".
LaunchTerms::Tree LaunchTerms::tree(const std::string& text, std::size_t& next) {
  Tree result{text.at(next++), {}};
  if (next >= text.size() || text[next] != '[') return result;
  do {
    ++next;  // '[' or ','
    result.children.push_back(tree(text, next));
  } while (text.at(next) == ',');
  ++next;  // ']'
  return result;
}

void LaunchTerms::add(Vector& x, Vector& v, const DoubleDouble& t, const DoubleDouble& h) const {
  const Vector x0 = x, v0 = v;
  for (const Term& term : terms_) {
    const Vector d = differential(term.tree, {x0, v0, t});
    DoubleDouble weight = term.coefficient;
    for (int k = 0; k < term.power; ++k) weight = weight * h;
    Vector& target = term.of_velocity ? v : x;
    for (std::size_t i = 0; i < d.size(); ++i) target[i] = target[i] + weight * d[i];
  }
}

LaunchTerms::Vector LaunchTerms::differential(const Tree& tree, const At& at) const {
  if (tree.root == '1') return Vector(1, DoubleDouble(1));
  if (tree.root == 'a') return derivative(tree, at);
  // The drift x' = v: itself, or its only derivative in the direction of a velocity.
  return tree.children.empty() ? at.v : differential(tree.children[0], at);
}

/// A derivative of the force in the directions of the children.
LaunchTerms::Vector LaunchTerms::derivative(const Tree& tree, const At& at) const {
  if (tree.children.empty()) {
    Vector result(at.x.size());
    std::vector<DoubleDouble> work(tape_.nodes.size());
    run_tape(tape_, at.x.data(), at.v.data(), at.t, static_cast<int>(at.x.size()), double_double, work,
             result.data());
    return result;
  }
  using Number = Nilpotent<DoubleDouble>;
  const int directions = static_cast<int>(tree.children.size());
  std::vector<Number> x, v;
  for (const DoubleDouble& value : at.x) x.emplace_back(directions, value);
  for (const DoubleDouble& value : at.v) v.emplace_back(directions, value);
  Number t(directions, at.t);
  for (int k = 0; k < directions; ++k) {
    const Tree& child = tree.children[static_cast<std::size_t>(k)];
    const Vector direction = differential(child, at);
    const std::size_t part = std::size_t{1} << k;
    if (child.root == '1') {
      t.part(part) = direction[0];
      continue;
    }
    std::vector<Number>& target = child.root == 'v' ? x : v;
    for (std::size_t i = 0; i < direction.size(); ++i) target[i].part(part) = direction[i];
  }
  const auto number = [&](const Rational& r) { return Number(directions, double_double(r)); };
  std::vector<Number> out(at.x.size());
  std::vector<Number> work(tape_.nodes.size());
  run_tape(tape_, x.data(), v.data(), t, static_cast<int>(x.size()), number, work, out.data());
  Vector result;
  for (const Number& n : out) result.push_back(n.part(n.size() - 1));
  return result;
}

}  // namespace shortfall
