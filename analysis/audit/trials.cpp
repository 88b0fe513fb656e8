// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/trials.hpp"

#include <map>

namespace shortfall {

namespace {

using Part = Cell::Part;

constexpr std::size_t kManyStages = 24;  // pairs of entries are not tried beyond
constexpr std::size_t kOftenest = 64;    // a number written more often is no coefficient

class Trials {
 public:
  explicit Trials(const AuditedTableau& t) : t_(t), s_(t.stages()) {
    for (std::size_t i = 0; i < s_; ++i)
      for (std::size_t j = i; j < s_; ++j) explicit_ = explicit_ && t.digits.a[i][j].is_zero();
  }

  std::vector<Trial> single() {
    const std::vector<Cell> all = cells(t_.texts);
    for (const Cell& cell : all)
      if (is_free(cell)) add(Mend::Kind::entry, {{{cell, 1}}});
    repeated(all);
    exchanged_rows();
    if (s_ <= kManyStages) exchanged_entries();
    return std::move(trials_);
  }

  std::vector<Trial> twofold() {
    for (std::size_t i = 0; i < s_; ++i)
      for (std::size_t j = 0; j < s_; ++j) {
        const Cell cell{Part::a, i, j};
        if (!is_free(cell)) continue;
        if (t_.c_given && !t_.nystroem) add(Mend::Kind::entries, {{{cell, 1}, {{Part::c, i, 0}, 1}}}, 1.5);
        for (std::size_t k = j + 1; k < s_ && s_ <= kManyStages; ++k)
          if (is_free({Part::a, i, k})) add(Mend::Kind::entries, {{{cell, 1}, {{Part::a, i, k}, -1}}}, 1.5);
      }
    for (const Part part : {Part::b, Part::embedded, Part::b_position, Part::embedded_position}) {
      const std::size_t count = const_cast<AuditedTableau&>(t_).texts.row(part).size();
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
          add(Mend::Kind::entries, {{{{part, i, 0}, 1}}, {{{part, j, 0}, 1}}}, 1);
    }
    return std::move(trials_);
  }

 private:
  void add(Mend::Kind kind, std::vector<std::vector<Trial::Step>> unknowns, double cost = 0) {
    trials_.push_back({kind, std::move(unknowns), {}, !t_.c_given, "", cost});
  }
  void exchange(std::vector<std::pair<Cell, Cell>> pairs, const std::string& words, double cost) {
    trials_.push_back({Mend::Kind::exchange, {}, std::move(pairs), !t_.c_given, words, cost});
  }

  /// Whether an entry may be something else: an explicit method stays explicit.
  bool is_free(const Cell& cell) const {
    if (cell.part == Part::c) return t_.c_given;
    return cell.part != Part::a || !explicit_ || cell.j < cell.i;
  }

  void repeated(const std::vector<Cell>& all) {
    std::map<std::string, std::vector<Cell>> by_text;
    for (const Cell& cell : all)
      if (is_free(cell) && !t_.digits.at(cell).is_zero()) by_text[t_.texts.at(cell)].push_back(cell);
    for (const auto& [text, where] : by_text) {
      if (where.size() < 2 || where.size() > kOftenest) continue;
      std::vector<Trial::Step> unknown;
      for (const Cell& cell : where) unknown.push_back({cell, 1});
      add(Mend::Kind::everywhere, {unknown}, 0.5);
    }
  }

  void exchange_parts(Part one, Part other, const std::string& words) {
    Method<std::string>& texts = const_cast<AuditedTableau&>(t_).texts;
    if (texts.row(one).empty() || texts.row(other).empty()) return;
    std::vector<std::pair<Cell, Cell>> pairs;
    for (std::size_t i = 0; i < s_; ++i) pairs.push_back({{one, i, 0}, {other, i, 0}});
    exchange(std::move(pairs), words, 1.2);
  }

  void exchanged_rows() {
    exchange_parts(Part::b, Part::embedded, "b and bhat are exchanged");
    exchange_parts(Part::b, Part::b_position, "b and bbar are exchanged");
    exchange_parts(Part::b, Part::c, "b and c are exchanged");
    std::vector<std::pair<Cell, Cell>> transposed;
    for (std::size_t i = 0; i < s_; ++i) {
      for (std::size_t j = 0; j < i; ++j) transposed.push_back({{Part::a, i, j}, {Part::a, j, i}});
      for (std::size_t k = i + 1; k < s_; ++k) {
        std::vector<std::pair<Cell, Cell>> rows;
        for (std::size_t j = 0; j < s_; ++j) rows.push_back({{Part::a, i, j}, {Part::a, k, j}});
        const std::string words =
            "rows " + std::to_string(i + 1) + " and " + std::to_string(k + 1) + " of A ";
        exchange(rows, words + "are exchanged", 1.6);
        if (!t_.c_given) continue;
        rows.push_back({{Part::c, i, 0}, {Part::c, k, 0}});
        exchange(rows, words + "are exchanged, with their times", 1.8);
      }
    }
    if (!transposed.empty()) exchange(transposed, "A is transposed", 1.5);
  }

  void exchanged_entries() {
    for (std::size_t i = 0; i < s_; ++i)
      for (std::size_t j = 0; j < s_; ++j) {
        const Cell cell{Part::a, i, j};
        for (std::size_t k = j + 1; k < s_; ++k)
          two(cell, {Part::a, i, k}, "two entries of a row are exchanged", 1.5);
        for (std::size_t k = i + 1; k < s_; ++k)
          two(cell, {Part::a, k, j}, "two entries of a column are exchanged", 1.7);
      }
    for (const Part part : {Part::b, Part::embedded, Part::b_position, Part::embedded_position, Part::c}) {
      const std::size_t count = const_cast<AuditedTableau&>(t_).texts.row(part).size();
      for (std::size_t i = 0; i < count; ++i) {
        if (part == Part::embedded || part == Part::b_position)
          two({Part::b, i, 0}, {part, i, 0}, "entries of two rows of weights are exchanged", 1.8);
        for (std::size_t j = i + 1; j < count; ++j)
          two({part, i, 0}, {part, j, 0},
              part == Part::c ? "two times are exchanged" : "two weights are exchanged", 1.5);
      }
    }
  }
  void two(const Cell& one, const Cell& other, const std::string& words, double cost) {
    if (is_free(one) && is_free(other)) exchange({{one, other}}, words, cost);
  }

  const AuditedTableau& t_;
  std::size_t s_;
  bool explicit_ = true;
  std::vector<Trial> trials_;
};

}  // namespace

std::vector<Trial> single_slips(const AuditedTableau& t) { return Trials(t).single(); }
std::vector<Trial> double_slips(const AuditedTableau& t) { return Trials(t).twofold(); }

}  // namespace shortfall
