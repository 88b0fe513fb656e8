// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "notebooks-export/notebook_lecture.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;

/// What the left side of a line is about: v of v_n, v_k and v_{k+1}; "" for lines about no carried quantity.
std::string subject(const DerivationStep& s) {
  if (s.left->op != Op::name) return "";
  for (const char* index : {"_{k+1}", "_k", "_n"})
    if (s.left->name.ends_with(index))
      return s.left->name.substr(0, s.left->name.size() - std::string(index).size());
  return "";
}

bool is_read_out(const DerivationStep& s) { return s.left->op == Op::name && s.left->name.ends_with("_out"); }

std::string title(const Lecture& l, const std::string& subject) {
  const std::string letter = inlined(name(subject));
  if (subject == "x") return "The position";
  if (subject == "v") return "The velocity";
  const auto& carried = l.step.carried();
  return (std::ranges::find(carried, subject) == carried.end() ? "The increase " : "The carried ") + letter;
}

/// Lines in Python: quantities are lists over the frames, x[n] and v[k + 1].
class PythonLines {
 public:
  PythonLines(const Lecture& l, std::vector<std::string> quantities)
      : l_(l), quantities_(std::move(quantities)) {
    wording_.name = [this](const std::string& name) { return named(name); };
    wording_.whole = {"n", "k"};
  }

  std::string python(const Expr& e) const { return shortfall::python(flattened(e), wording_); }

  /// The name of a quantity's list.
  std::string list(const std::string& quantity) const { return l_.step.name(quantity); }

 private:
  std::string named(const std::string& name) const {
    for (const auto& [ending, index] :
         {std::pair<std::string, std::string>{"_{k+1}", "k + 1"}, {"_k", "k"}, {"_n", "n"}}) {
      if (!name.ends_with(ending)) continue;
      const std::string stem = name.substr(0, name.size() - ending.size());
      if (std::ranges::find(quantities_, stem) != quantities_.end()) return list(stem) + "[" + index + "]";
    }
    return l_.step.name(name);
  }

  const Lecture& l_;
  std::vector<std::string> quantities_;
  PythonWording wording_;
};

/// A reason with its powers raised.
std::string raised(std::string text) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"^2", "²"}, {"^3", "³"}, {"^m", "ᵐ"}})
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from))
      text.replace(at, 2, to);
  return text;
}

/// A line as a paragraph: the reason, then the formula.
std::string paragraph(const DerivationStep& s) {
  return "**" + sentence(markdown_escaped(raised(s.why))) + "**\n\n" + displayed(s.left, s.right) + "\n\n";
}

}  // namespace

void tell_derivation(Lecture& l) {
  std::vector<std::string> subjects;  // in the order in which they are told
  for (const DerivationStep& s : l.d.steps)
    if (const std::string about = subject(s);
        !about.empty() && std::ranges::find(subjects, about) == subjects.end())
      subjects.push_back(about);
  std::vector<std::string> quantities = l.step.carried();
  for (const std::string& s : subjects)
    if (std::ranges::find(quantities, s) == quantities.end()) quantities.push_back(s);
  const PythonLines lines(l, quantities);

  l.document.text(
      "derivation",
      l.heading("The derivation") +
          "\n\nWrite one step out, unroll it into a sum over all steps before, and do the sum. Each line "
          "follows from the one above it for the reason given. The cells do not trust the reasons: they "
          "take each line literally, add up its sums term by term, and put for $x_k$ and $v_k$ what "
          "stepping gave.");
  for (const std::string& about : subjects) {
    std::string text = "### " + title(l, about) + "\n\n";
    std::string definition;
    std::string by_step;
    std::string by_frame;
    for (const DerivationStep& s : l.d.steps) {
      if (subject(s) != about) continue;
      text += paragraph(s);
      const std::string right = lines.python(s.right);
      if (s.left->name.ends_with("_k")) {  // it says what the quantity is
        definition += "    " + lines.list(about) + " = []\n    for k in range(LAST + 1):\n" +
                      wrapped(8, lines.list(about) + ".append(", right + ")") + "\n";
        continue;
      }
      const std::string assertion = "        # " + sentence(s.why) + "\n" +
                                    wrapped(8, "assert " + lines.python(s.left) + " == ", right) + "\n";
      (s.left->name.ends_with("_n") ? by_frame : by_step) += assertion;
    }
    l.document.text("derivation", text);
    std::string code = std::string("for letters, ") + (l.is_complex() ? "(carried, _)" : "frames") +
                       " in zip(draws, runs):\n    " + l.arguments() + " = letters.values()\n    " +
                       l.step.state() + " = zip(*" + (l.is_complex() ? "carried" : "frames") + ")\n";
    // Differences that were introduced before are known from then on.
    for (const DerivationStep& s : l.d.steps) {
      const std::string earlier = subject(s);
      if (earlier == about) break;
      if (earlier.empty() || !s.left->name.ends_with("_k")) continue;
      code += "    " + lines.list(earlier) + " = []\n    for k in range(LAST + 1):\n" +
              wrapped(8, lines.list(earlier) + ".append(", lines.python(s.right) + ")") + "\n";
    }
    code += definition;
    if (!by_step.empty()) code += "    for k in range(LAST):\n" + by_step;
    if (!by_frame.empty())
      code += "    for n in range(" + (l.settled == 0 ? "" : std::to_string(l.settled) + ", ") +
              "LAST + 1):\n" + "        t = n * h\n" + by_frame;
    l.document.code("derivation-check", code + "print(\"Each line holds.\")\n");
  }

  std::string text;
  std::string code;
  for (const DerivationStep& s : l.d.steps) {
    if (!is_read_out(s)) continue;
    text += paragraph(s);
    code += wrapped(8, "assert frames[n][" + std::string(s.left->name == "x_out" ? "0" : "1") + "] == ",
                    lines.python(s.right)) +
            "\n";
  }
  if (code.empty()) return;
  l.document.text("read-out", "### What is read out\n\n" + text);
  l.document.code("read-out-check", "for letters, (_, frames) in zip(draws, runs):\n    " + l.arguments() +
                                        " = letters.values()\n" +
                                        "    for n in range(FIRST, LAST + 1):\n        t = n * h\n" + code +
                                        "print(\"Each line holds.\")\n");
}

}  // namespace shortfall
