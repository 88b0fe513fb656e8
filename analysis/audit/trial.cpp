// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/trial.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

namespace {

template <class K>
class Attempt {
 public:
  Attempt(const Trial& trial, const Method<K>& m, const Conditions& conditions)
      : trial_(trial), m_(m), conditions_(conditions) {
    // What is printed there is doubted: its digits are no information.
    if constexpr (std::is_same_v<K, KnownDigits>)
      for (const auto& unknown : trial.unknowns)
        for (const Trial::Step& s : unknown) m_.at(s.cell) = KnownDigits(m_.at(s.cell).ball().midpoint());
  }

  std::optional<Outcome<K>> operator()() {
    if (!trial_.exchanged.empty()) return exchanged();
    before_ = conditions_.defects(m_);
    return trial_.unknowns.size() == 1 ? one_unknown() : two_unknowns();
  }

  bool excluded() {
    if (!trial_.exchanged.empty()) return !exchanged();
    before_ = conditions_.defects(m_);
    if (trial_.unknowns.size() > 1) return !two_unknowns() && !open_;
    const Solution s = solution();
    return s.impossible || (s.amount && !hold(moved({*s.amount})));
  }

 private:
  Method<K> moved(const std::vector<K>& amounts) const {
    Method<K> m = m_;
    for (std::size_t u = 0; u < amounts.size(); ++u)
      for (const Trial::Step& s : trial_.unknowns[u]) m.at(s.cell) += K(s.times) * amounts[u];
    follow(m);
    return m;
  }
  void follow(Method<K>& m) const {
    if (!trial_.c_follows) return;
    for (std::size_t i = 0; i < m.stages(); ++i) {
      m.c[i] = K(0);
      for (const K& k : m.a[i]) m.c[i] += k;
    }
  }
  bool hold(const Method<K>& m) const {
    return std::ranges::all_of(conditions_.defects(m), [](const K& k) { return is_nothing(k); });
  }

  std::optional<Outcome<K>> exchanged() {
    Method<K> m = m_;
    bool differs = false;
    for (const auto& [one, other] : trial_.exchanged) {
      differs = differs || !is_nothing(m.at(one) - m.at(other));
      std::swap(m.at(one), m.at(other));
    }
    if (!differs) return std::nullopt;
    follow(m);
    const std::vector<K> after = conditions_.defects(m);
    if (!std::ranges::all_of(after, [](const K& k) { return is_nothing(k); })) return std::nullopt;
    const std::vector<K> before = conditions_.defects(m_);
    int changed = 0;
    for (std::size_t k = 0; k < after.size(); ++k) changed += !is_nothing(before[k] - after[k]);
    return Outcome<K>{std::move(m), changed};
  }

  /// The better of two values: of known digits the one with more.
  static bool is_better(const K& value, const std::optional<K>& than) {
    if (!than) return true;
    if constexpr (std::is_same_v<K, KnownDigits>) return value.digits() > than->digits();
    return false;
  }

  struct Solution {
    bool impossible = false;  ///< a condition fails, whatever the entry is
    std::optional<K> amount;
    int dependent = 0;
  };
  Solution solution() const {
    const std::vector<K> one = conditions_.defects(moved({K(1)})), two = conditions_.defects(moved({K(2)}));
    Solution result;
    for (std::size_t k = 0; k < before_.size(); ++k) {
      const K first = one[k] - before_[k], second = two[k] - one[k];
      if (is_nothing(first) && is_nothing(second)) {
        result.impossible = result.impossible || !is_nothing(before_[k]);
        continue;
      }
      ++result.dependent;
      if (is_nothing(first) || !is_nothing(second - first)) continue;
      const K value = (K(0) - before_[k]) / first;
      if (is_better(value, result.amount)) result.amount = value;
    }
    return result;
  }

  std::optional<Outcome<K>> one_unknown() const {
    const Solution s = solution();
    if (s.impossible || !s.amount || is_nothing(*s.amount)) return std::nullopt;
    Method<K> m = moved({*s.amount});
    if (!hold(m)) return std::nullopt;
    return Outcome<K>{std::move(m), s.dependent - 1};
  }

  std::optional<Outcome<K>> two_unknowns() {
    const std::vector<K> one = conditions_.defects(moved({K(1), K(0)})),
                         two = conditions_.defects(moved({K(0), K(1)}));
    std::vector<std::size_t> dependent;
    for (std::size_t k = 0; k < before_.size(); ++k) {
      if (!is_nothing(one[k] - before_[k]) || !is_nothing(two[k] - before_[k]))
        dependent.push_back(k);
      else if (!is_nothing(before_[k]))
        return std::nullopt;
    }
    for (std::size_t p = 1; p < dependent.size(); ++p) {
      const std::size_t j = dependent[0], k = dependent[p];
      const K a = one[j] - before_[j], b = two[j] - before_[j], c = one[k] - before_[k],
              d = two[k] - before_[k], determinant = a * d - b * c;
      if (is_nothing(determinant)) continue;
      const K x = (b * before_[k] - d * before_[j]) / determinant,
              y = (c * before_[j] - a * before_[k]) / determinant;
      if (is_nothing(x) || is_nothing(y)) return std::nullopt;  // one would do
      Method<K> m = moved({x, y});
      if (!hold(m)) return std::nullopt;
      return Outcome<K>{std::move(m), static_cast<int>(dependent.size()) - 2};
    }
    open_ = true;
    return std::nullopt;
  }

  const Trial& trial_;
  Method<K> m_;
  const Conditions& conditions_;
  std::vector<K> before_;
  bool open_ = false;  ///< the conditions are too few to give two unknowns
};

}  // namespace

std::vector<Cell> Trial::touched() const {
  std::vector<Cell> all;
  for (const auto& unknown : unknowns)
    for (const Step& s : unknown) all.push_back(s.cell);
  for (const auto& [one, other] : exchanged) {
    all.push_back(one);
    all.push_back(other);
  }
  return all;
}

template <class K>
std::optional<Outcome<K>> outcome(const Trial& trial, const Method<K>& m, const Conditions& conditions) {
  return Attempt<K>(trial, m, conditions)();
}

template <class K>
bool is_excluded(const Trial& trial, const Method<K>& m, const Conditions& conditions) {
  return Attempt<K>(trial, m, conditions).excluded();
}

template bool is_excluded(const Trial&, const Method<Modular>&, const Conditions&);
template bool is_excluded(const Trial&, const Method<KnownDigits>&, const Conditions&);
template std::optional<Outcome<Rational>> outcome(const Trial&, const Method<Rational>&, const Conditions&);
template std::optional<Outcome<Modular>> outcome(const Trial&, const Method<Modular>&, const Conditions&);
template std::optional<Outcome<Fraction>> outcome(const Trial&, const Method<Fraction>&, const Conditions&);
template std::optional<Outcome<KnownDigits>> outcome(const Trial&, const Method<KnownDigits>&,
                                                     const Conditions&);

}  // namespace shortfall
