// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/force.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

constexpr int kHighestDegree = 1000;

[[noreturn]] void complain(std::string_view text, const std::string& why) {
  throw BadInput("--force '" + std::string(text.substr(0, 60)) + "': " + why);
}

/// k=4,c=1/2 after the colon.
void read_letters(std::string_view text, std::string_view letters, Force& force) {
  for (std::size_t begin = 0; begin < letters.size();) {
    std::size_t end = letters.find(',', begin);
    if (end == std::string_view::npos) end = letters.size();
    const std::string_view one = letters.substr(begin, end - begin);
    begin = end + 1;
    const bool known = one.starts_with("k=") || one.starts_with("c=");
    if (!known) complain(text, "after the colon stand the letters k and c, as in damped-spring:k=4,c=1/2");
    const bool k = one[0] == 'k';
    if (k ? !force.spring : !force.damper) complain(text, std::string("this force has no ") + one[0]);
    Rational value;
    try {
      value = Rational::parse(one.substr(2));
    } catch (const BadInput& e) {
      complain(text, e.what());
    }
    (k ? force.k : force.c) = value;
    // Nothing is lost: a spring of stiffness 0 is no spring.
    if (value.is_zero()) (k ? force.spring : force.damper) = false;
  }
}

void read_word(std::string_view text, std::string_view word, Force& force) {
  const std::size_t colon = word.find(':');
  const std::string name(word.substr(0, colon));
  const std::string_view rest = colon == std::string_view::npos ? "" : word.substr(colon + 1);
  if (name == "constant" && colon == std::string_view::npos) {
    force.degree = std::max(force.degree, 0);
  } else if (name == "poly") {
    std::int64_t degree = -1;
    try {
      if (!Rational::parse(rest).fits_int64(degree)) degree = -1;
    } catch (const BadInput&) {
      degree = -1;
    }
    if (degree < 0 || degree > kHighestDegree)
      complain(text,
               "the degree is a whole number from 0 to " + std::to_string(kHighestDegree) + ", as in poly:3");
    force.degree = std::max(force.degree, static_cast<int>(degree));
  } else if (name == "spring" || name == "damped-spring" || name == "drag") {
    if (name != "drag") force.spring = true;
    if (name != "spring") force.damper = true;
    if (name == "drag") force.degree = std::max(force.degree, 0);
    read_letters(text, rest, force);
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
  return k ? Fraction(*k) : Fraction::letter(kStiffness);
}

Fraction Force::damping() const {
  if (!damper) return {};
  return c ? Fraction(*c) : Fraction::letter(kDamping);
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
  if (!force.linear() && force.degree < 0) force.degree = 0;  // spring:k=0: a free body; its force is a = 0
  return force;
}

}  // namespace shortfall
