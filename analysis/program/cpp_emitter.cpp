// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/cpp_emitter.hpp"

#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/near_root.hpp"
#include "analysis/program/cpp_block.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

namespace {

using Renamed = std::map<std::string, std::string>;

bool has_implicit_stages(const std::vector<Statement>& block) {
  for (const Statement& s : block)
    if (s.kind == Statement::Kind::solve || has_implicit_stages(s.body)) return true;
  return false;
}

bool counts_substeps(const std::vector<Statement>& block, const std::string& name) {
  for (const Statement& s : block)
    if ((s.kind == Statement::Kind::substeps && s.value->op == Expression::Op::name &&
         s.value->name == name) ||
        counts_substeps(s.body, name))
      return true;
  return false;
}

std::string text_number(const Rational& value) { return "number(\"" + value.str() + "\")"; }

class Emitter {
 public:
  explicit Emitter(const Program& program)
      : program_(program), names_(program), constants_(names_), class_(cpp_class_name(program.name)) {
    carried_ = {"x", "v"};
    for (const State& s : program.states) carried_.push_back(s.name);
    kept_ = carried_;
    if (program.impulse) kept_.push_back(program.impulse->name);
    constants_.add(names_("h"), "step");
    Renamed known;
    for (const Parameter& p : program.parameters) {
      const std::string own = names_(p.name);
      constants_.add(own, "parameters." + own);
      known[p.name] = own;
    }
    for (const Root& r : program.roots)
      constants_.add(known[r.name] = names_(r.name), text_number(near(*r.value, kRoundedRootDigits)));
    for (const Approximation& a : program.approximations)
      constants_.add(known[a.name] = names_(a.name), text_number(a.value));
    for (auto [block, lines, indentation] :
         {std::tuple{&program.start, &start_, 2}, std::tuple{&program.step, &step_, 3},
          std::tuple{&program.finish, &finish_, 2}})
      *lines =
          CppBlock(program, names_, constants_, known).lines(*block, block == &program.step, indentation);
  }

  CppClass result() {
    head();
    parameters();
    constructor();
    begin();
    run();
    read_out();
    rest();
    return {class_, out_.str()};
  }

 private:
  static std::string member(const std::string& name) { return name + "_"; }

  void functions_of(const std::string& code, const std::string& indent) {
    for (const char* f : {"exp", "pow", "sqrt"})
      if (code.find(std::string(f) + "(") != std::string::npos) out_ << indent << "using std::" << f << ";\n";
  }

  void statements(const std::vector<std::string>& lines, const std::string& indent) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    functions_of(all, indent);
    out_ << all;
  }

  void head() {
    out_ << "// Written by shortfall from integrators/" << program_.file << ": every change is lost.\n";
    out_ << "#pragma once\n\n#include <array>\n#include <cmath>\n#include <cstdint>\n#include <utility>\n\n"
         << "#include \"analysis/native/stepping.hpp\"\n\nnamespace shortfall::native {\n\n";
    std::istringstream lines(program_.description);
    for (std::string line; std::getline(lines, line);) out_ << "/// " << line << '\n';
    for (const std::string& source : program_.sources) out_ << "/// source  " << source << '\n';
    out_ << "template <class S, class V, class Force>\nclass " << class_ << " {\n public:\n";
  }

  bool is_count(const Parameter& p) const {
    return counts_substeps(program_.start, p.name) || counts_substeps(program_.step, p.name) ||
           counts_substeps(program_.finish, p.name);
  }

  void parameters() {
    out_ << "  struct Parameters {\n    template <class Number>\n"
         << "    explicit Parameters([[maybe_unused]] const Number& number) {\n";
    Renamed known;
    std::string code, fields;
    const Values values = parameter_values(program_);
    for (const Parameter& p : program_.parameters) {
      const std::string own = names_(p.name);
      code += "      " + own + " = ";
      code += (is_count(p) ? text_number(values.at(p.name)) : cpp_scalar(p.fallback, known)) + ";\n";
      fields += "    S " + own + "{};\n";
      known[p.name] = own;
      if (!is_count(p)) continue;
      code += "      " + own + "_times = " + values.at(p.name).str() + ";\n";
      fields += "    int " + own + "_times = 1;  ///< the same, for counting\n";
    }
    functions_of(code, "      ");
    out_ << code << "    }\n\n";
    out_ << "    /// Gives a value to the parameter of that name; false when there is none.\n"
         << "    bool set([[maybe_unused]] std::string_view parameter, [[maybe_unused]] const S& value,\n"
         << "             [[maybe_unused]] int whole) {\n";
    for (const Parameter& p : program_.parameters) {
      const std::string own = names_(p.name);
      out_ << "      if (parameter == \"" << p.name << "\") {\n        " << own << " = value;\n";
      if (is_count(p)) out_ << "        " << own << "_times = whole;\n";
      out_ << "        return true;\n      }\n";
    }
    out_ << "      return false;\n    }\n\n" << fields << "  };\n\n";
  }

