// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/tableau_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <ranges>

#include "analysis/program/check.hpp"
#include "analysis/program/counted.hpp"
#include "analysis/program/file_text.hpp"
#include "analysis/program/json_text.hpp"
#include "analysis/program/nystroem.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/tableau.hpp"
#include "analysis/program/tableau_entry.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kMostStages = 64;
constexpr std::size_t kLongestLine = 100'000;  // programs write JSON on a single line
constexpr int kMostDigits = 1000;

/// A name for an integrator made of any text: lower case, what is no letter and no digit a hyphen; "" when
/// nothing is left.
std::string as_name(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!result.empty() && !result.ends_with('-'))
      result += '-';
  }
  while (result.ends_with('-') || result.size() > Program::kLongestName) result.pop_back();
  if (!result.empty() && std::isdigit(static_cast<unsigned char>(result[0]))) result = "method-" + result;
  return result;
}

/// Without blanks at its ends; nor does a description begin with the sign of a comment.
std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of("# \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::string stem(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find('.'));
}

class TableauReader {
 public:
  TableauReader(const Source& source, const JsonValue& whole) : source_(source), whole_(whole) {}

  TableauFile read() {
    refuse_unknown_tableau_keys();
    read_kind();
    read_names();
    TableauEntryReader entries(source_, decimals(), digits());
    const JsonValue& b = required("b", "the weights");
    if (list(b, "b").items.empty()) throw source_.error(b.place, "b is empty: a method has a stage at least");
    if (b.items.size() > kMostStages)
      throw source_.error(b.place, "the tableau has " + std::to_string(b.items.size()) + " stages; at most " +
                                       std::to_string(kMostStages) + " are read");
    stages_ = b.items.size();
    const std::string matrix = file_.nystroem ? "Abar" : "A";
    file_.a = square(required(matrix, "the coefficients of the stages"), matrix, entries);
    file_.b = row(b, "b", entries);
    if (file_.nystroem)
      file_.b_position = row(required("bbar", "the weights of the position"), "bbar", entries);
    if (const JsonValue* v = whole_.find("bhat")) file_.embedded = row(*v, "bhat", entries);
    if (const JsonValue* v = whole_.find("bbarhat")) file_.embedded_position = row(*v, "bbarhat", entries);
    if (const JsonValue* v = whole_.find("c"))
      file_.c = row(*v, "c", entries);
    else if (file_.nystroem)
      throw source_.error(whole_.place, "the tableau has no \"c\", the times of the stages");
    else
      file_.c = row_sums();
    read_claims();
    file_.program.approximations = entries.approximations();
    lower();
    return std::move(file_);
  }

 private:
  void refuse_unknown_tableau_keys() const {
    if (whole_.kind != JsonValue::Kind::object)
      throw source_.error(
          whole_.place,
          R"(a tableau file is one object, {"A": [..], "b": [..], "c": [..]}; found )" + whole_.described());
    for (const auto& [key, value] : whole_.members) {
      const std::string& word = key.text;
      if (std::ranges::find(tableau_keys(), word) != tableau_keys().end()) continue;
      // A single letter is near to every other one.
      const std::string near = word.size() > 1 ? nearest(word, tableau_keys())
                               : word == "a"   ? "A"
                               : word == "B"   ? "b"
                               : word == "C"   ? "c"
                                               : "";
      throw source_.error(key.place,
                          "a tableau has no key \"" + word.substr(0, 40) + "\"" +
                              (near.empty() ? "; it has A, b, c, bhat, order, ... (docs/tableau.md)"
                                            : "; did you mean \"" + near + "\"?"));
    }
  }

  const JsonValue& required(const std::string& key, const std::string& meaning) const {
    if (const JsonValue* value = whole_.find(key)) return *value;
    if (key == "Abar" && whole_.find("A"))
      throw source_.error(whole_.find("A")->place,
                          "the coefficients of a Nystroem tableau are called \"Abar\"");
    throw source_.error(whole_.place, "the tableau has no \"" + key + "\", " + meaning);
  }

