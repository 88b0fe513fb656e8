// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/tableau_mends.hpp"

#include <algorithm>
#include <set>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/audit/slip.hpp"
#include "analysis/audit/trials.hpp"
#include "analysis/audit/written.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tableau.hpp"

namespace shortfall {

namespace {

using Verdict = AuditClaim::Verdict;

constexpr int kSearchOrder =
    10;  // of the trees that a search looks at; what it finds is decided to the claimed order
constexpr int kQuickOrder = 3;       // most trials fail here already
constexpr double kWithoutCheck = 4;  // a value that nothing confirms
constexpr double kClaim = 7;         // a claim that is wrong, rather than a coefficient
constexpr double kNotAll = 3;        // claims are left that do not hold
constexpr double kNeighbour = 1.9;
constexpr double kLongText = 0.05;  // for each character of a number that is not that of its neighbour
constexpr double kElsewhere = 0.3;  // tableaus repeat their numbers
constexpr double kLongTime = 0.02;  // for each digit of the time of a stage: authors like simple times

template <class K>
Expr as_expression(const AuditedTableau& t, const K& value) {
  if constexpr (std::is_same_v<K, Rational>)
    return number(value);
  else if constexpr (std::is_same_v<K, Fraction>)
    return formula(value, Wording{t.extras->names()});
  else
    return number(value.ball().midpoint());
}

/// The same with other numbers in some places.
template <class K>
AuditedTableau mended(const AuditedTableau& t, const Method<K>& m, const std::vector<Cell>& where) {
  AuditedTableau result = t;
  if constexpr (std::is_same_v<K, Rational>)
    result.rational = m;
  else if constexpr (std::is_same_v<K, Fraction>)
    result.roots = m;
  else
    result.digits = m;
  if (!t.program.tableau) return result;
  for (const Cell& cell : where) {
    Tableau& tableau = *result.program.tableau;
    if (cell.part == Cell::Part::a) {
      auto& row = tableau.a[cell.i];
      while (row.size() <= cell.j) row.push_back(number(0));
      row[cell.j] = as_expression(t, m.at(cell));
    } else if (cell.part == Cell::Part::b) {
      tableau.b[cell.i] = as_expression(t, m.at(cell));
    } else if (cell.part == Cell::Part::c) {
      tableau.c[cell.i] = as_expression(t, m.at(cell));
    }
  }
  result.program.step.clear();
  lower_tableau(result.program, Source(t.program.file, ""));
  return result;
}

/// What prefilters are made with.
template <class K>
struct Search;
template <>
struct Search<Rational> {
  using Number = Modular;
  static Method<Modular> numbers(const AuditedTableau& t) {
    return converted<Modular>(t.rational, [](const Rational& r) { return Modular(r); });
  }
};
template <>
struct Search<Fraction> {
  using Number = KnownDigits;
  static Method<KnownDigits> numbers(const AuditedTableau& t) { return t.digits; }
};
template <>
struct Search<KnownDigits> {
  using Number = KnownDigits;
  static Method<KnownDigits> numbers(const AuditedTableau& t) { return t.digits; }
};

template <class K>
class TableauMends {
 public:
  TableauMends(const AuditedTableau& t, const Method<K>& m, const TableauFindings& found,
               const AuditLimits& limits)
      : t_(t), m_(m), found_(found), limits_(limits), fast_(Search<K>::numbers(t)) {}

