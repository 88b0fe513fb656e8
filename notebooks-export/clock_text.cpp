// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/clock_text.hpp"

#include <algorithm>
#include <vector>

#include "notebooks-export/text_table.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kMostRows = 40;
constexpr std::size_t kFirstRows = 20, kLastRows = 6;

/// Without the zeros at the end of its digits.
std::string without_last_zeros(const std::string& text) {
  const std::size_t e = std::min(text.find('e'), text.size());
  std::string digits = text.substr(0, e);
  if (digits.find('.') == std::string::npos) return text;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  return digits + text.substr(e);
}

/// In digits; exact where these suffice (or a few more, where there is room), else with the sign of rounding.
std::string shown(const Rational& value, int digits = 10) {
  const std::string longest = value.significant(digits == 10 ? 14 : digits);
  if (Rational::parse(longest) == value) return without_last_zeros(longest);
  return "≈ " + without_last_zeros(value.significant(digits));
}

/// A whole number; one that nobody would count is rounded.
std::string counted(const Rational& n) { return n.digits() > 24 ? shown(n) : n.str(); }

std::string signed_text(const Rational& value, int digits = 10) {
  std::string text = shown(value, digits);
  if (value.sign() > 0) text.insert(text.starts_with("≈ ") ? std::string("≈ ").size() : 0, "+");
  return text;
}

std::string line(const std::string& what, const std::string& said) {
  return "  " + padded(what, 17) + said + "\n";
}

/// A time as people say it.
std::string duration(const Rational& seconds) {
  struct Scale {
    const char* unit;
    int seconds;
  };
  for (const Scale& s :
       {Scale{"years", 31'557'600}, Scale{"days", 86'400}, Scale{"h", 3'600}, Scale{"min", 60}})
    if (seconds.abs() >= Rational(2) * Rational(s.seconds))
      return shown(seconds / Rational(s.seconds), 4) + " " + s.unit;
  return shown(seconds, 4) + " s";
}

class Text {
 public:
  explicit Text(const ClockReport& r) : r_(r), q_(r.question), unit_(q_.velocity ? " m" : " s") {}
  std::string whole() const { return heading() + reading() + speed() + stop() + instead(); }

 private:
  std::string heading() const;
  std::string reading() const;
  std::string known() const;
  std::string speed() const;
  std::string row(const ClockSpeed& s, const ClockSpeed& last) const;
  std::string stop() const;
  Rational next_distance(const Rational& at) const;
  std::string equal_to_power(const Rational& value) const;
  std::string instead() const;
  std::string alternative(const ClockAlternative& a) const;
  std::string how(const CompensatedClock& sum) const;
  std::string time_of(const Rational& additions) const { return duration(additions * q_.dt.abs()); }
  std::string with_unit(const Rational& value) const { return shown(value) + unit_; }
  std::string fraction(const Rational& value) const {
    return value.is_integer() || value.digits() > 24 ? "" : " = " + value.str() + unit_ + " exactly";
  }
  std::string stored_words(const Rational& meant, const Rational& stored, const std::string& unit) const;

  const ClockReport& r_;
  const ClockQuestion& q_;
  std::string unit_;
};

std::string Text::stored_words(const Rational& meant, const Rational& stored, const std::string& unit) const {
  const std::string said = meant.digits() < 12 ? meant.str() : meant.significant(12);
  if (meant == stored) return said + unit + ", stored exactly";
  std::string text = said + unit + ", stored as " + shown(stored, 17) + unit;
  if (!meant.is_zero())
    text += ", " + signed_text((stored / meant - Rational(1)) * Rational(1'000'000), 4) + " ppm";
  return text;
}

std::string Text::heading() const {
  std::string text = q_.velocity ? "x += v dt in " : "t += dt in ";
  text += q_.words;
  if (q_.fixed_point && q_.rounding != Rounding::nearest_even)
    text += ", dt rounded " + name_of(q_.rounding);
  else if (!q_.fixed_point)
    text += ", rounded " + name_of(q_.rounding);
  if (q_.fused) text += ", v dt fused into the sum";
  if (q_.compensated) text += ", Kahan's sum";
  text += "\n" + line("dt", stored_words(q_.dt, r_.stored_dt, " s"));
  if (q_.velocity) text += line("v", stored_words(*q_.velocity, *r_.stored_velocity, " m/s"));
  if (q_.velocity) text += line("v dt", shown(r_.increment, 17) + " m is added");
  if (!q_.start.is_zero()) text += line("start", stored_words(q_.start, r_.stored_start, unit_));
  return text;
}

