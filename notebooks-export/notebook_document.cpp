// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/notebook_document.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "analysis/program/print.hpp"
#include "notebooks-export/base64.hpp"
#include "notebooks-export/python_expression.hpp"

namespace shortfall {

using Op = Expression::Op;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kLineWidth = 72;  // characters of a formula that a notebook's column holds

/// The lines of a cell as the format wants them: each with its line feed, but for the last.
Json lines(std::string source) {
  while (source.ends_with('\n')) source.pop_back();
  Json list = Json::array();
  for (std::size_t begin = 0; begin < source.size();) {
    const std::size_t feed = source.find('\n', begin);
    const std::size_t end = feed == std::string::npos ? source.size() : feed + 1;
    list.push_back(source.substr(begin, end - begin));
    begin = end;
  }
  return list;
}

std::string latex(const Expr& e) {
  std::string text = print(e, Style::latex);
  for (const char* motion : {"x(t)", "v(t)", "x''(t)"}) {
    const std::string to = motion;
    const std::string from = "\\mathrm{" + to + "}";
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  }
  return text;
}

/// How wide an expression is in print, in characters.
int width(const Expr& e) {
  if (e->op == Op::divide) return std::max(width(e->operands[0]), width(e->operands[1])) + 1;
  if (e->op == Op::multiply) return width(e->operands[0]) + width(e->operands[1]);
  int characters = 0;
  for (const char c : print(e, Style::unicode)) characters += (c & 0xC0) != 0x80;
  return characters;
}

void collect_factors(const Expr& e, std::vector<Expr>& factors) {
  if (e->op != Op::multiply) {
    factors.push_back(e);
    return;
  }
  collect_factors(e->operands[0], factors);
  collect_factors(e->operands[1], factors);
}

/// a h^2 n (n - 1) / 2 as it is spoken: a h^2 times the fraction n (n - 1) / 2.
Expr spoken(const Expr& e) {
  if (e->op == Op::add || e->op == Op::subtract)
    return binary(e->op, spoken(e->operands[0]), spoken(e->operands[1]));
  if (e->op != Op::divide || e->operands[1]->op != Op::number) return e;
  std::vector<Expr> factors;
  collect_factors(e->operands[0], factors);
  Expr constant;
  Expr counted;
  for (const Expr& f : factors) {
    Expr& product = mentions(f, "n") ? counted : constant;
    product = product ? binary(Op::multiply, product, f) : f;
  }
  if (!constant || !counted) return e;
  return binary(Op::multiply, constant, binary(Op::divide, counted, e->operands[1]));
}

/// A sum's term as it is written behind its sign.
std::string term_latex(const Expr& term) {
  const std::string text = latex(binary(Op::add, number(0), term));
  return text.substr(4);  // "0 + "
}

/// Lays terms out on lines of an aligned environment.
class AlignedLines {
 public:
  /// param   left  what stands before the first term, with its width in characters
  AlignedLines(const std::string& left, int width) : text_(left + "{}& "), column_(width) {}

  void add(const Expr& e) {
    if (e->op == Op::add || e->op == Op::subtract) {
      add(e->operands[0]);
      add_term(e->op == Op::add ? "+" : "-", e->operands[1]);
    } else {
      add_term("", e);
    }
  }

  std::string str() const { return "$$\n\\begin{aligned}\n" + text_ + "\n\\end{aligned}\n$$"; }

  bool broken() const { return broken_; }

 private:
  void add_term(const std::string& sign, const Expr& term) {
    const int size = width(term) + (sign.empty() ? 0 : 3);
    const bool breaks = term->op == Op::sum && size + kIndent > kLineWidth && column_ < kLineWidth / 2;
    if (column_ + size > kLineWidth && !breaks && !sign.empty() && column_ > kIndent) feed();
    if (!sign.empty()) text_ += (fresh_ ? "{}" + sign : " " + sign) + " ";
    fresh_ = false;
    if (column_ + size > kLineWidth && term->op == Op::sum) {
      add_sum(term);
      return;
    }
    text_ += sign.empty() ? latex(term) : term_latex(term);
    column_ += size;
  }