  std::vector<Mend> operator()() {
    for (const AuditClaim& c : found_.claims)
      if (c.verdict == Verdict::refuted) refuted_.insert(c.claim);
    if (refuted_.empty()) return {};
    for (const Demands& demands : demand_sets()) {
      for (const bool twofold : {false, true}) {
        search(demands, twofold ? double_slips(t_) : single_slips(t_));
        if (!mends_.empty()) break;
      }
      if (std::ranges::any_of(mends_, [](const Mend& mend) { return mend.restores == kEveryClaim; })) break;
    }
    // Nobody doubts the claims when one slip explains everything and is confirmed.
    const bool explained = std::ranges::any_of(mends_, [](const Mend& mend) {
      return mend.restores == kEveryClaim && mend.checks > 0 && mend.cost < kClaim;
    });
    for (const AuditClaim& c : found_.claims)
      if (c.verdict == Verdict::refuted && c.stated && !explained) {
        Mend mend{Mend::Kind::claim,
                  {{c.claim, c.claim, c.found}},
                  "the claim is wrong",
                  "this claim",
                  0,
                  c.digits,
                  kClaim};
        mends_.push_back(std::move(mend));
      }
    std::ranges::stable_sort(mends_, {}, &Mend::cost);
    if (mends_.size() > kMostMends) mends_.resize(kMostMends);
    return std::move(mends_);
  }

 private:
  bool is_refuted(const std::string& beginning) const {
    return std::ranges::any_of(refuted_, [&](const std::string& c) { return c.starts_with(beginning); });
  }

  /// What may be asked of a mended tableau: all claims; or, when more than one thing is wrong, some of them.
  std::vector<Demands> demand_sets() const {
    Demands all = demands_of(t_);
    all.order = std::min(all.order, kSearchOrder);
    all.embedded_order = std::min(all.embedded_order, kSearchOrder);
    std::vector<Demands> sets{all};
    // Claims that are too low are wrong themselves.
    Demands plain = all;
    if (is_refuted("stage order")) plain.stage_order = 0;
    if (is_refuted("symplectic")) plain.symplectic = false;
    if (is_refuted("symmetric")) plain.symmetric = false;
    if (is_refuted("stage order") || is_refuted("symplectic") || is_refuted("symmetric"))
      sets.push_back(plain);
    if (is_refuted("embedded order") && (is_refuted("order") || is_refuted("c = A 1"))) {
      sets.push_back(plain);
      sets.back().embedded_order = 0;
      sets.push_back({0, all.embedded_order, 0, false, false, false});
    }
    if (all.order == 0 && is_refuted("c = A 1")) {
      // No order is claimed: the highest that one entry can make.
      sets.clear();
      const int most = static_cast<int>(std::min<std::size_t>(2 * t_.stages(), 8));
      for (int order = most; order >= 1; --order) {
        sets.push_back(all);
        sets.back().order = order;
      }
    }
    return sets;
  }

  void search(const Demands& demands, const std::vector<Trial>& trials) {
    Demands quick = demands;
    quick.order = std::min(quick.order, kQuickOrder);
    quick.embedded_order = std::min(quick.embedded_order, kQuickOrder);
    const Conditions low(quick, t_.stages(), t_.nystroem, limits_.most_bytes);
    const Conditions conditions(demands, t_.stages(), t_.nystroem, limits_.most_bytes);
    int done = 0;
    for (const Trial& trial : trials) {
      if (limits_.progress)
        limits_.progress("looking for misprints", ++done, static_cast<int>(trials.size()));
      try {
        if (is_excluded(trial, fast_, low)) continue;
        if (!outcome(trial, fast_, conditions)) continue;
        if (const auto result = outcome(trial, m_, conditions)) accept(trial, *result);
      } catch (const Undefined&) {  // divides by 0: no value
      }
    }
  }

  /// Everything is decided again for the mended tableau.
  void accept(const Trial& trial, const Outcome<K>& result) {
    const TableauFindings after = findings(mended(t_, result.mended, trial.touched()), limits_);
    std::vector<std::string> restored;
    int digits = 0;
    bool all = true;
    for (const AuditClaim& c : after.claims) {
      const bool was_refuted = refuted_.contains(c.claim);
      if (c.verdict == Verdict::refuted) {
        if (!was_refuted) return;  // at the cost of another claim
        all = false;
      } else if (was_refuted && c.verdict == Verdict::holds) {
        restored.push_back(c.claim);
        if (c.digits > 0) digits = digits == 0 ? c.digits : std::min(digits, c.digits);
      }
    }
    if (restored.empty()) return;
    Mend mend;
    mend.kind = trial.kind;
    mend.checks = result.checks;
    mend.digits = digits;
    mend.cost = trial.cost + (result.checks < 1 ? kWithoutCheck : 0) + (all ? 0 : kNotAll);
    mend.restores = all ? kEveryClaim : comma_list(restored);
    describe(trial, result.mended, mend);
    if (std::ranges::none_of(mends_, [&](const Mend& other) { return same_changes(other, mend); }))
      mends_.push_back(std::move(mend));
  }