std::string Text::reading() const {
  const Rational time = q_.additions * q_.dt;
  const std::string time_text = shown(time);
  std::string text = "\nAfter " + counted(q_.additions) +
                     (q_.additions.is_one() ? " addition" : " additions") + ", n dt " +
                     (time_text.starts_with("≈") ? "" : "= ") + time_text + " s" +
                     (time.abs() >= Rational(120) ? " (" + duration(time) + ")" : "") + "\n";
  if (r_.value) {
    text += line("computed", with_unit(*r_.value) + fraction(*r_.value));
  } else if (r_.kahan && r_.kahan->bound) {
    text += line("computed", "within " + shown(*r_.kahan->bound, 4) + unit_ + " of " +
                                 with_unit(r_.stored_start + q_.additions * r_.increment) + ", proved");
  } else {
    const bool unknown = r_.kahan && r_.kahan->kind == CompensatedClock::Kind::unknown;
    text += line("computed", unknown    ? "not known"
                             : r_.kahan ? "no number: infinite, and NaN from the next addition on"
                                        : "infinite");
  }
  text += line("exact", with_unit(r_.meant));
  if (r_.shortfall) {
    const int slow = r_.shortfall->sign() * q_.advance().sign();
    const std::string word = slow == 0 ? ""
                             : q_.velocity
                                 ? (slow > 0 ? ": it has not come far enough" : ": it has come too far")
                             : slow > 0 ? ": the clock is slow"
                                        : ": the clock is fast";
    text += line("shortfall", signed_text(*r_.shortfall) + unit_ + word);
    text += line("  representation",
                 signed_text(r_.representation) + unit_ + "   the constants as they are stored");
    text += line("  rounding", signed_text(*r_.rounding_part) + unit_ + "   of the sums");
  } else {
    text += line("representation", signed_text(r_.representation) + unit_ + " of the shortfall");
  }
  if (r_.kahan) {
    text += line("known", how(*r_.kahan));
    if (r_.run.value)
      text += line("without Kahan",
                   with_unit(*r_.run.value) + ", shortfall " + signed_text(r_.meant - *r_.run.value) + unit_);
  }
  return text;
}

std::string Text::how(const CompensatedClock& sum) const {
  switch (sum.kind) {
    case CompensatedClock::Kind::closed_form:
      return "start + n dt of what is stored, rounded once; proved for the first " +
             counted(sum.closed_until) + " additions";
    case CompensatedClock::Kind::stepped:
      return "all additions were carried out" +
             (sum.frozen_after ? "; it stops after " + sum.frozen_after->str() : std::string());
    case CompensatedClock::Kind::bounded:
      return "a bound, proved; the value only up to " +
             (q_.additions > q_.most_stepped ? q_.most_stepped.str() + " additions, or " : std::string()) +
             counted(sum.closed_until) + " additions in closed form";
    case CompensatedClock::Kind::unknown:
      break;
  }
  return "neither a closed form nor a bound is proved here, and " + q_.additions.str() +
         (q_.additions > q_.most_stepped ? " additions are too many to carry out"
                                         : " additions of numbers so different are not carried out");
}

std::string Text::row(const ClockSpeed& s, const ClockSpeed& last) const {
  const auto end = [&](const Rational& value) {
    const std::string power = power_of_two_text(value);
    const bool handy =
        value.is_zero() || (value.abs() < Rational(1'000'000) && value.abs() >= Rational(1, 1000));
    return handy || power.empty() ? shown(value, 6) : power;
  };
  const bool here = s.before < q_.additions && q_.additions <= last.before + last.additions;
  // A range goes away from 0; sums that come nearer to it go through it the other way.
  const auto nearer = [](const ClockSpeed& speed, const ClockRange& r) {
    return !speed.exact && speed.increment.sign() * (r.from + r.to).sign() < 0;
  };
  const ClockRange first = range(s, q_.format), final = range(last, q_.format);
  std::string text = std::string(here ? "> " : "  ") +
                     padded(end(nearer(s, first) ? first.to : first.from) + " to " +
                                end(nearer(last, final) ? final.from : final.to),
                            24) +
                     " " + padded(counted(s.before + Rational(1)), 21) + " ";
  text += padded(shown(s.increment, 9), 19) + " " + padded(signed_text(s.parts_per_million(), 6), 16);
  if (!q_.velocity) text += " " + signed_text(s.lost_per_hour(), 6);
  while (text.ends_with(' ')) text.pop_back();
  return text + (s.exact ? "   no sum is rounded" : "") + "\n";
}

std::string Text::speed() const {
  if (r_.speeds.empty()) return "";
  std::string text = q_.compensated ? "\nSpeed without compensation\n" : "\nSpeed\n";
  text += "  " + padded(q_.velocity ? "sums in m" : "sums in s", 24) + " " + padded("from addition", 21) +
          " " + padded("each adds", 19) + " " +
          (q_.velocity ? "ppm fast" : padded("ppm fast", 16) + " s lost an hour") + "\n";
  // Neighbours of one speed share a row.
  std::vector<std::string> rows;
  const std::vector<ClockSpeed>& all = r_.speeds;
  for (std::size_t first = 0, i = 0; i < all.size(); ++i) {
    if (i + 1 < all.size() && all[i + 1].increment == all[first].increment &&
        all[i + 1].exact == all[first].exact)
      continue;
    rows.push_back(row(all[first], all[i]));
    first = i + 1;
  }
  const std::size_t count = rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (count > kMostRows && i == kFirstRows)
      text += "  ... " + std::to_string(count - kFirstRows - kLastRows) + " more (--csv has all)\n";
    if (count <= kMostRows || i < kFirstRows || i >= count - kLastRows) text += rows[i];
  }
  return text;
}

