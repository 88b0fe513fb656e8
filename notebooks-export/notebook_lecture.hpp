// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "notebooks-export/notebook_document.hpp"
#include "notebooks-export/python_step.hpp"

namespace shortfall {

/// A notebook in the making: what it is about, and the words that its cells share.
///
/// Inside of notebooks-export: each part of the lecture appends its cells.
class Lecture {
 public:
  Lecture(const Program& program, const Values& given, const Derivation& d, const CorrectionKit& kit);

  const Program& program;
  const Values& given;
  const Derivation& d;
  const CorrectionKit& kit;
  PythonStep step;
  NotebookDocument document;
  std::string jump_picture = {};  ///< a PNG of the jump to 40 cm, or empty

  int first;    ///< the frame from which on the closed form holds
  int last;     ///< the last frame that cells compare: enough of them to prove a recurrence
  int settled;  ///< the frame from which on the closed forms of all carried vectors hold

  bool is_exact() const { return !kit.needed; }
  /// Whether more is carried than what is read out.
  bool is_complex() const { return step.carried().size() > 2 || step.has_finish(); }

  /// A formula in Python; n and k are whole numbers.
  std::string python(const Expr& e) const { return shortfall::python(flattened(e), wording_); }
  /// "x0, v0, a, h, beta": the letters of the formulas, as arguments.
  std::string arguments() const;
  /// The letters that a launch brings along: x0, v0, and the force's.
  std::vector<std::string> launch_letters() const;
  /// The acceleration as a formula: a, or f0 + f1 t + ...
  Expr acceleration() const;
  /// What is read out at frame n: x_n, or x_out where `finish` makes it.
  Expr reported(const std::string& letter) const;
  /// At how many consecutive n a line of the derivation is proved.
  int points() const;
  /// "n = 0, ..., 12".
  std::string frames() const;
  /// The next section's heading: "## 3. The derivation".
  std::string heading(const std::string& title);
  /// def NAME(n, LETTERS): the value of a formula at t = n h.
  std::string formula_function(const std::string& name, const std::string& what, const Expr& formula) const;

 private:
  PythonWording wording_;
  int sections_ = 0;
};

/// What a correction changes of a motion; null where it changes nothing.
struct Repair {
  Expr launch_x;
  Expr launch_v;
  Expr read_x;
  Expr read_v;
  Expr force;
  Expr term_x;
  Expr term_v;
  std::string arguments;  ///< more arguments, which these formulas use: "push_x, "
};

/// def NAME(steps, LETTERS): the frames of a motion, stepped, with the corrections applied.
///
/// param   with_carried  whether it returns the carried vectors of every frame as well
std::string motion_function(const Lecture& lecture, const std::string& name, const std::string& what,
                            const Repair& repair, bool with_carried);

/// What an option of the kit changes.
Repair repair(const CorrectionOption& option);
/// with_launch, with_term, ...: what the function that applies an option is called.
std::string repair_name(const CorrectionOption& option);

// The parts of the lecture, in order.
void tell_title(Lecture& lecture);
void tell_integrator(Lecture& lecture);
void tell_problem(Lecture& lecture);
void tell_derivation(Lecture& lecture);
void tell_result(Lecture& lecture);
void tell_corrections(Lecture& lecture);
void tell_impossible(Lecture& lecture);
void tell_jump(Lecture& lecture);
void tell_proof(Lecture& lecture);

}  // namespace shortfall