  static bool same_changes(const Mend& a, const Mend& b) {
    return a.changes.size() == b.changes.size() &&
           std::ranges::equal(a.changes, b.changes, [](const Change& x, const Change& y) {
             return x.where == y.where && x.right == y.right;
           });
  }

  void describe(const Trial& trial, const Method<K>& m, Mend& mend) const {
    mend.slip = trial.words;
    if (trial.kind == Mend::Kind::exchange && trial.exchanged.size() > 1) {
      mend.changes.push_back({trial.words, "", ""});
      return;
    }
    const std::vector<Cell> touched = trial.touched();
    for (const Cell& cell : touched) {
      const std::string& printed = t_.texts.at(cell);
      const bool exchanged = trial.kind == Mend::Kind::exchange;
      const Cell& other = cell == touched.front() ? touched.back() : touched.front();
      const std::string right = exchanged ? t_.texts.at(other) : written(t_, cell, m.at(cell));
      mend.changes.push_back({cell_name(cell, t_.nystroem), printed, right});
      if (exchanged) continue;
      if (trial.kind == Mend::Kind::everywhere && mend.changes.size() > 1) continue;
      const Slip s = likely_slip(cell, printed, right);
      mend.cost += s.cost;
      if (cell.part == Cell::Part::a && !t_.c_given) mend.cost += kLongTime * length_of_time(m, cell.i);
      if (!s.words.empty()) mend.slip += (mend.slip.empty() ? "" : "; ") + s.words;
    }
  }

  std::size_t length_of_time(const Method<K>& m, std::size_t row) const {
    K sum(0);
    for (const K& k : m.a[row]) sum += k;
    return std::min<std::size_t>(number_text(t_, sum).size(), 20);
  }

  /// A slip of the pen, or of the eye: what is printed stands beside it too.
  Slip likely_slip(const Cell& cell, const std::string& printed, const std::string& right) const {
    Slip s = slip(printed, right);
    const std::vector<Cell> all = cells(t_.texts);
    if (std::ranges::any_of(all, [&](const Cell& other) { return t_.texts.at(other) == right; }))
      s.cost -= kElsewhere;
    if (s.cost <= kNeighbour || t_.digits.at(cell).is_zero()) return s;
    std::vector<Cell> beside;
    for (const int step : {-1, 1}) {
      const auto in_range = [&](std::size_t i) { return i + step < t_.stages(); };  // wraps around below 0
      if (cell.part != Cell::Part::a) {
        if (in_range(cell.i)) beside.push_back({cell.part, cell.i + step, 0});
        continue;
      }
      if (in_range(cell.i)) beside.push_back({cell.part, cell.i + step, cell.j});
      if (in_range(cell.j)) beside.push_back({cell.part, cell.i, cell.j + step});
    }
    for (const Cell& other : beside)
      if (t_.texts.at(other) == printed)
        return {"the entry is that of its neighbour",
                kNeighbour + kLongText * static_cast<double>(right.size())};
    return s;
  }

  const AuditedTableau& t_;
  const Method<K>& m_;
  const TableauFindings& found_;
  const AuditLimits& limits_;
  Method<typename Search<K>::Number> fast_;
  std::set<std::string> refuted_;
  std::vector<Mend> mends_;
};

}  // namespace

std::vector<Mend> tableau_mends(const AuditedTableau& t, const TableauFindings& found,
                                const AuditLimits& limits) {
  return with_numbers(t, [&]<class K>(const Method<K>& m) { return TableauMends<K>(t, m, found, limits)(); });
}

}  // namespace shortfall
