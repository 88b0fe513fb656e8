// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/cpp_names.hpp"

#include <cctype>
#include <string_view>

namespace shortfall {

namespace {

/// Words of C++, and those that the written class uses for itself.
const std::set<std::string, std::less<>> kTaken{"S",
                                                "V",
                                                "Force",
                                                "Number",
                                                "Parameters",
                                                "Constants",
                                                "alignas",
                                                "alignof",
                                                "and",
                                                "and_eq",
                                                "any",
                                                "apart",
                                                "asm",
                                                "auto",
                                                "begin",
                                                "bitand",
                                                "bitor",
                                                "bool",
                                                "break",
                                                "carried",
                                                "case",
                                                "catch",
                                                "char",
                                                "char16_t",
                                                "char32_t",
                                                "char8_t",
                                                "chosen",
                                                "class",
                                                "co_await",
                                                "co_return",
                                                "co_yield",
                                                "compl",
                                                "concept",
                                                "const",
                                                "const_cast",
                                                "consteval",
                                                "constexpr",
                                                "constinit",
                                                "continue",
                                                "decltype",
                                                "default",
                                                "delete",
                                                "do",
                                                "double",
                                                "dynamic_cast",
                                                "else",
                                                "enum",
                                                "exp",
                                                "explicit",
                                                "export",
                                                "extern",
                                                "false",
                                                "float",
                                                "for",
                                                "friend",
                                                "give_impulse",
                                                "goto",
                                                "guess",
                                                "held",
                                                "if",
                                                "inline",
                                                "int",
                                                "larger",
                                                "limited",
                                                "long",
                                                "longer",
                                                "mutable",
                                                "namespace",
                                                "new",
                                                "noexcept",
                                                "not",
                                                "not_eq",
                                                "nullptr",
                                                "number",
                                                "operator",
                                                "or",
                                                "or_eq",
                                                "parameters",
                                                "position",
                                                "pow",
                                                "private",
                                                "protected",
                                                "public",
                                                "read_out",
                                                "register",
                                                "reinterpret_cast",
                                                "requires",
                                                "return",
                                                "run",
                                                "short",
                                                "shortfall",
                                                "signed",
                                                "sizeof",
                                                "smaller",
                                                "solve_stages",
                                                "sqrt",
                                                "static",
                                                "static_assert",
                                                "static_cast",
                                                "std",
                                                "step",
                                                "steps",
                                                "struct",
                                                "switch",
                                                "template",
                                                "this",
                                                "thread_local",
                                                "throw",
                                                "time",
                                                "true",
                                                "try",
                                                "typedef",
                                                "typeid",
                                                "typename",
                                                "union",
                                                "unsigned",
                                                "using",
                                                "velocity",
                                                "virtual",
                                                "void",
                                                "volatile",
                                                "wchar_t",
                                                "while",
                                                "xor",
                                                "xor_eq",
                                                "linux",
                                                "unix"};

}  // namespace

CppNames::CppNames(const Program& program) {
  for (const char* given : {"h", "t", "x", "v"}) add(std::string(given));
  for (const Parameter& p : program.parameters) add(p.name);
  for (const Root& r : program.roots) add(r.name);
  for (const Approximation& a : program.approximations) add(a.name);
  for (const State& s : program.states) add(s.name);
  if (program.impulse) add(program.impulse->name);
  for (const auto* block : {&program.start, &program.step, &program.finish}) add(*block);
}

void CppNames::add(const std::vector<Statement>& block) {
  for (const Statement& s : block) {
    if (s.kind == Statement::Kind::assign) add(s.name);
    for (const Unknown& u : s.unknowns) add(u.name);
    add(s.body);
  }
}

void CppNames::add(const std::string& name) {
  if (names_.contains(name)) return;
  // What ends in an underscore is a member of the class; a double one belongs to the compiler.
  const bool free = !kTaken.contains(name) && name.front() != '_' && name.back() != '_' &&
                    name.find("__") == std::string::npos && used_.insert(name).second;
  names_[name] = free ? name : fresh("name");
}

std::string CppNames::fresh(const std::string& stem) {
  for (int k = 0;; ++k)
    if (std::string name = stem + std::to_string(k); !names_.contains(name) && used_.insert(name).second)
      return name;
}

std::string cpp_class_name(const std::string& integrator) {
  std::string result;
  bool begins = true;
  for (const char c : integrator) {
    if (!std::isalnum(static_cast<unsigned char>(c))) {
      begins = true;
      continue;
    }
    if (result.empty() && std::isdigit(static_cast<unsigned char>(c))) result = "Method";
    result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return result;
}

}  // namespace shortfall
