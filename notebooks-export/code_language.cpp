// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_language.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"
#include "analysis/program/code_writer.hpp"

namespace shortfall {

namespace {

struct Name {
  std::string_view word;
  Language language;
};

constexpr std::array<Name, 14> kNames{{{"csharp", Language::csharp},
                                       {"c#", Language::csharp},
                                       {"cs", Language::csharp},
                                       {"cpp", Language::cpp},
                                       {"c++", Language::cpp},
                                       {"hpp", Language::cpp},
                                       {"gdscript", Language::gdscript},
                                       {"gd", Language::gdscript},
                                       {"python", Language::python},
                                       {"py", Language::python},
                                       {"rust", Language::rust},
                                       {"rs", Language::rust},
                                       {"javascript", Language::javascript},
                                       {"js", Language::javascript}}};

/// Words that cannot be names in one of the languages, or that our templates use.
const std::set<std::string, std::less<>> kTakenInCode{
    "and",      "as",       "assert",     "async",     "auto",     "await",    "base",      "bool",
    "break",    "case",     "catch",      "char",      "check",    "class",    "const",     "continue",
    "crate",    "decimal",  "def",        "default",   "del",      "delegate", "delete",    "do",
    "double",   "dt",       "dyn",        "elif",      "else",     "enum",     "event",     "except",
    "explicit", "export",   "extends",    "extern",    "false",    "finally",  "fixed",     "float",
    "fn",       "for",      "frame",      "frames",    "from",     "func",     "function",  "global",
    "goto",     "gravity",  "height",     "if",        "impl",     "import",   "in",        "int",
    "is",       "lambda",   "launch",     "let",       "lock",     "long",     "loop",      "match",
    "math",     "max",      "min",        "mod",       "move",     "mut",      "namespace", "new",
    "none",     "not",      "null",       "object",    "operator", "or",       "out",       "override",
    "params",   "pass",     "preload",    "print",     "private",  "pub",      "public",    "raise",
    "range",    "readonly", "ref",        "register",  "return",   "sbyte",    "sealed",    "self",
    "short",    "signal",   "signed",     "sizeof",    "static",   "step",     "string",    "struct",
    "super",    "switch",   "template",   "this",      "throw",    "top",      "trait",     "true",
    "try",      "type",     "typedef",    "typeof",    "uint",     "ulong",    "union",     "unsafe",
    "use",      "using",    "var",        "virtual",   "void",     "volatile", "where",     "while",
    "with",     "yield",    "correction", "tolerance", "substep",  "abs",      "ceil",      "sqrt",
    "jump",     "std"};

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c != '_')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty() && words.size() > 1) words.pop_back();
  return words;
}

