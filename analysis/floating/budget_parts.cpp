// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/budget_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"

namespace shortfall {

namespace {

constexpr int kResidualDigits = 40;          // the residual is narrower than 10^-40 of the total
constexpr std::int64_t kCompared = 100'000;  // with exact rationals: a second

constexpr int kLaunchDigits = 400;

Ball zero(int bits) { return Ball(0, bits); }

/// log10 of a positive decimal of any size, "1.2e-31788".
double logarithm(const std::string& decimal) {
  const std::size_t e = decimal.find('e');
  const double exponent = e == std::string::npos ? 0 : double_of(decimal.substr(e + 1));
  return std::log10(std::abs(double_of(decimal.substr(0, e)))) + exponent;
}

/// Whether the residual's ball is narrow beside what is observed.
bool narrower(const Ball& residual, const Ball& total) {
  if (residual.is_exact()) return true;
  const auto size = total.significant(2);
  return size && *size != "0" && logarithm(residual.radius()) < logarithm(*size) - kResidualDigits;
}

}  // namespace

bool BudgetLine::closes() const { return residual.contains_zero() && narrower(residual, observed); }

int first_digits(const FloatFormat& format) {
  constexpr int kShown = 25;  // beyond the format's own
  const int own = format.storage().precision * 3 / 10 + kShown;
  return std::clamp(own, kBudgetDigits, kMostBudgetDigits);
}

std::int64_t report_steps(const FloatFormat& format) {
  switch (format.kind) {
    case FloatFormat::Kind::binary128:
    case FloatFormat::Kind::double_double:
      return 10'000;
    case FloatFormat::Kind::mpfr:
      return std::max(1, 1000 / std::max(format.digits, 1));
    default:
      return 100'000;
  }
}

NumericQuestion exact_question(const FloatQuestion& q, std::int64_t steps, int digits) {
  NumericQuestion n;
  n.force = q.force;
  n.parameters = q.parameters;
  n.substeps = q.substeps;
  n.h = q.h;
  n.x0 = q.x0;
  n.v0 = q.v0;
  n.steps = Rational(steps);
  n.digits = digits;
  return n;
}

Ball ball_of(const CertainNumber& n, int bits) { return n.exact ? Ball(*n.exact, bits) : n.ball; }

Ball ball_of(const Surd& s, int bits) {
  const Ball rational(s.rational_part(), bits);
  return s.is_rational() ? rational : rational + Ball(s.root_part(), bits) * sqrt(Ball(s.radicand(), bits));
}

BudgetLine budget_line(const std::string& quantity, const std::string& unit, const FloatNumber& computed,
                       const Ball& truth, const Ball& again, std::vector<BudgetTerm> terms, int bits) {
  BudgetLine l{quantity,         unit,      computed, truth, again - Ball(computed.value, bits),
               std::move(terms), zero(bits)};
  Ball sum = zero(bits);
  for (const BudgetTerm& t : l.terms) sum += t.value;
  l.residual = l.observed - sum;
  return l;
}

void put_first_difference(Budget& b) {
  try {
    b.difference = first_difference(b.format, b.question, b.stored, std::min(b.steps, kCompared));
  } catch (const Unable&) {  // irrational coefficients: no exact run
  }
}

std::unique_ptr<FloatRun> second_run(const FloatFormat& format, const FloatQuestion& q) {
  auto run = tracked_run(format, q);
  return run ? std::move(run) : float_run(format, q);
}

namespace {

/// How long so many steps take at 20 ns each, which is what binary64 needs.
std::string duration(std::int64_t steps) {
  const double seconds = 20e-9 * static_cast<double>(steps);
  constexpr double kDay = 86400, kYear = 365.25 * kDay;
  const auto words = [](double value, const char* unit) {
    return std::to_string(std::llround(value)) + " " + unit;
  };
  if (seconds < kDay) return words(seconds / 60, "minutes");
  return seconds < kYear ? words(seconds / kDay, "days") : words(seconds / kYear, "years");
}

}  // namespace

void check_steps(std::int64_t steps) {
  if (steps < 1) throw BadInput("a budget is about one step or more");
  if (steps > kMostFloatSteps)
    throw Unable(
        "a run of " + std::to_string(steps) + " steps takes " + duration(steps) + " or more: at most " +
        std::to_string(kMostFloatSteps) +
        " are run. The exact map alone answers for any number (shortfall derive --steps), and a clock too "
        "(shortfall clock)");
}

namespace {

/// A format with more bits; none when there are enough.
std::optional<FloatFormat> wider(const FloatFormat& f) {
  using Kind = FloatFormat::Kind;
  FloatFormat w;
  switch (f.kind) {
    case Kind::binary16:
    case Kind::bfloat16:
      w.kind = Kind::binary32;
      return w;
    case Kind::binary32:
      w.kind = Kind::binary64;
      return w;
    case Kind::binary64:
    case Kind::x87:
      w.kind = Kind::binary128;
      return w;
    case Kind::binary128:
    case Kind::double_double:
      w.kind = Kind::mpfr;
      w.digits = 70;
      return w;
    case Kind::mpfr:
      break;
  }
  return std::nullopt;
}

/// Compensated where it is not, wider otherwise.
std::optional<FloatFormat> careful(const FloatFormat& f) {
  if (f.variant != FloatFormat::Variant::plain || f.kind == FloatFormat::Kind::mpfr) return wider(f);
  FloatFormat c = f;
  c.variant = FloatFormat::Variant::compensated;
  return c;
}

}  // namespace

void put_remedies(Budget& b, const RemedyParts& parts) {
  constexpr std::int64_t kMostSteps = 200'000;  // done again with the change: a moment
  if (b.steps > kMostSteps) return;
  FloatQuestion half = b.question;
  half.h = half.h / Rational(2);
  half.kept_h.reset();
  const std::string half_step =
      "dt = " + (half.h.digits() < 12 ? half.h.str() : half.h.significant(17)) + " s";
  for (const BudgetTerm& term : b.lines.at(0).terms) {
    if (term.value.contains_zero()) continue;
    try {
      if (term.name == "method") {
        b.remedies.push_back({term.name, half_step, parts.method(half)});
      } else if (term.name == "representation") {
        FloatQuestion plain = b.question;
        plain.kept_h.reset();
        const FloatQuestion kept = stored(plain, b.format);
        if (kept.h != b.stored.h)  // what was said about dt is coarser than the format
          b.remedies.push_back(
              {term.name, "dt kept as the format keeps it, without a suffix", parts.representation(kept)});
        else if (const auto format = wider(b.format))
          b.remedies.push_back({term.name, "constants kept in " + format->name(),
                                parts.representation(stored(plain, *format))});
      } else if (term.name == "rounding") {
        const auto format = careful(b.format);
        if (!format) continue;
        if (const auto becomes = parts.rounding(*format))
          b.remedies.push_back({term.name, "steps in " + format->name(), *becomes});
      } else if (parts.sampling) {
        const auto [change, becomes] = parts.sampling(half);
        b.remedies.push_back({term.name, change.empty() ? half_step : change, becomes});
      }
    } catch (const Unable&) {  // a limit that only the changed question meets
    } catch (const Undefined&) {
    }
  }
}

JumpBudgetQuestion jump_question(const FloatQuestion& question, const Rational& height, const Rational& g) {
  if (height.sign() <= 0 || g.sign() <= 0)
    throw BadInput("a jump needs a positive height and a positive gravity");
  JumpBudgetQuestion jump{question, Surd::sqrt(Rational(2) * g * height)};
  FloatQuestion& q = jump.question;
  q.force = force_named("constant");
  q.force.push[0] = -g;
  q.x0 = 0;
  q.v0 = jump.launch.is_rational() ? jump.launch.rational_part() : jump.launch.approximation(kLaunchDigits);
  return jump;
}

}  // namespace shortfall
