// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "analysis/program/program.hpp"

namespace shortfall {

/// What the names of a program become in C++: themselves, unless the word is taken there.
class CppNames {
 public:
  explicit CppNames(const Program& program);

  /// Of a name of the program.
  std::string operator()(const std::string& name) const { return names_.at(name); }
  /// A name that nothing else has: the stem with the first number that is free.
  std::string fresh(const std::string& stem);

 private:
  void add(const std::string& name);
  void add(const std::vector<Statement>& block);

  std::map<std::string, std::string> names_;
  std::set<std::string> used_;
};

/// The name of a class: "velocity-verlet" is VelocityVerlet.
std::string cpp_class_name(const std::string& integrator);

}  // namespace shortfall