  /// A sum over more terms than a line holds: its parentheses span lines.
  void add_sum(const Expr& e) {
    text_ += "\\sum_{" + e->name + "=" + latex(e->operands[0]) + "}^{" + latex(e->operands[1]) + "} \\Bigl(";
    column_ += 8;
    add(e->operands[2]);
    text_ += "\\Bigr)";
  }

  void feed() {
    text_ += " \\\\\n& \\quad ";
    column_ = kIndent;
    broken_ = true;
    fresh_ = true;
  }

  static constexpr int kIndent = 6;
  std::string text_;
  int column_;
  bool broken_ = false;
  bool fresh_ = false;
};

}  // namespace

namespace {

Json metadata(const NotebookCell& cell) {
  Json json = Json::object();
  if (cell.graded) {
    const GradedCell& g = *cell.graded;
    json["nbgrader"] = {{"cell_type", cell.is_code ? "code" : "markdown"},
                        {"grade", g.grade},
                        {"grade_id", g.id},
                        {"locked", !g.solution},
                        {"schema_version", 3},
                        {"solution", g.solution},
                        {"task", false}};
    if (g.grade) json["nbgrader"]["points"] = g.points;
  }
  if (!cell.slide.empty()) json["slideshow"] = {{"slide_type", cell.slide}};
  return json;
}

Json outputs(const NotebookCell& cell) {
  Json list = Json::array();
  if (!cell.picture.empty())
    list.push_back(
        {{"data", {{"image/png", base64(cell.picture)}, {"text/plain", Json::array({"<a picture>"})}}},
         {"metadata", Json::object()},
         {"output_type", "display_data"}});
  return list;
}

}  // namespace

std::string NotebookDocument::json() const {
  Json cells = Json::array();
  int number = 0;
  for (const NotebookCell& cell : cells_) {
    const std::string id = (number < 10 ? "0" : "") + std::to_string(number) + "-" + cell.what;
    ++number;
    Json json{{"cell_type", cell.is_code ? "code" : "markdown"}};
    if (cell.is_code) json["execution_count"] = nullptr;
    json["id"] = id.substr(0, 64);
    json["metadata"] = metadata(cell);
    if (cell.is_code) json["outputs"] = outputs(cell);
    json["source"] = lines(cell.source);
    cells.push_back(std::move(json));
  }
  const Json file{
      {"cells", std::move(cells)},
      {"metadata",
       {{"kernelspec", {{"display_name", "Python 3"}, {"language", "python"}, {"name", "python3"}}},
        {"language_info", {{"file_extension", ".py"}, {"mimetype", "text/x-python"}, {"name", "python"}}}}},
      {"nbformat", 4},
      {"nbformat_minor", 5}};
  return file.dump(1) + "\n";
}

std::string markdown_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string("\\`*_{}[]<>#$|~").find(c) != std::string::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string displayed(const Expr& left, const Expr& right) {
  const Expr terms = spoken(flattened(right));
  AlignedLines lines(latex(left) + " =", width(left) + 3);
  lines.add(terms);
  return lines.broken() ? lines.str() : "$$ " + latex(left) + " = " + latex(terms) + " $$";
}

std::string displayed(const Expr& e) {
  const Expr terms = flattened(e);
  AlignedLines lines("", 0);
  lines.add(terms);
  return lines.broken() ? lines.str() : "$$ " + latex(terms) + " $$";
}

bool is_long(const Expr& e) { return width(e) > kLineWidth / 2; }

std::string inlined(const Expr& e) { return "$" + latex(flattened(e)) + "$"; }

std::string sentence(const std::string& text) {
  std::string result = text;
  if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
  if (!result.ends_with('.')) result += '.';
  return result;
}

}  // namespace shortfall
