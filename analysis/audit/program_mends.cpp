// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/program_mends.hpp"

#include <algorithm>
#include <set>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/audit/free_flight.hpp"
#include "analysis/audit/method.hpp"
#include "analysis/audit/slip.hpp"
#include "analysis/audit/text_edit.hpp"
#include "analysis/audit/unknown_number.hpp"
#include "analysis/audit/written.hpp"
#include "analysis/motion/agreement.hpp"
#include "analysis/program/parse.hpp"

namespace shortfall {

namespace {

using Verdict = AuditClaim::Verdict;

constexpr int kExactDigits = 60;
constexpr int kCountedOrder = 6;
constexpr int kLongestNumber = 24;  // a longer one is no misprint of a short one

class ProgramMends {
 public:
  ProgramMends(const std::string& text, const Program& program, const std::vector<AuditClaim>& claims,
               const std::optional<OrderDemand>& demand, const Decide& decide, const AuditLimits& limits)
      : text_(text),
        lines_(lines_of(text)),
        program_(program),
        demand_(demand),
        decide_(decide),
        limits_(limits),
        digits_(printed_digits(program)) {
    for (const AuditClaim& c : claims)
      if (c.verdict == Verdict::refuted) refuted_.insert(c.claim);
    if (demand && !refuted_.empty()) failing_ = failing_conditions();
  }

  std::vector<Mend> operator()() {
    if (refuted_.empty()) return {};
    try_all(text_edits(text_));
    if (mends_.empty()) try_all(digit_edits(text_));
    std::ranges::stable_sort(mends_, {}, &Mend::cost);
    if (mends_.size() > kMostMends) mends_.resize(kMostMends);
    return std::move(mends_);
  }

 private:
  void try_all(const std::vector<TextEdit>& edits) {
    int done = 0;
    for (const TextEdit& edit : edits) {
      if (limits_.progress) limits_.progress("looking for misprints", ++done, static_cast<int>(edits.size()));
      if (edit.unknown)
        solve(edit);
      else
        look_at(edit);
    }
  }

  /// Of the order demanded; 0 when the step has no series, or none that is cheap.
  int failing_conditions() const {
    try {
      const SeriesSource source(program_, {});
      const TreeTable table(demand_->forces->signature, std::min(demand_->order, kCountedOrder),
                            limits_.most_bytes);
      int count = 0;
      with_coefficients(source, [&]<class K>() {
        const OneStep<K> step = source.step<K>(table);
        for (TreeId t = 0; t < table.size(); ++t)
          count += !source.zero(Fraction(step.map[t]) - Fraction(Rational(1) / table.density(t)));
      });
      return count;
    } catch (const Error&) {
      return 0;
    }
  }

