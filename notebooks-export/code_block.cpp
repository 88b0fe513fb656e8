// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_block.hpp"

#include "analysis/algebra/comma_list.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kColumns = 110;

}  // namespace

std::string CodeBlock::member(const std::string& name) const {
  switch (language_) {
    case Language::python:
    case Language::rust:
      return "self." + name;
    case Language::javascript:
      return "this." + name;
    default:
      return name;
  }
}

void CodeBlock::line(const std::string& text) {
  if (!text.empty()) {
    if (language_ == Language::gdscript)
      text_ += std::string(static_cast<std::size_t>(depth_), '\t');
    else
      text_ += std::string(static_cast<std::size_t>(depth_) *
                               (language_ == Language::cpp || language_ == Language::javascript ? 2 : 4),
                           ' ');
  }
  text_ += text + "\n";
}

void CodeBlock::comment(const std::string& text) {
  const std::string mark = braces() ? "// " : "# ";
  std::string row;
  for (std::size_t begin = 0; begin <= text.size();) {
    std::size_t end = text.find(' ', begin);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (!row.empty() && row.size() + 1 + word.size() > kColumns) {
      line(mark + row);
      row.clear();
    }
    row += (row.empty() ? "" : " ") + word;
  }
  if (!row.empty()) line(mark + row);
}

void CodeBlock::assign(const std::string& left, const std::string& value) {
  line(left + " = " + value + (braces() ? ";" : ""));
}

void CodeBlock::let(const std::string& name, const std::string& value) {
  switch (language_) {
    case Language::csharp:
      return line("double " + name + " = " + value + ";");
    case Language::cpp:
      return line("const double " + name + " = " + value + ";");
    case Language::gdscript:
      return line("var " + name + ": float = " + value);
    case Language::python:
      return line(name + " = " + value);
    case Language::rust:
      return line("let " + name + " = " + value + ";");
    case Language::javascript:
      return line("const " + name + " = " + value + ";");
  }
}

void CodeBlock::open(const std::string& head) {
  line(head + (braces() ? " {" : ":"));
  ++depth_;
}

void CodeBlock::open_if(const std::string& condition) {
  open(!braces() || language_ == Language::rust ? "if " + condition : "if (" + condition + ")");
}

void CodeBlock::open_else_if(const std::string& condition) {
  --depth_;
  switch (language_) {
    case Language::python:
    case Language::gdscript:
      return open("elif " + condition);
    case Language::rust:
      return open("} else if " + condition);
    default:
      return open("} else if (" + condition + ")");
  }
}

void CodeBlock::open_else() {
  --depth_;
  open(braces() ? "} else" : "else");
}

void CodeBlock::open_loop(const std::string& index, int count) {
  const std::string last = std::to_string(count), past = std::to_string(count + 1);
  switch (language_) {
    case Language::csharp:
    case Language::cpp:
      return open("for (int " + index + " = 1; " + index + " <= " + last + "; ++" + index + ")");
    case Language::javascript:
      return open("for (let " + index + " = 1; " + index + " <= " + last + "; ++" + index + ")");
    case Language::gdscript:
    case Language::python:
      return open("for " + index + " in range(1, " + past + ")");
    case Language::rust:
      return open("for " + index + " in 1..=" + last);
  }
}

std::string CodeBlock::as_number(const std::string& index) const {
  return language_ == Language::rust ? "f64::from(" + index + ")" : index;
}

void CodeBlock::leave_loop_if(const std::string& condition) {
  if (!braces()) {
    line("if " + condition + ":");
    ++depth_;
    line("break");
    --depth_;
  } else if (language_ == Language::rust) {
    line("if " + condition + " { break; }");
  } else {
    line("if (" + condition + ") break;");
  }
}

void CodeBlock::nothing() {
  if (!braces()) line("pass");
}

void CodeBlock::close() {
  --depth_;
  if (braces()) line("}");
}

std::string CodeBlock::parameters(const std::vector<std::string>& arguments) const {
  std::vector<std::string> list;
  for (const std::string& a : arguments) switch (language_) {
      case Language::csharp:
      case Language::cpp:
        list.push_back("double " + a);
        break;
      case Language::gdscript:
        list.push_back(a + ": float");
        break;
      case Language::rust:
        list.push_back(a + ": f64");
        break;
      case Language::python:
      case Language::javascript:
        list.push_back(a);
        break;
    }
  return comma_list(list);
}

std::string CodeBlock::routine_name(const std::string& name) const {
  switch (language_) {
    case Language::csharp:
      return constant_identifier(name, language_);
    case Language::javascript:
      return identifier(name, language_);
    default:
      return name;
  }
}

