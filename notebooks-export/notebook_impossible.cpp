// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "notebooks-export/notebook_lecture.hpp"

namespace shortfall {

namespace {

/// Where corrections of a kind may act; `effect` in the notebook knows these words.
const std::map<std::string, std::vector<std::string>> kPlaces{
    {"launch", {"launch v", "read v"}},
    {"launch and read-out", {"launch v", "read v", "launch x", "read x"}},
    {"launch and read-out with a shift in time",
     {"launch v", "read v", "launch x", "read x", "launch x by v0", "read x by v"}},
    {"force and launch", {"force", "launch v", "read v"}},
    {"force alone", {"force"}},
    {"term", {"term x", "term v"}}};

/// The formula in "... the position term FORMULA of the shortfall" is set as code.
std::string reason(const std::string& obstruction) {
  const std::string after = " of the shortfall";
  const std::size_t end = obstruction.rfind(after);
  std::size_t begin = obstruction.find(" term ");
  if (end == std::string::npos || begin == std::string::npos) return markdown_escaped(obstruction);
  begin += 6;
  return markdown_escaped(obstruction.substr(0, begin)) + "`" + obstruction.substr(begin, end - begin) + "`" +
         markdown_escaped(obstruction.substr(end));
}

std::string quoted(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return text;
}

std::string zeros(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += ", zero";
  return text;
}

/// One branch of `effect`.
std::string branch(const std::string& place, const std::string& value) {
  return "    if place == \"" + place + "\":\n        return " + value + "\n";
}

std::string effect(const Lecture& l, const std::vector<std::string>& places) {
  const int count = l.d.degree + 1;
  const std::string tail = ", h" + l.step.more() + ")";
  const std::string frames = l.is_complex() ? "[1]" : "";
  std::string list;
  for (const std::string& letter : l.launch_letters())
    if (letter != "x0" && letter != "v0") list += (list.empty() ? "" : ", ") + letter;
  const auto thrown = [&](const std::string& x, const std::string& v, const std::string& force) {
    return "stepped(LAST, " + x + ", " + v + force + tail + frames;
  };
  const std::map<std::string, std::string> values{
      {"launch x", thrown("h**(k + 2) * force[0]", "zero", zeros(count))},
      {"launch v", thrown("zero", "h**(k + 1) * force[0]", zeros(count))},
      {"launch x by v0", thrown("h * v0", "zero", zeros(count))},
      {"read x", "[(h**(k + 2) * value(force, n * h), zero) for n in range(LAST + 1)]"},
      {"read v", "[(zero, h**(k + 1) * value(force, n * h)) for n in range(LAST + 1)]"},
      {"read x by v", "[(h * exact_velocity(n, " + l.arguments() + "), zero) for n in range(LAST + 1)]"},
      {"force", thrown("zero", "zero", ", *[h**k * c for c in force]")},
      {"term x", "pushed(LAST, [h**(k + 2) * c for c in force], [], zero, zero" + zeros(count) + tail},
      {"term v", "pushed(LAST, [], [h**(k + 1) * c for c in force], zero, zero" + zeros(count) + tail}};
  std::string text = "def effect(place, k, " + l.arguments() +
                     "):\n"
                     "    \"\"\"What a unit of one correction, by h^k times the k-th derivative of the "
                     "force, changes.\"\"\"\n"
                     "    zero = Fraction(0)\n    force = [" +
                     list +
                     "]\n"
                     "    for _ in range(k):\n"
                     "        force = [i * c for i, c in enumerate(force)][1:] + [zero]\n";
  for (const std::string& place : places) text += branch(place, values.at(place));
  return text;
}

std::string machinery(const Lecture& l) {
  std::string units = quoted(l.launch_letters());
  return R"py(def contradictory(rows):
    """Whether linear equations, the right side last, have no solution."""
    rows = [row for row in rows if any(row)]
    for column in range(len(rows[0])):
        pivot = next((row for row in rows if row[column] != 0), None)
        if pivot is None:
            continue
        if column == len(pivot) - 1:
            return True  # 0 = 1
        rows.remove(pivot)
        for i, row in enumerate(rows):
            if row[column] != 0:
                factor = row[column] / pivot[column]
                rows[i] = [p - factor * q for p, q in zip(row, pivot)]
    return False


def impossible(places):
    """Whether no coefficients of such corrections cancel the shortfall."""
    once = ("launch x by v0", "read x by v")
    tried = [(place, k) for place in places for k in range(1 if place in once else )py" +
         std::to_string(l.d.degree + 1) + R"py()]
    for drawn in draws[1:3]:
        equations = []
        for unit in ()py" +
         units + R"py():  # all is linear in these letters: one at a time
            letters = {name: Fraction(name == unit) for name in ()py" +
         units + R"py()}
            letters = {**drawn, **letters}
            effects = [effect(place, k, **letters) for place, k in tried]
            for n in range(FIRST, LAST + 1):
                wanted = shortfall_position(n, **letters), shortfall_velocity(n, **letters)
                for i in range(2):
                    equations.append([e[n][i] for e in effects] + [wanted[i]])
        if not contradictory(equations):
            return False
    return True
)py";
}

}  // namespace

void tell_impossible(Lecture& l) {
  std::string text;
  std::string assertions;
  std::vector<std::string> places;
  for (const CorrectionOption& option : l.kit.options) {
    if (option.exists) continue;
    text += "- **" + sentence(option.name) + "** " + sentence(reason(option.obstruction)) +
            " Known because " +
            sentence(markdown_escaped(option.proof)).replace(0, 1, option.proof.substr(0, 1)) + "\n";
    const auto known = kPlaces.find(option.name);
    if (known == kPlaces.end()) continue;
    assertions += "assert impossible([" + quoted(known->second) + "])  # " + option.name + "\n";
    for (const std::string& place : known->second)
      if (std::ranges::find(places, place) == places.end()) places.push_back(place);
  }
  if (text.empty()) return;
  text +=
      "\nThe cell asserts it. A correction of a kind is a combination of units, each a power of $h$ times "
      "the force or "
      "one of its derivatives, with coefficients to be found. What a unit changes is found by stepping. To "
      "cancel "
      "the shortfall at all frames is a system of linear equations for the coefficients; elimination arrives "
      "at "
      "$0 = 1$.";
  l.document.text("impossible", "### What cannot repair it\n\n" + text);
  std::string code;
  if (std::ranges::find(places, "term x") != places.end()) {
    Repair push;
    push.term_x = name("value(push_x, t)");
    push.term_v = name("value(push_v, t)");
    push.arguments = "push_x, push_v, ";
    code = motion_function(l, "pushed", "The frames when polynomials in t are added at the end of each step.",
                           push, false) +
           "\n\n";
  }
  l.document.code("impossible-check", code + effect(l, places) + "\n\n" + machinery(l) + "\n\n" + assertions +
                                          "print(\"None of these exists.\")\n");
}

}  // namespace shortfall