  const JsonValue& list(const JsonValue& value, const std::string& what) const {
    if (value.kind != JsonValue::Kind::array)
      throw source_.error(value.place, "expected a list for " + what + ", found " + value.described());
    return value;
  }

  std::string text(const JsonValue& value, const std::string& what) const {
    if (value.kind != JsonValue::Kind::string)
      throw source_.error(value.place, "expected a text for " + what + ", found " + value.described());
    return trimmed(value.text);
  }

  std::vector<std::string> texts(const std::string& key) const {
    const JsonValue* value = whole_.find(key);
    if (!value) return {};
    std::vector<std::string> all;
    if (value->kind != JsonValue::Kind::array) all.push_back(text(*value, key));
    for (const JsonValue& item : value->items) all.push_back(text(item, key));
    std::erase(all, "");
    return all;
  }

  void read_kind() {
    if (const JsonValue* value = whole_.find("kind")) {
      const std::string kind = text(*value, "kind");
      if (kind != "runge-kutta" && kind != "nystroem")
        throw source_.error(value->place, R"(the kind of a tableau is "runge-kutta" or "nystroem")" +
                                              did_you_mean(kind, {"runge-kutta", "nystroem"}));
      file_.nystroem = kind == "nystroem";
    }
    if (file_.nystroem) return;
    for (const char* key : {"Abar", "bbar", "bbarhat"})
      if (const JsonValue* value = whole_.find(key))
        throw source_.error(value->place,
                            std::string(key) + R"( belongs to a Nystroem tableau, "kind": "nystroem")");
  }

  void read_names() {
    Program& p = file_.program;
    p.file = source_.file();
    const JsonValue* value = whole_.find("name");
    const std::string written = value ? text(*value, "name") : "";
    p.name = as_name(written);
    if (p.name.empty()) p.name = as_name(stem(source_.file()));
    if (p.name.empty()) p.name = "tableau";
    if (!written.empty() && written != p.name) p.aliases.push_back(written);
    for (const std::string& alias : texts("alias")) p.aliases.push_back(alias);
    p.sources = texts("source");
    if (const JsonValue* d = whole_.find("description")) p.description = text(*d, "description");
    if (const JsonValue* n = whole_.find("note")) file_.note = text(*n, "note");
    file_.name = p.name;
  }

  TableauEntryReader::Decimals decimals() const {
    using Decimals = TableauEntryReader::Decimals;
    const JsonValue* value = whole_.find("decimals");
    if (!value) return Decimals::by_length;
    const std::string word = text(*value, "decimals");
    if (word == "exact") return Decimals::exact;
    if (word == "rounded") return Decimals::rounded;
    throw source_.error(value->place,
                        R"(decimals are "exact" or "rounded")" + did_you_mean(word, {"exact", "rounded"}));
  }

  int whole_number(const JsonValue& value, const std::string& what, int from, int to) const {
    std::int64_t n = 0;
    if (value.kind != JsonValue::Kind::number || value.text.size() > 9 ||
        !Rational::parse(value.text).fits_int64(n) || n < from || n > to)
      throw source_.error(value.place, what + " is a whole number from " + std::to_string(from) + " to " +
                                           std::to_string(to) + ", not " + value.described());
    return static_cast<int>(n);
  }

  std::optional<int> digits() const {
    const JsonValue* value = whole_.find("digits");
    if (!value) return std::nullopt;
    return whole_number(*value, "digits", 1, kMostDigits);
  }

  std::vector<TableauEntry> row(const JsonValue& value, const std::string& what,
                                TableauEntryReader& entries) const {
    list(value, what);
    if (value.items.size() != stages_)
      throw source_.error(value.place, what + " has " + counted(value.items.size(), "entry", "entries") +
                                           ", but b has " + std::to_string(stages_));
    std::vector<TableauEntry> result;
    for (const JsonValue& item : value.items)
      result.push_back(entries.entry(item, what + std::to_string(result.size() + 1)));
    return result;
  }

