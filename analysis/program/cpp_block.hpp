// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "analysis/program/cpp_names.hpp"

namespace shortfall {

/// Scalars of a step that do not change while h does not: written once, into the constructor.
///
/// The operations are those of the step, in its order, so that nothing is rounded differently; they are only
/// done once.
class CppConstants {
 public:
  explicit CppConstants(CppNames& names) : names_(names) {}

  struct Line {
    std::string member;
    std::string code;
    std::string meaning;  ///< the expression of the program, for a comment; may be empty
  };

  /// The member that holds a value; of equal values there is one.
  std::string member(const std::string& code, const std::string& meaning);
  void add(const std::string& member, const std::string& code, const std::string& meaning = "");
  const std::vector<Line>& lines() const { return lines_; }

 private:
  CppNames& names_;
  std::vector<Line> lines_;
  std::map<std::string, std::string> known_;  ///< code to member
};

/// A formula of numbers and parameters, as the constructor computes it.
///
/// throws  Unable  as CodeWriter
std::string cpp_scalar(const Expr& e, const std::map<std::string, std::string>& names);

/// Writes one block of a program (start, step or finish) as statements of C++.
class CppBlock {
 public:
  /// param   known  scalars of the head: what their names are in the constructor
  CppBlock(const Program& program, CppNames& names, CppConstants& constants,
           const std::map<std::string, std::string>& known)
      : program_(program), names_(names), constants_(constants), known_(known) {}

  /// throws  Unable  for what cannot be written, with the reason
  std::vector<std::string> lines(const std::vector<Statement>& block, bool is_step, int indentation);

 private:
  /// The h and t of a step, or of a substep.
  struct Clock {
    std::string step;  ///< a member of the constants
    std::string time;  ///< a local
  };

  void statements(const std::vector<Statement>& block, const Clock& clock);
  void assign(const Statement& s, const Clock& clock);
  void solve(const Statement& s, const Clock& clock);
  void substeps(const Statement& s, const Clock& clock);
  void limit(const Statement& s, const Clock& clock);
  void when(const Statement& s, const Clock& clock);
  void declare(const std::string& name, bool vector, const std::string& value);
  /// Declares here what a loop assigns and what is read after it.
  void declare_before(const Statement& loop);

  bool is_vector(const Expr& e) const;
  bool is_constant(const Expr& e) const;
  Expr constant(const Expr& e, const Clock& clock);
  /// Names as C++ has them, constants taken out.
  Expr scalar(const Expr& e, const Clock& clock);
  Expr vector(const Expr& e, const Clock& clock);
  std::string scalar_text(const Expr& e, const Clock& clock);
  std::string vector_text(const Expr& e, const Clock& clock);
  void line(const std::string& text);

  const Program& program_;
  CppNames& names_;
  CppConstants& constants_;
  std::map<std::string, std::string> known_;  ///< constant scalars: what they are in the constructor
  std::set<std::string> vectors_;
  std::set<std::string> scalars_;  ///< locals that are no constants
  std::set<std::string> local_;    ///< everything that has been declared
  bool held_ = false;
  std::size_t depth_ = 0;
  const std::vector<Statement>* whole_ = nullptr;
  std::vector<std::string> out_;
};

/// How often a block assigns a name, inside its substeps and conditions as well.
int assignments(const std::vector<Statement>& block, const std::string& name);
/// Whether a block reads or assigns a name.
bool occurs(const std::vector<Statement>& block, const std::string& name);

}  // namespace shortfall