/// "2^21 = 2097152 s".
std::string Text::equal_to_power(const Rational& value) const {
  const std::string power = power_of_two_text(value);
  std::string digits = with_unit(value);
  if (power.empty()) return digits;
  return power + (digits.starts_with("≈") ? " " : " = ") + digits;
}

/// How far it is to the next number in the direction of the additions.
Rational Text::next_distance(const Rational& at) const {
  const BinaryFormat& f = q_.format;
  if (at.is_zero()) return f.smallest();
  const long top = leading_bit(at.abs());
  const bool inwards = (at.sign() < 0) != (r_.increment.sign() < 0) && at.abs() == power_of_two(top);
  return power_of_two(std::max(top - (f.precision - 1) - (inwards ? 1 : 0), f.least_unit));
}

std::string Text::stop() const {
  std::string text = q_.compensated ? "\nWithout compensation\n" : "\nEnd\n";
  const Rational exact = r_.path.exact_additions();
  switch (r_.path.end) {
    case AccumulatorPath::End::frozen: {
      const Rational at = r_.path.last();
      text += line("stops at", equal_to_power(at) + ", after " + counted(r_.path.additions()) +
                                   " additions (" + time_of(r_.path.additions()) + ")");
      const bool largest = !at.is_zero() && rounded(at * Rational(2), q_.format, Rounding::toward_zero) == at;
      const std::string distance = with_unit(next_distance(at));
      const bool nearest = q_.rounding == Rounding::nearest_even || q_.rounding == Rounding::nearest_away;
      const std::string step = q_.velocity ? "v dt" : "dt";
      text += line("", largest ? "that is the largest number of the format"
                       : nearest
                           ? step + " is not more than half of the " + distance + " to the next number"
                           : step + " is less than the " + distance + " to the next number, and rounded off");
      break;
    }
    case AccumulatorPath::End::overflowed:
      if (q_.fixed_point)
        return text +
               line("overflows", "the word is full after " + counted(r_.path.additions()) + " additions (" +
                                     time_of(r_.path.additions()) + "); no sum is rounded");
      text += line("infinite", "after " + counted(r_.path.additions() + Rational(1)) + " additions");
      break;
    case AccumulatorPath::End::not_reached:
      text += line("not followed", "beyond " + r_.path.additions().significant(6) +
                                       " additions, where the value is " + shown(r_.path.last(), 6) + unit_);
      break;
  }
  if (exact == r_.path.additions() && r_.path.end != AccumulatorPath::End::not_reached)
    return text + line("exact", "all additions until then: no sum is rounded");
  return text + line("exact", exact.is_zero()
                                  ? "not even the first addition"
                                  : "the first " + counted(exact) + " additions (" + time_of(exact) +
                                        "), as dt is stored; the next is rounded");
}

std::string Text::alternative(const ClockAlternative& a) const {
  const auto what = [&]() -> std::string {
    using Kind = ClockAlternative::Kind;
    const std::string start = q_.start.is_zero() ? "" : "start + ";
    switch (a.kind) {
      case Kind::divided:
        return "count steps in an integer; " + start + "n/" + a.rate->str() + " when it is read";
      case Kind::multiplied:
        return "count steps in an integer; " + start + (q_.velocity ? "n (v dt)" : "n dt") +
               " when it is read";
      case Kind::compensated:
        return "Kahan's sum in the same format";
      case Kind::wider:
        return "the same additions in " + a.arithmetic->words;
      case Kind::dyadic:
        return "dt = " + (a.step->digits() > 12 ? power_of_two_text(*a.step) : a.step->str()) + " s";
    }
    return "";
  }();
  std::string text = "  " + padded(what, 58) + " ";
  if (a.shortfall)
    text += "shortfall " + signed_text(*a.shortfall, 4) + unit_;
  else if (a.step)
    text += "no sum is rounded for " + counted(*a.exact_additions) + " additions (" +
            duration(*a.exact_additions * a.step->abs()) + ")";
  else if (a.sum && a.sum->bound)
    text += "within " + shown(*a.sum->bound, 4) + unit_ + " of n dt as stored, proved";
  else
    text += a.sum ? "not known" : "infinite";
  return text + "\n";
}

std::string Text::instead() const {
  std::string text = "\nInstead\n";
  for (const ClockAlternative& a : r_.instead) text += alternative(a);
  const ClockAlternative* best = nullptr;
  for (const ClockAlternative& a : r_.instead)
    if (a.shortfall && (!best || a.shortfall->abs() < best->shortfall->abs())) best = &a;
  if (best && r_.shortfall && best->shortfall->abs() >= r_.shortfall->abs())
    text += "  None is nearer to the exact value than this clock is here.\n";
  return text +
         "\nShortfall = exact - computed: + is too low, - too high. ≈ marks a rounded number; the others are "
         "exact.\n";
}

}  // namespace

std::string as_text(const ClockReport& report) { return Text(report).whole(); }

}  // namespace shortfall