  /// Refuses the first row that does not fit into the form that most rows have: full, or a lower or strictly
  /// lower triangle.
  void check_lengths(const JsonValue& value, const std::string& what) const {
    const auto wanted = [&](int form, std::size_t i) { return form == 0 ? stages_ : form == 1 ? i + 1 : i; };
    std::array<std::size_t, 3> fitting{};
    for (int form = 0; form < 3; ++form)
      for (std::size_t i = 0; i < stages_; ++i)
        fitting[form] += value.items[i].items.size() == wanted(form, i);
    const int form = static_cast<int>(std::ranges::max_element(fitting) - fitting.begin());
    static constexpr std::array<const char*, 3> kForms{"a full row", "that row of a lower triangle",
                                                       "that row of a strictly lower triangle"};
    for (std::size_t i = 0; i < stages_; ++i)
      if (value.items[i].items.size() != wanted(form, i))
        throw source_.error(value.items[i].place,
                            "row " + std::to_string(i + 1) + " of " + what + " has " +
                                counted(value.items[i].items.size(), "entry", "entries") + "; " +
                                kForms[form] + " has " + std::to_string(wanted(form, i)));
  }

  /// A full matrix; or a lower or strictly lower triangle, of the latter also without its first, empty row.
  std::vector<std::vector<TableauEntry>> square(const JsonValue& value, const std::string& what,
                                                TableauEntryReader& entries) const {
    const std::size_t rows = list(value, what).items.size();
    for (const JsonValue& item : value.items) list(item, "a row of " + what);
    std::vector<std::size_t> lengths;
    for (const JsonValue& item : value.items) lengths.push_back(item.items.size());
    bool growing = true;
    for (std::size_t i = 0; i < lengths.size(); ++i) growing = growing && lengths[i] == i + 1;
    const bool without_first = rows + 1 == stages_ && growing;
    if (rows != stages_ && !without_first)
      throw source_.error(value.place, what + " has " + counted(rows, "row", "rows") + ", but b has " +
                                           counted(stages_, "entry", "entries"));
    if (!without_first) check_lengths(value, what);
    std::vector<std::vector<TableauEntry>> result;
    if (without_first) result.emplace_back();
    for (std::size_t i = 0; i < rows; ++i) {
      const JsonValue& line = value.items[i];
      const std::size_t number = result.size() + 1;
      result.emplace_back();
      for (const JsonValue& item : line.items)
        result.back().push_back(entries.entry(item, (file_.nystroem ? "abar" : "a") + std::to_string(number) +
                                                        "_" + std::to_string(result.back().size() + 1)));
    }
    for (std::size_t i = 0; i < stages_; ++i) {
      const Place place =
          i == 0 && without_first ? value.place : value.items[i - (without_first ? 1 : 0)].place;
      while (result[i].size() < stages_)
        result[i].push_back({number(0, place), Rational(0), "0", false, {}, place});
    }
    return result;
  }

  std::vector<TableauEntry> row_sums() {
    file_.c_given = false;
    std::vector<TableauEntry> sums;
    for (const auto& line : file_.a) {
      TableauEntry sum{nullptr, Rational(0), "", false, {}, line[0].place};
      bool simple = true;
      for (const TableauEntry& e : line) {
        if (sum.exact) sum.exact = e.exact ? std::optional(*sum.exact + *e.exact) : std::nullopt;
        simple = simple && !e.digits;
        if (e.digits) sum.digits = sum.digits ? std::min(*sum.digits, *e.digits) : *e.digits;
        if (is_number(e.value, 0)) continue;
        sum.value = sum.value ? binary(Expression::Op::add, sum.value, e.value, e.place) : e.value;
      }
      if (!sum.value || (simple && sum.exact)) sum.value = number(sum.exact.value_or(Rational(0)), sum.place);
      sum.text = print(sum.value);
      sums.push_back(std::move(sum));
    }
    return sums;
  }

