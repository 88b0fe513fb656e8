// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/clock.hpp"
#include "analysis/floating/extremes.hpp"
#include "analysis/program/parse.hpp"

namespace shortfall {

namespace {

bool far_off(const Rational& computed, const Rational& exact) {
  return (computed - exact).abs() * Rational(10) > exact.abs();
}

/// A clock that ticks for a time. The format's roundings are those of its plain sums.
ExtremeCase clock_case(const FloatFormat& format, const std::string& dt_text, const Rational& dt,
                       const std::string& time, const Rational& seconds) {
  ExtremeCase c{"clock", "t += " + dt_text + " s for " + time, "", "", "", false};
  ClockQuestion q;
  q.format = format.storage();
  q.format_name = format.name();
  q.rounding = format.rounding();
  q.dt = dt;
  q.additions = (seconds / dt).floor();
  const ClockReport r = clock_report(q);
  c.exact = r.meant.significant(10) + " s";
  if (!r.run.value) {
    c.computed = "infinity";
    c.why = "the sum leaves the format";
    c.lost = true;
    return c;
  }
  c.computed = r.run.value->significant(10) + " s";
  c.lost = far_off(*r.run.value, r.meant);
  if (r.run.freezes)
    c.why = "the clock stopped at " + r.run.freezes->value.significant(8) + " s, after " +
            r.run.freezes->additions.str() + " additions: dt is less than half a unit there";
  else if (r.run.exact_additions)
    c.why = "each sum is rounded to a multiple of a unit that grows with t; " + r.run.exact_additions->str() +
            " additions were exact";
  else
    c.why = "every sum is a number of the format";
  return c;
}

/// The scalar r that lines end in, computed in the format: x := x + (h r) v with x = 0, h = v = 1.
FloatNumber computed(const FloatFormat& format, const std::string& lines, const Values& values = {}) {
  FloatQuestion q;
  std::string text = "integrator formula\n  source extremes\n";
  for (const auto& [name, value] : values) text += "  param " + name + " = 1\n";
  q.program = parse(text + "\nstep\n" + lines + "  x = x + (h*r)*v\n", "formula");
  q.parameters = values;
  q.force = force_named("constant:a=0");
  q.h = 1;
  q.v0 = 1;
  const auto run = float_run(format, q);
  run->step();
  return run->state().first;
}

void judge(ExtremeCase& c, const FloatNumber& found, const Rational& exact) {
  c.exact = exact.significant(10);
  c.computed = found.str(10);
  c.lost = !found.is_finite() || far_off(found.value, exact);
}

/// Muller's recurrence x = 108 - (815 - 1500/x_{n-1})/x_n from 4 and 17/4, whose exact terms tend to 5.
ExtremeCase muller(const FloatFormat& format) {
  constexpr int kTerms = 60;
  ExtremeCase c{"Muller's recurrence",
                "x = 108 - (815 - 1500/x_prev)/x, term 60, from 4 and 4.25",
                "",
                "",
                "5 repels what rounding adds: the run ends at 100, whatever the precision, only later",
                false};
  Rational before = 4, now(17, 4);
  FloatNumber kept{FloatNumber::Kind::finite, before}, found{FloatNumber::Kind::finite, now};
  for (int k = 2; k <= kTerms; ++k) {
    const Rational next = Rational(108) - (Rational(815) - Rational(1500) / before) / now;
    before = now;
    now = next;
    if (!found.is_finite()) continue;
    const FloatNumber made =
        computed(format, "  r = 108 - (815 - 1500/p)/q\n", {{"p", kept.value}, {"q", found.value}});
    kept = found;
    found = made;
  }
  judge(c, found, now);
  return c;
}

/// Rump's polynomial at (77617, 33096).
ExtremeCase rump(const FloatFormat& format) {
  const std::string lines =
      "  p = 77617\n  q = 33096\n  q2 = q*q\n  q4 = q2*q2\n  q6 = q4*q2\n  q8 = q4*q4\n  p2 = p*p\n"
      "  r = (333 + 3/4)*q6 + p2*(11*p2*q2 - q6 - 121*q4 - 2) + (5 + 1/2)*q8 + p/(2*q)\n";
  ExtremeCase c{"Rump's polynomial",
                "333.75 b^6 + a^2 (11 a^2 b^2 - b^6 - 121 b^4 - 2) + 5.5 b^8 + a/(2b) at (77617, 33096)",
                "",
                "",
                "terms near 8e36 cancel to -2: 37 digits are needed before one of the result is right",
                false};
  judge(c, computed(format, lines), Rational(-54767, 66192));
  return c;
}

}  // namespace

std::vector<ExtremeCase> extreme_sums(const FloatFormat& format) {
  std::vector<ExtremeCase> cases;
  const Rational hour(3600), day(86400);
  const bool plain =
      format.variant == FloatFormat::Variant::plain || format.variant == FloatFormat::Variant::toward_zero;
  if (plain && format.kind != FloatFormat::Kind::double_double)
    for (const auto& [text, dt, time, seconds] :
         {std::tuple{"0.1", Rational(1, 10), "1,000,000 additions", Rational(100'000)},
          std::tuple{"1/60", Rational(1, 60), "an hour", hour},
          std::tuple{"1/60", Rational(1, 60), "a day", day},
          std::tuple{"1/60", Rational(1, 60), "a week", Rational(7) * day},
          std::tuple{"0.001", Rational(1, 1000), "an hour", hour},
          std::tuple{"0.001", Rational(1, 1000), "a day", day},
          std::tuple{"1/64", Rational(1, 64), "a day", day},
          std::tuple{"1/60", Rational(1, 60), "1,000,000,000 steps", Rational(1'000'000'000) / Rational(60)}})
      try {
        cases.push_back(clock_case(format, text, dt, time, seconds));
      } catch (const BadInput&) {  // the step is 0 or infinite in the format
      }
  // 24 bits of fixed point, 21 of them behind the point, whatever the format.
  const Rational kept = (Rational(1, 10) * Rational(2).pow(21)).floor() / Rational(2).pow(21);
  cases.push_back(
      {"the Patriot clock", "tenths of a second for 100 hours, 0.1 chopped to 24 bits of fixed point",
       "360000 s", (kept * Rational(3'600'000)).significant(10) + " s",
       "off by exactly 5625/16384 s = 0.3433 s, 575 m at the speed of a Scud (1676 m/s, Skeel 1992)", false});
  cases.push_back(muller(format));
  cases.push_back(rump(format));
  return cases;
}

}  // namespace shortfall