std::string capitalised(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

bool is_binary32_number(const Rational& value) { return Rational::from_double(value.to_float()) == value; }

/// Compilers of C# compute constants in more digits than binary32 has. One operation on two numbers of
/// binary32 comes out the same; whatever else is constant is replaced by its value, rounded operation by
/// operation.
Expr without_long_constants(const Expr& e) {
  using Op = Expression::Op;
  if (e->operands.empty()) return e;
  auto copy = std::make_shared<Expression>(*e);
  std::vector<float> values;
  bool constant = e->op != Op::call && e->op != Op::force && e->op != Op::sum, exact = true;
  for (Expr& operand : copy->operands) {
    // Whether the operand is one constant is asked of what was written, not of what it has become.
    exact = exact && operand->op == Op::number && is_binary32_number(operand->value);
    operand = without_long_constants(operand);
    const std::optional<Rational> value = literal_value(operand);
    constant = constant && value;
    if (value) values.push_back(value->to_float());
  }
  if (!constant || exact || e->op == Op::power) return copy;
  const float a = values.front(), b = values.back();
  const float result = e->op == Op::negate     ? -a
                       : e->op == Op::add      ? a + b
                       : e->op == Op::subtract ? a - b
                       : e->op == Op::multiply ? a * b
                                               : a / b;
  if (!std::isfinite(result)) return copy;
  return number(Rational::from_double(result));
}

/// The decimal a rational is, when it is a short one.
std::optional<std::string> short_decimal(const Rational& value) {
  Rational scaled = value;
  for (int places = 0; places <= 12; ++places, scaled *= 10)
    if (scaled.is_integer())
      return scaled.digits() <= 15 ? std::optional(value.decimal(places)) : std::nullopt;
  return std::nullopt;
}

class LanguageWriter : public CodeWriter {
 public:
  LanguageWriter(Language language, const std::map<std::string, std::string>& names, bool wide = false)
      : language_(language), names_(names), wide_(wide) {}

 private:
  std::string title() const override { return shortfall::title(language_); }

  std::string of_name(const std::string& name) const override {
    const auto found = names_.find(name);
    return found != names_.end() ? found->second : identifier(name, language_);
  }

  std::string function(const std::string& name) const override {
    if (name == kCalledForce) return identifier(name, language_);
    const bool known = name == "sqrt" || name == "exp" || name == "pow" || name == "max" || name == "min";
    const bool wide =
        name == "sin" || name == "cos" || name == "sinh" || name == "cosh" || name == "acos" || name == "log";
    if (!known && !(wide && wide_)) return {};
    if (wide_) return in_binary64(name);
    switch (language_) {
      case Language::csharp:
        return name == "max" || name == "min" ? "Math." + capitalised(name)
                                              : "(float)Math." + capitalised(name);
      case Language::cpp:
        return "std::" + name;
      case Language::gdscript:
      case Language::python:
        return name;
      case Language::rust:
        return "f32::" + (name == "pow" ? "powf" : name);
      case Language::javascript:
        return "Math." + name;
    }
    return {};
  }

  std::string in_binary64(const std::string& name) const {
    switch (language_) {
      case Language::csharp:
        return "System.Math." + capitalised(name);
      case Language::python:
        return name == "max" || name == "min" ? name : "math." + name;
      case Language::rust:
        return "f64::" + (name == "pow" ? "powf" : name == "log" ? "ln" : name);
      case Language::cpp:
        return "std::" + name;
      case Language::javascript:
        return "Math." + name;
      case Language::gdscript:
        return name;
    }
    return {};
  }

  std::string whole(const std::string& digits) const {
    switch (language_) {
      case Language::csharp:
      case Language::cpp:
        if (!wide_) return digits + (digits.find('.') == std::string::npos ? ".0f" : "f");
        return digits + (digits.find('.') == std::string::npos ? ".0" : "");
      case Language::gdscript:
      case Language::rust:
        return digits + (digits.find('.') == std::string::npos ? ".0" : "");
      case Language::python:
      case Language::javascript:
        break;
    }
    return digits;
  }

  Piece of_number(const Rational& value) const override {
    if (const auto decimal = short_decimal(value)) return {whole(*decimal), kAtom};
    if (value.is_integer()) return {whole(value.str()), kAtom};
    // A quotient rounds once only while both of its numbers are exact in binary32, or in binary64.
    const Rational exact = Rational(2).pow(wide_ ? 53 : 24);
    // Compilers of C# may read a float as a double first: only its own nine digits round to it both ways.
    const bool twice = language_ == Language::csharp && !wide_;
    if (value.numerator() > exact || value.denominator() > exact)
      return {whole(long_decimal(twice ? Rational::from_double(value.to_float()) : value, twice ? 9 : 25)),
              kAtom};
    return {whole(value.numerator().str()) + " / " + whole(value.denominator().str()), kProduct};
  }

  /// Usually more digits than any of these languages' numbers hold.
  static std::string long_decimal(const Rational& value, int digits) {
    std::string text = value.significant(digits);
    if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text + "0" : text;
  }

  Language language_;
  const std::map<std::string, std::string>& names_;
  bool wide_;  ///< binary64 in every language
};

}  // namespace

std::optional<Language> language_named(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = std::ranges::find(kNames, lower, &Name::word);
  if (found == kNames.end()) return std::nullopt;
  return found->language;
}

const std::vector<std::string>& language_names() {
  static const std::vector<std::string> names{"csharp", "cpp", "gdscript", "python", "rust", "javascript"};
  return names;
}

std::string file_ending(Language language) {
  constexpr std::array<const char*, 6> kEndings{".cs", ".hpp", ".gd", ".py", ".rs", ".js"};
  return kEndings[static_cast<std::size_t>(language)];
}

std::string title(Language language) {
  constexpr std::array<const char*, 6> kTitles{"C#", "C++", "GDScript", "Python", "Rust", "JavaScript"};
  return kTitles[static_cast<std::size_t>(language)];
}

bool is_binary32(Language language) {
  return language == Language::csharp || language == Language::cpp || language == Language::rust;
}

std::string identifier(const std::string& name, Language language) {
  std::string text = name;
  if (language == Language::csharp || language == Language::javascript) {
    const std::vector<std::string> words = words_of(name);
    text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += capitalised(words[i]);
  }
  return kTakenInCode.contains(text) ? text + "_" : text;
}

std::string constant_identifier(const std::string& name, Language language) {
  if (language == Language::csharp || language == Language::cpp) {
    std::string text = language == Language::cpp ? "k" : "";
    for (const std::string& word : words_of(name)) text += capitalised(word);
    return text;
  }
  std::string text;
  for (const char c : name) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string literal(const Rational& value, Language language) { return code(number(value), language); }

std::string code(const Expr& e, Language language, const std::map<std::string, std::string>& names) {
  return LanguageWriter(language, names).text(language == Language::csharp ? without_long_constants(e) : e);
}

std::string code_in_binary64(const Expr& e, Language language,
                             const std::map<std::string, std::string>& names) {
  return LanguageWriter(language, names, true).text(e);
}

std::string decimal_literal(double value, Language language) {
  std::string digits = general_text(value, is_binary32(language) ? 9 : 17);
  if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
  if (digits.find('e') != std::string::npos && digits.find('.') == std::string::npos)
    digits.insert(digits.find('e'), ".0");
  if (language == Language::csharp || language == Language::cpp) digits += "f";
  return value < 0 ? "(" + digits + ")" : digits;
}

void collect_names(const Expr& e, std::vector<std::string>& names) {
  if (e->op == Expression::Op::name && std::ranges::find(names, e->name) == names.end())
    names.push_back(e->name);
  for (const Expr& operand : e->operands) collect_names(operand, names);
}

}  // namespace shortfall
