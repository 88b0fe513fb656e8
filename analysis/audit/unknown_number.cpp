// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/unknown_number.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/audit/free_flight.hpp"
#include "analysis/audit/method.hpp"

namespace shortfall {

namespace {

constexpr int kSamples = 7;     // conditions of low order are polynomials of a degree below
constexpr int kLostByRoot = 3;  // digits that a root may lose against the decimals it comes from

class UnknownNumber {
 public:
  UnknownNumber(const Program& program, const std::string& name, const Rational& printed, int digits,
                const OrderDemand& demand, double most_bytes)
      : program_(program),
        name_(name),
        printed_(printed),
        digits_(digits),
        demand_(demand),
        most_bytes_(most_bytes) {}

  std::vector<KnownDigits> operator()() {
    if (const auto found = from_sums()) return *found;
    for (int n = 2; n <= demand_.order; ++n) {
      if (TreeTable::bytes_needed(demand_.forces->signature, n) > most_bytes_) return {};
      const auto found = from_order(n);
      if (found) return *found;
    }
    return {};
  }

 private:
  Values with(int sample) const { return {{name_, printed_ + Rational(sample)}}; }

  /// Of what does not depend on the unknown: whether it fails. Otherwise its values.
  std::optional<std::vector<KnownDigits>> from_sums() const {
    std::vector<StepSums> at;
    for (int k = 0; k < 3; ++k) {
      const auto sums = step_sums(program_, with(k));
      if (!sums) return std::nullopt;
      at.push_back(*sums);
    }
    std::optional<std::vector<KnownDigits>> result;
    for (KnownDigits StepSums::*sum : {&StepSums::drift, &StepSums::kick}) {
      const KnownDigits first = at[1].*sum - at[0].*sum, second = at[2].*sum - at[1].*sum,
                        defect = at[0].*sum - KnownDigits(1);
      if (is_nothing(first) && is_nothing(second)) {
        if (!is_nothing(defect)) return std::vector<KnownDigits>{};
        continue;
      }
      if (result) continue;
      result.emplace();
      if (is_nothing(second - first) && !is_nothing(first))
        result->push_back(KnownDigits(printed_) - defect / first);
    }
    return result;
  }

  std::vector<Rational> defects(int n, int sample) const {
    const SeriesSource source(program_, with(sample));
    if (!source.rational()) throw Unable("roots");
    const TreeTable table(demand_.forces->signature, n, most_bytes_);
    const OneStep<Rational> step = source.step<Rational>(table);
    std::vector<Rational> result;
    for (TreeId t = table.begin(n); t < table.end(n); ++t)
      result.push_back(step.map[t] - Rational(1) / table.density(t));
    return result;
  }

  bool is_small(const Rational& r) const {
    return r.is_zero() || (digits_ > kLostByRoot && r.abs() < Rational(1) / Rational(10).pow(digits_ - 2));
  }

  std::optional<std::vector<KnownDigits>> from_order(int n) const {
    std::vector<std::vector<Rational>> at;
    try {
      for (int k = 0; k < kSamples; ++k) at.push_back(defects(n, k));
    } catch (const Error&) {
      return std::vector<KnownDigits>{};
    }
    std::optional<Univariate<Rational>> simplest;
    for (std::size_t t = 0; t < at[0].size(); ++t) {
      const bool depends =
          std::ranges::any_of(at, [&](const auto& row) { return !is_small(row[t] - at[0][t]); });
      if (!depends) {
        if (!is_small(at[0][t])) return std::vector<KnownDigits>{};
        continue;
      }
      const auto p = interpolated(at, t);
      if (p && (!simplest || p->degree() < simplest->degree())) simplest = p;
    }
    if (!simplest) return std::nullopt;
    std::vector<KnownDigits> result;
    for (const RealRoot& root : real_roots(*simplest)) {
      if (digits_ == 0 && root.is_rational()) result.emplace_back(root.rational() + printed_);
      if (digits_ > kLostByRoot) {
        const RealRoot fine = root.refined(Rational(1) / Rational(10).pow(digits_ + 2));
        const Rational radius = Rational(1) / Rational(10).pow(digits_ - kLostByRoot),
                       value = fine.low() + printed_;
        result.emplace_back(
            hull(Ball(value - radius, KnownDigits::kBits), Ball(value + radius, KnownDigits::kBits)));
      }
    }
    return result;
  }

  /// Newton's polynomial through the samples, in the distance from the printed value; none of the highest
  /// degree, of which nothing confirms it.
  std::optional<Univariate<Rational>> interpolated(const std::vector<std::vector<Rational>>& at,
                                                   std::size_t t) const {
    std::vector<Rational> differences;
    for (const auto& row : at) differences.push_back(row[t]);
    for (int k = 1; k < kSamples; ++k)
      for (int i = kSamples - 1; i >= k; --i)
        differences[i] = (differences[i] - differences[i - 1]) / Rational(k);
    int degree = kSamples - 1;
    while (degree > 0 && is_small(differences[degree])) --degree;
    if (degree == 0 || degree == kSamples - 1) return std::nullopt;
    Univariate<Rational> p({differences[degree]});
    for (int k = degree - 1; k >= 0; --k)
      p = p * Univariate<Rational>({Rational(-k), Rational(1)}) + Univariate<Rational>({differences[k]});
    return p;
  }

  const Program& program_;
  std::string name_;
  Rational printed_;
  int digits_;
  OrderDemand demand_;
  double most_bytes_;
};

}  // namespace

std::vector<KnownDigits> values_of_unknown(const Program& program, const std::string& name,
                                           const Rational& printed, int digits, const OrderDemand& demand,
                                           double most_bytes) {
  return UnknownNumber(program, name, printed, digits, demand, most_bytes)();
}

}  // namespace shortfall
