// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/story.hpp"

#include <algorithm>
#include <set>

#include "analysis/motion/spectrum.hpp"

namespace shortfall {

namespace {

LinearForm drive_of(const StepMap& map, const LinearForm& row) {
  LinearForm drive;
  for (int c = map.force.states; c < row.columns(); ++c)
    if (!row[c].is_zero()) drive.at(c) = row[c];
  return drive;
}

/// The carried vectors that the read-out depends on, directly or through others.
std::set<int> seen_states(const StepMap& map) {
  std::set<int> seen;
  std::vector<int> todo;
  auto visit = [&](const LinearForm& row) {
    for (int s = 0; s < map.force.states; ++s)
      if (!row[s].is_zero() && seen.insert(s).second) todo.push_back(s);
  };
  visit(map.position);
  visit(map.velocity);
  while (!todo.empty()) {
    const int s = todo.back();
    todo.pop_back();
    visit(map.step[s]);
  }
  return seen;
}

class Teller {
 public:
  explicit Teller(const StepMap& map) : map_(map), left_(seen_states(map)) {}

  std::vector<Quantity> told() {
    while (!left_.empty()) {
      const auto next = std::ranges::find_if(left_, [&](int s) { return is_ready(s, {s}); });
      if (next != left_.end())
        tell(*next);
      else if (!tell_pair())
        tell_rest();
    }
    return std::move(told_);
  }

 private:
  /// Whether a row depends on nothing that is still untold, but for the allowed ones.
  bool is_ready(int s, const std::set<int>& allowed) const {
    return std::ranges::all_of(left_,
                               [&](int j) { return allowed.contains(j) || map_.step[s][j].is_zero(); });
  }

  void add_weights(Quantity& q, const LinearForm& row, const std::set<int>& except) const {
    for (int j = 0; j < map_.force.states; ++j)
      if (!row[j].is_zero() && !except.contains(j)) q.weights.emplace_back(place_.at(j), row[j]);
  }

  void tell(int s) {
    Quantity q{map_.states[s], LinearForm::column(s), map_.step[s][s], {}, drive_of(map_, map_.step[s])};
    add_weights(q, map_.step[s], {s});
    place_[s] = static_cast<int>(told_.size());
    told_.push_back(std::move(q));
    left_.erase(s);
  }

  /// Two vectors p, q that depend on each other with (M - 1)^2 = 0: the increase d = (M - 1) p is a sum of
  /// forces, p the sum of d.
  bool tell_pair() {
    for (int p : left_)
      for (int q : left_) {
        if (p == q || map_.step[p][q].is_zero() || !is_ready(p, {p, q}) || !is_ready(q, {p, q})) continue;
        const Fraction a = map_.step[p][p] - Fraction(1);
        const Fraction& b = map_.step[p][q];
        const Fraction& c = map_.step[q][p];
        const Fraction d = map_.step[q][q] - Fraction(1);
        const bool nilpotent = (a + d).is_zero() && (a * d - b * c).is_zero();
        if (!nilpotent) continue;
        LinearForm definition;
        definition.at(p) = a;
        definition.at(q) = b;
        const LinearForm change = a * map_.step[p] + b * map_.step[q];
        Quantity increase{free_name(), definition, 1, {}, drive_of(map_, change)};
        add_weights(increase, change, {p, q});
        const int place = static_cast<int>(told_.size());
        told_.push_back(std::move(increase));
        Quantity position{
            map_.states[p], LinearForm::column(p), 1, {{place, 1}}, drive_of(map_, map_.step[p])};
        add_weights(position, map_.step[p], {p, q});
        place_[p] = static_cast<int>(told_.size());
        told_.push_back(std::move(position));
        left_.erase(p);
        // The partner follows from p and d; it is told only when somebody else needs it.
        left_.erase(q);
        place_[q] = -1;
        if (partner_is_needed(q)) {
          Quantity partner{map_.states[q], LinearForm::column(q), 0, {}, {}, false};
          place_[q] = static_cast<int>(told_.size());
          told_.push_back(std::move(partner));
        }
        return true;
      }
    return false;
  }

  bool partner_is_needed(int q) const {
    if (!map_.position[q].is_zero() || !map_.velocity[q].is_zero()) return true;
    return std::ranges::any_of(left_, [&](int s) { return !map_.step[s][q].is_zero(); });
  }

  std::string free_name() const {
    std::string name = "d";
    while (std::ranges::find(map_.states, name) != map_.states.end() ||
           std::ranges::find(map_.letters, name) != map_.letters.end())
      name += "d";
    return name;
  }

  void tell_rest() {
    for (int s : left_) {
      place_[s] = static_cast<int>(told_.size());
      told_.push_back({map_.states[s], LinearForm::column(s), 0, {}, {}, false});
    }
    left_.clear();
  }

  const StepMap& map_;
  std::set<int> left_;
  std::map<int, int> place_;
  std::vector<Quantity> told_;
};

}  // namespace

std::vector<Quantity> story(const StepMap& map) { return Teller(map).told(); }

}  // namespace shortfall
