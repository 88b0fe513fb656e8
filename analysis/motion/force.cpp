// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/force.hpp"

#include <algorithm>
#include <charconv>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

[[noreturn]] void complain(std::string_view text, const std::string& why) {
  throw BadInput("--force '" + std::string(text.substr(0, 60)) + "': " + why);
}

/// The d of f0, f1, ...; a is f0.
int push_degree(std::string_view name) {
  if (name == "a") return 0;
  int d = -1;
  if (name.size() < 2 || name[0] != 'f') return -1;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), d);
  return error == std::errc() && end == name.data() + name.size() ? d : -1;
}

/// k=4,c=1/2,a=3 after the colon. `highest`: the degree of the force polynomial that this word brings, -1 for
/// none.
void read_letters(std::string_view text, std::string_view letters, bool spring, bool damper, int highest,
                  Force& force) {
  for (std::size_t begin = 0; begin < letters.size();) {
    std::size_t end = letters.find(',', begin);
    if (end == std::string_view::npos) end = letters.size();
    const std::string_view one = letters.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = one.find('=');
    const std::string_view letter = one.substr(0, equals);
    const int d = push_degree(letter);
    if (equals == std::string_view::npos || (letter != "k" && letter != "c" && d < 0))
      complain(text,
               "after the colon stand letters of the force, as in damped-spring:k=4,c=1/2 or constant:a=3");
    if (letter == "k" ? !spring : letter == "c" ? !damper : d > highest)
      complain(text, "this force has no " + std::string(letter.substr(0, 20)));
    Rational value;
    try {
      value = Rational::parse(one.substr(equals + 1));
    } catch (const BadInput& e) {
      complain(text, e.what());
    }
    if (d >= 0) {
      if (!force.push.emplace(d, value).second)
        complain(text, std::string(letter.substr(0, 20)) + " is given twice");
      continue;
    }
    std::optional<Rational>& known = letter == "k" ? force.k : force.c;
    if (known) complain(text, std::string(letter) + " is given twice");
    known = value;
    // Nothing is lost: a spring of stiffness 0 is no spring.
    if (value.is_zero()) (letter == "k" ? force.spring : force.damper) = false;
  }
}

void read_word(std::string_view text, std::string_view word, Force& force) {
  const std::size_t colon = word.find(':');
  const std::string name(word.substr(0, colon));
  const std::string_view rest = colon == std::string_view::npos ? "" : word.substr(colon + 1);
  // One part brings one k: of two, which one would a number be for?
  if (name != "drag" && name.ends_with("spring") && force.spring)
    complain(text, "two parts of it are springs; give one, with k for both");
  if ((name == "drag" || name == "damped-spring") && force.damper)
    complain(text, "two parts of it damp; give one, with c for both");
  if (name == "constant") {
    force.degree = std::max(force.degree, 0);
    read_letters(text, rest, false, false, 0, force);
  } else if (name == "poly") {
    std::int64_t degree = -1;
    const std::size_t letters = std::min(rest.find(':'), rest.size());
    try {
      if (!Rational::parse(rest.substr(0, letters)).fits_int64(degree)) degree = -1;
    } catch (const BadInput&) {
      degree = -1;
    }
    if (degree < 0 || degree > kHighestForceDegree)
      complain(text, "the degree is a whole number from 0 to " + std::to_string(kHighestForceDegree) +
                         ", as in poly:3");
    force.degree = std::max(force.degree, static_cast<int>(degree));
    if (letters < rest.size())
      read_letters(text, rest.substr(letters + 1), false, false, static_cast<int>(degree), force);
  } else if (name == "spring" || name == "damped-spring" || name == "drag") {
    if (name != "drag") force.spring = true;
    if (name != "spring") force.damper = true;
    if (name == "drag") force.degree = std::max(force.degree, 0);
    read_letters(text, rest, name != "drag", name != "spring", name == "drag" ? 0 : -1, force);
  } else {
    throw BadInput(
        "unknown force '" + std::string(word.substr(0, 60)) + "'" +
        did_you_mean(name, {"constant", "poly:1", "spring", "damped-spring", "drag"}) +
        " (the forces are constant, poly:D, spring, damped-spring, drag, and sums such as constant+spring)");
  }
}

}  // namespace

Fraction Force::stiffness() const {
  if (!spring) return {};
  if (own_k) return *own_k;
  return k ? Fraction(*k) : Fraction::letter(kStiffness);
}

Fraction Force::damping() const {
  if (!damper) return {};
  if (own_c) return *own_c;
  return c ? Fraction(*c) : Fraction::letter(kDamping);
}

bool Force::numeric() const {
  const auto known = [&](bool there, const auto& value, const auto& own) {
    return !there || value || (own && !own_open);
  };
  return known(spring, k, own_k) && known(damper, c, own_c);
}

Force force_named(std::string_view text) {
  Force force;
  force.degree = -1;
  force.text = std::string(text);
  for (std::size_t begin = 0; begin <= text.size();) {
    std::size_t end = text.find('+', begin);
    if (end == std::string_view::npos) end = text.size();
    read_word(text, text.substr(begin, end - begin), force);
    begin = end + 1;
  }
  if (!force.linear() && force.degree < 0) {  // spring:k=0; formulas have a letter for what is 0 here
    force.degree = 0;
    force.nothing = true;
    force.push[0] = 0;
  }
  return force;
}

}  // namespace shortfall