void CodeBlock::open_class(const std::string& name, const std::vector<std::string>& members,
                           const std::vector<std::string>& arguments) {
  const std::string given = parameters(arguments);
  switch (language_) {
    case Language::csharp:
      open("public sealed class " + name);
      line("public double " + comma_list(members) + ";");
      line();
      open("public " + name + "(" + given + ")");
      for (const std::string& a : arguments) assign("this." + a, a);
      break;
    case Language::cpp:
      open("struct " + name);
      for (const std::string& m : members) line("double " + m + " = 0;");
      line();
      open("explicit " + name + "(" + given + ")");
      for (const std::string& a : arguments) assign("this->" + a, a);
      break;
    case Language::gdscript:
      open("class " + name);
      for (const std::string& m : members) line("var " + m + ": float = 0.0");
      line();
      open("func _init(" + given + ")");
      for (const std::string& a : arguments) assign("self." + a, a);
      break;
    case Language::python:
      open("class " + name);
      open("def __init__(self, " + given + ")");
      for (const std::string& a : arguments) assign("self." + a, a);
      break;
    case Language::rust: {
      line("#[allow(dead_code)]");
      line("#[derive(Clone, Copy, Debug, Default)]");
      open("pub struct " + name);
      for (const std::string& m : members) line("pub " + m + ": f64,");
      close();
      line();
      line("#[allow(dead_code)]");
      open("impl " + name);
      open("pub fn new(" + given + ") -> Self");
      line("let mut kit = Self { " + comma_list(arguments) + ", ..Self::default() };");
      break;
    }
    case Language::javascript:
      open("class " + name);
      open("constructor(" + given + ")");
      for (const std::string& a : arguments) assign("this." + a, a);
      break;
  }
}

void CodeBlock::close_constructor(const std::string& routine) {
  if (language_ == Language::rust) {
    line("kit." + routine_name(routine) + "();");
    line("kit");
  } else {
    call(routine, {});
  }
  close();
}

void CodeBlock::close_class() {
  --depth_;
  if (braces()) line(language_ == Language::cpp ? "};" : "}");
}

std::string CodeBlock::both(const std::string& a, const std::string& b) const {
  return a + (braces() ? " && " : " and ") + b;
}

void CodeBlock::open_routine(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string given = parameters(arguments), called = routine_name(name);
  line();
  switch (language_) {
    case Language::csharp:
    case Language::cpp:
      return open("void " + called + "(" + given + ")");
    case Language::gdscript:
      return open("func " + called + "(" + given + ") -> void");
    case Language::python:
      return open("def " + called + "(self" + (given.empty() ? "" : ", ") + given + ")");
    case Language::rust:
      return open("fn " + called + "(&mut self" + (given.empty() ? "" : ", ") + given + ")");
    case Language::javascript:
      return open(called + "(" + given + ")");
  }
}

void CodeBlock::call(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string said = routine_name(name) + "(" + comma_list(arguments) + ")";
  line(member(said) + (braces() ? ";" : ""));
}

void CodeBlock::function(const std::string& name, const std::vector<std::string>& arguments,
                         const std::string& value) {
  const std::string given = parameters(arguments), called = routine_name(name);
  switch (language_) {
    case Language::csharp:
      open("public double " + called + "(" + given + ")");
      break;
    case Language::cpp:
      open("double " + called + "(" + given + ") const");
      break;
    case Language::gdscript:
      open("func " + called + "(" + given + ") -> float");
      break;
    case Language::python:
      open("def " + called + "(self" + (given.empty() ? "" : ", ") + given + ")");
      break;
    case Language::rust:
      open("pub fn " + called + "(&self" + (given.empty() ? "" : ", ") + given + ") -> f64");
      line(value);
      return close();
    case Language::javascript:
      open(called + "(" + given + ")");
      break;
  }
  line("return " + value + (braces() ? ";" : ""));
  close();
}

std::string CodeBlock::magnitude(const std::string& value) const {
  switch (language_) {
    case Language::csharp:
      return "System.Math.Abs(" + value + ")";
    case Language::cpp:
      return "std::abs(" + value + ")";
    case Language::gdscript:
      return "absf(" + value + ")";
    case Language::python:
      return "abs(" + value + ")";
    case Language::rust:
      return "(" + value + ").abs()";
    case Language::javascript:
      return "Math.abs(" + value + ")";
  }
  return {};
}

std::string CodeBlock::not_a_number() const {
  switch (language_) {
    case Language::csharp:
      return "double.NaN";
    case Language::cpp:
      return "std::nan(\"\")";
    case Language::gdscript:
      return "NAN";
    case Language::python:
      return "math.nan";
    case Language::rust:
      return "f64::NAN";
    case Language::javascript:
      return "NaN";
  }
  return {};
}

}  // namespace shortfall
