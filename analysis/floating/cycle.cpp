// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/cycle.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr std::int64_t kReport = 1'000'000;

/// Numbers are compared by their bits: 0 and -0 are different states.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double p, double q) {
    return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q);
  });
}

void check(const FloatFormat& format, const FloatQuestion& q) {
  if (q.force.degree > 0) throw Unable("a force that depends on time never repeats itself");
  const bool plain =
      format.variant == FloatFormat::Variant::plain || format.variant == FloatFormat::Variant::toward_zero;
  if (!plain || format.storage().precision > 53)
    throw Unable(
        "cycles are looked for in f16, bf16, f32 and f64 (and +tozero), whose states binary64 holds");
}

class Search {
 public:
  Search(const FloatFormat& format, const FloatQuestion& q, std::int64_t most, const Progress& progress)
      : run_(float_run(format, q)), q_(q), most_(most), progress_(progress), name_(format.name()) {}

  CycleSearch operator()() {
    CycleSearch result;
    const std::optional<std::int64_t> period = find_period(result);
    if (!period) return result;
    Cycle c;
    c.period = *period;
    c.tail = find_tail(*period);
    measure(c);
    c.looked_at = result.looked_at = looked_at_;
    result.found = c;
    return result;
  }

 private:
  bool step(FloatRun& run) {
    run.step();
    if (progress_ && ++looked_at_ % kReport == 0)
      progress_("looking for a cycle in " + name_, static_cast<int>(looked_at_ / kReport),
                static_cast<int>(most_ / kReport));
    else if (!progress_)
      ++looked_at_;
    return true;
  }

  /// Brent's search: the state is compared with one that is left behind at the powers of two.
  std::optional<std::int64_t> find_period(CycleSearch& result) {
    run_->begin();
    std::vector<double> kept, now;
    run_->carried(kept);
    std::int64_t power = 1, lambda = 0;
    for (std::int64_t n = 1; n <= most_; ++n) {
      step(*run_);
      run_->carried(now);
      ++lambda;
      if (!std::ranges::all_of(now, [](double d) { return std::isfinite(d); })) {
        result.not_finite_at = n;
        result.looked_at = n;
        return std::nullopt;
      }
      if (same(now, kept)) return lambda;
      if (lambda == power) {
        kept = now;
        power *= 2;
        lambda = 0;
      }
    }
    result.looked_at = most_;
    return std::nullopt;
  }

  /// Two runs, one a period ahead: where they first agree.
  std::int64_t find_tail(std::int64_t period) {
    const auto ahead = run_again();
    for (std::int64_t n = 0; n < period; ++n) step(*ahead);
    const auto behind = run_again();
    std::vector<double> a, b;
    for (std::int64_t tail = 0;; ++tail) {
      ahead->carried(a);
      behind->carried(b);
      if (same(a, b)) return tail;
      step(*ahead);
      step(*behind);
    }
  }

  std::unique_ptr<FloatRun> run_again() { return float_run(float_format(name_), q_); }

  void measure(Cycle& c) {
    run_->begin();
    const double k = q_.force.spring ? q_.force.k->to_double() : 0;
    const auto push = q_.force.push.find(0);
    const double f0 = push == q_.force.push.end() ? 0 : push->second.to_double();
    c.least_energy = HUGE_VAL;
    c.largest_energy = -HUGE_VAL;
    double last = 0;
    for (std::int64_t n = 0; n <= c.tail + c.period; ++n) {
      const auto [x, v] = run_->rough();
      const double energy = v * v / 2 + k * x * x / 2 - f0 * x;
      c.largest_x = std::max(c.largest_x, std::abs(x));
      c.largest_v = std::max(c.largest_v, std::abs(v));
      c.least_energy = std::min(c.least_energy, energy);
      c.largest_energy = std::max(c.largest_energy, energy);
      if (n > c.tail && last < 0 && x >= 0) ++c.turns;
      last = x;
      step(*run_);
    }
  }

  std::unique_ptr<FloatRun> run_;
  const FloatQuestion& q_;
  std::int64_t most_;
  const Progress& progress_;
  std::string name_;
  std::int64_t looked_at_ = 0;
};

}  // namespace

CycleSearch cycle(const FloatFormat& format, const FloatQuestion& question, std::int64_t most,
                  const Progress& progress) {
  check(format, question);
  return Search(format, question, most, progress)();
}

}  // namespace shortfall