  void constructor() {
    out_ << "  /// param   number  the S nearest to an exact number, from its text: \"1/3\"\n"
         << "  template <class Number>\n  " << class_
         << "(const S& step, const V& zero, Force force, const Number& number, const Parameters& "
            "parameters)\n"
         << "      : k_(step, number, parameters), zero_(zero), force_(std::move(force)) {}\n\n";
  }

  void begin() {
    out_ << "  void begin(const V& position, const V& velocity, const S& time) {\n"
         << "    V x = position;\n    V v = velocity;\n    S t = time;\n";
    for (std::size_t k = 2; k < kept_.size(); ++k) out_ << "    V " << names_(kept_[k]) << " = zero_;\n";
    statements(start_, "    ");
    store();
    out_ << "  }\n\n";
  }

  void store() {
    for (const std::string& name : kept_)
      out_ << "    " << member(names_(name)) << " = " << names_(name) << ";\n    apart();\n";
    out_ << "    t_ = t;\n";
  }

  void run() {
    out_ << "  void step() { run(1); }\n\n  void run(std::int64_t steps) {\n";
    for (const std::string& name : kept_)
      out_ << "    V " << names_(name) << " = " << member(names_(name)) << ";\n";
    out_ << "    S t = t_;\n    for (; steps > 0; --steps) {\n";
    statements(step_, "      ");
    if (program_.impulse) out_ << "      " << names_(program_.impulse->name) << " = zero_;\n";
    out_ << "      t = t + k_." << names_("h") << ";\n    }\n";
    store();
    out_ << "  }\n\n";
  }

  void read_out() {
    out_ << "  /// Position and velocity as they are reported; the state stays as it is.\n"
         << "  std::pair<V, V> read_out() const {\n";
    if (finish_.empty()) {
      out_ << "    return {x_, v_};\n  }\n\n";
      return;
    }
    for (const std::string& name : kept_) {
      const bool changes = assignments(program_.finish, name) > 0;
      out_ << "    [[maybe_unused]] " << (changes ? "V " : "const V& ") << names_(name) << " = "
           << member(names_(name)) << ";\n";
    }
    out_ << "    [[maybe_unused]] const S& t = t_;\n";
    statements(finish_, "    ");
    out_ << "    return {x, v};\n  }\n\n";
  }

  void rest() {
    std::string vectors;
    for (const std::string& name : carried_) vectors += (vectors.empty() ? "" : ", ") + member(names_(name));
    const std::string type = "std::array<V, " + std::to_string(carried_.size()) + ">";
    out_ << "  /// x, v and what else is carried from step to step.\n  " << type
         << " carried() const { return " << type << "{" << vectors
         << "}; }\n  const S& time() const { return t_; }\n\n";
    const bool implicit = has_implicit_stages(program_.start) || has_implicit_stages(program_.step) ||
                          has_implicit_stages(program_.finish);
    out_ << "  static constexpr bool kImplicit = " << (implicit ? "true" : "false") << ";\n";
    out_ << "  static constexpr bool kReadsImpulse = " << (program_.impulse ? "true" : "false") << ";\n";
    if (program_.impulse)
      out_ << "  /// An impulse over the mass, which acts in the next step only.\n"
           << "  void give_impulse(const V& impulse) { " << member(names_(program_.impulse->name))
           << " = impulse; }\n";
    out_ << "\n private:\n  /// What stays the same from step to step.\n  struct Constants {\n"
         << "    template <class Number>\n    Constants(const S& step, [[maybe_unused]] const Number& "
            "number,\n"
         << "              [[maybe_unused]] const Parameters& parameters) {\n";
    std::string code, fields;
    for (const CppConstants::Line& l : constants_.lines()) {
      code += "      " + l.member + " = " + l.code + ";\n";
      fields += "    S " + l.member + "{};" + (l.meaning.empty() ? "" : "  ///< " + l.meaning) + "\n";
    }
    functions_of(code, "      ");
    out_ << code;
    for (const Parameter& p : program_.parameters)
      if (is_count(p))
        out_ << "      " << names_(p.name) << "_times = parameters." << names_(p.name) << "_times;\n";
    out_ << "    }\n" << fields;
    for (const Parameter& p : program_.parameters)
      if (is_count(p)) out_ << "    int " << names_(p.name) << "_times = 1;\n";
    out_ << "  };\n\n  Constants k_;\n  V zero_;\n  Force force_;\n";
    for (const std::string& name : kept_) out_ << "  V " << member(names_(name)) << "{};\n";
    out_ << "  S t_{};\n};\n\n}  // namespace shortfall::native\n";
  }

  const Program& program_;
  CppNames names_;
  CppConstants constants_;
  std::string class_;
  std::vector<std::string> carried_;  ///< x, v and the states
  std::vector<std::string> kept_;     ///< with the impulse
  std::vector<std::string> start_, step_, finish_;
  std::ostringstream out_;
};

}  // namespace

CppClass cpp_class(const Program& program) { return Emitter(program).result(); }

}  // namespace shortfall