  std::optional<Program> parsed(const TextEdit& edit) const {
    try {
      return parse(edited(text_, edit), program_.file);
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  /// The number in exact or printed form, as it would stand there.
  std::string right(const TextEdit::Unknown& u, const KnownDigits& value) const {
    using Form = TextEdit::Unknown::Form;
    const Rational middle = value.ball().midpoint(), width = Rational(1) / Rational(10).pow(kExactDigits);
    const bool rounded = digits_ > 0 && !value.ball().is_exact() && value.digits() < kExactDigits;
    std::optional<Rational> exact;
    if (!rounded) {
      exact = simplest_between(middle - width, middle + width);
    } else if (program_.approximations.end() ==
               std::ranges::find(program_.approximations, u.name, &Approximation::name)) {
      // Beside the printed decimals stand simple numbers: one with few digits, of many known, is no accident.
      const Rational known = Rational(1) / Rational(10).pow(value.digits());
      const Rational simple = simplest_between(middle - known, middle + known);
      if (3 * static_cast<int>(simple.digits()) < value.digits()) exact = simple;
    }
    if (exact && static_cast<int>(exact->digits()) > kLongestNumber) return "";
    switch (u.form) {
      case Form::factor:
        if (exact) return written_like(*exact, u.token);
        return written_like(value, u.token);
      case Form::divisor: {
        if (!exact || exact->is_zero()) return "";
        const Rational inverse = Rational(1) / *exact;
        return inverse.is_integer() && inverse.sign() > 0 ? "/" + inverse.str() : "*(" + exact->str() + ")";
      }
      case Form::time: {
        const Rational q = exact ? *exact : Rational();
        if (!exact) return "";
        if (q.is_zero()) return "t";
        const std::string size = q.abs().is_one()               ? "h"
                                 : q.abs().numerator().is_one() ? "h/" + q.denominator().str()
                                                                : q.abs().str() + "*h";
        return std::string("t ") + (q.sign() < 0 ? "- " : "+ ") + size;
      }
    }
    return "";
  }

  /// A negative number behind an operator turns its sign, or stands in parentheses.
  static std::string with_sign(const TextEdit::Unknown& u, const std::string& text) {
    const std::size_t before = u.before.find_last_not_of(" \t");
    const char operation = before == std::string::npos ? ' ' : u.before[before];
    if (!text.starts_with('-') || u.form == TextEdit::Unknown::Form::time) return u.line(text);
    if (operation == '+' || operation == '-') {
      std::string turned = u.before;
      const std::size_t ahead =
          before == 0 ? std::string::npos : u.before.find_last_not_of(" \t", before - 1);
      const bool leads =
          ahead == std::string::npos || std::string("=(kt").find(u.before[ahead]) != std::string::npos;
      if (operation == '-' && leads)
        turned.erase(before, 1);
      else
        turned[before] = operation == '+' ? '-' : '+';
      return turned + text.substr(1) + u.after;
    }
    return u.line(operation == '*' || operation == '/' ? "(" + text + ")" : text);
  }

  void solve(const TextEdit& edit) {
    if (!demand_) return;
    const auto open = parsed(edit);
    if (!open) return;
    const TextEdit::Unknown& u = *edit.unknown;
    for (const KnownDigits& value :
         values_of_unknown(*open, u.name, u.printed, digits_, *demand_, limits_.most_bytes)) {
      const std::string text = right(u, value);
      if (text.empty() || text == u.token) continue;
      TextEdit closed = edit;
      closed.unknown.reset();
      closed.lines[0].text = with_sign(u, text);
      if (u.form != TextEdit::Unknown::Form::time) {
        const Slip s = slip(u.token, text);
        closed.words = s.words;
        closed.cost = s.cost;
      }
      look_at(closed, true);
    }
  }

  void look_at(const TextEdit& edit, bool solved = false) {
    const auto program = parsed(edit);
    if (!program) return;
    // Most of them fail at a low order already.
    if (demand_ && order_up_to(*program, *demand_, limits_.most_bytes) < demand_->order) return;
    std::vector<std::string> restored;
    bool all = true;
    int digits = 0;
    for (const AuditClaim& c : decide_(*program)) {
      if (c.verdict == Verdict::refuted && !refuted_.contains(c.claim)) return;
      if (c.verdict != Verdict::holds) all = false;
      if (c.verdict == Verdict::holds && refuted_.contains(c.claim)) {
        restored.push_back(c.claim);
        if (c.digits > 0) digits = digits == 0 ? c.digits : std::min(digits, c.digits);
      }
    }
    if (restored.empty()) return;
    Mend mend;
    mend.kind = edit.exchanges_kicks ? Mend::Kind::exchange : Mend::Kind::line;
    mend.slip = edit.words;
    mend.digits = digits;
    mend.checks = std::max(failing_, static_cast<int>(restored.size())) - (solved ? 1 : 0);
    mend.cost = edit.cost + (all ? 0 : 3);
    mend.restores = all ? kEveryClaim : comma_list(restored);
    if (edit.exchanges_kicks)
      mend.changes.push_back({edit.words, "", ""});
    else
      for (const TextEdit::Line& line : edit.lines)
        mend.changes.push_back({"line " + std::to_string(line.number),
                                trimmed(lines_[static_cast<std::size_t>(line.number) - 1]),
                                trimmed(line.text)});
    const auto same = [&](const Mend& other) {
      return std::ranges::equal(other.changes, mend.changes, [](const Change& a, const Change& b) {
        return a.where == b.where && a.right == b.right;
      });
    };
    const auto known = std::ranges::find_if(mends_, same);
    if (known == mends_.end())
      mends_.push_back(std::move(mend));
    else if (mend.cost < known->cost)
      *known = std::move(mend);
  }

  const std::string& text_;
  std::vector<std::string> lines_;
  const Program& program_;
  const std::optional<OrderDemand>& demand_;
  const Decide& decide_;
  const AuditLimits& limits_;
  int digits_;
  int failing_ = 0;
  std::set<std::string> refuted_;
  std::vector<Mend> mends_;
};

}  // namespace

int order_up_to(const Program& program, const OrderDemand& demand, double most_bytes) {
  if (const auto sums = step_sums(program))
    if (!is_nothing(sums->drift - KnownDigits(1)) || !is_nothing(sums->kick - KnownDigits(1))) return 0;
  try {
    const SeriesSource source(program, {});
    OrderLimits limits;
    limits.highest = demand.order;
    limits.most_bytes = most_bytes;
    return order_of_class(source, *demand.forces, limits).order;
  } catch (const Error&) {
    return 0;
  }
}

std::vector<Mend> program_mends(const std::string& text, const Program& program,
                                const std::vector<AuditClaim>& claims,
                                const std::optional<OrderDemand>& demand, const Decide& decide,
                                const AuditLimits& limits) {
  return ProgramMends(text, program, claims, demand, decide, limits)();
}

}  // namespace shortfall