  void state(std::optional<Stated<int>>& claim, const std::string& key, int from) const {
    const JsonValue* value = whole_.find(key);
    if (!value) return;
    const int most = static_cast<int>(2 * stages_);
    std::int64_t n = 0;
    if (value->kind == JsonValue::Kind::number && value->text.size() < 9 &&
        Rational::parse(value->text).fits_int64(n) && n > kHighestClaimedOrder)
      throw source_.error(value->place, key + " is at most " + std::to_string(kHighestClaimedOrder) +
                                            ", of which there are 12,826,228 conditions already; found " +
                                            value->text);
    claim = {whole_number(*value, key, from, kHighestClaimedOrder), value->place};
    if (claim->value > most)
      throw source_.error(value->place, "no method with " + counted(stages_, "stage", "stages") +
                                            " has an order above " + std::to_string(most) + "; " + key +
                                            " is " + std::to_string(claim->value));
  }

  void state(std::optional<Stated<bool>>& claim, const std::string& key) const {
    const JsonValue* value = whole_.find(key);
    if (!value) return;
    if (value->kind != JsonValue::Kind::boolean)
      throw source_.error(value->place, key + " is true or false, not " + value->described());
    claim = {value->text == "true", value->place};
  }

  void read_claims() {
    TableauClaims& claims = file_.claims;
    state(claims.order, "order", 1);
    state(claims.embedded_order, "embedded_order", 1);
    state(claims.stage_order, "stage_order", 0);
    state(claims.symplectic, "symplectic");
    state(claims.symmetric, "symmetric");
    state(claims.a_stable, "A-stable");
    state(claims.l_stable, "L-stable");
    if (claims.embedded_order && file_.embedded.empty())
      throw source_.error(claims.embedded_order->place, "embedded_order is claimed, but there is no bhat");
    if (file_.nystroem && file_.embedded.empty() != file_.embedded_position.empty())
      throw source_.error(whole_.place, "bhat and bbarhat of a Nystroem tableau stand together");
  }

  static std::vector<Expr> values(const std::vector<TableauEntry>& row) {
    std::vector<Expr> result;
    for (const TableauEntry& e : row) result.push_back(e.value);
    return result;
  }

  void lower() {
    Program& p = file_.program;
    std::vector<std::vector<Expr>> a;
    for (const auto& line : file_.a) a.push_back(values(line));
    if (file_.nystroem) {
      lower_nystroem(
          p, {std::move(a), values(file_.b_position), values(file_.b), values(file_.c), whole_.place});
    } else {
      // As in the language: a row stops behind its last entry.
      for (auto& line : a)
        while (!line.empty() && is_number(line.back(), 0)) line.pop_back();
      p.tableau =
          Tableau{values(file_.c), std::move(a), values(file_.b), values(file_.embedded), whole_.place};
      lower_tableau(p, source_);
    }
    check(p, source_);
  }

  const Source& source_;
  const JsonValue& whole_;
  TableauFile file_;
  std::size_t stages_ = 0;
};

}  // namespace

const std::vector<std::string>& tableau_keys() {
  static const std::vector<std::string> all{
      "name", "description", "kind",       "alias",     "source",   "A",       "Abar",  "b",
      "bbar", "bhat",        "bbarhat",    "c",         "decimals", "digits",  "order", "embedded_order",
      "note", "stage_order", "symplectic", "symmetric", "A-stable", "L-stable"};
  return all;
}

TableauFile parse_tableau(std::string_view text, const std::string& file) {
  const Source source(file, text, kLongestLine);
  const JsonValue whole = json_value(source);
  return TableauReader(source, whole).read();
}

TableauFile parse_tableau_file(const std::string& path) { return parse_tableau(file_text(path), path); }

}  // namespace shortfall
