// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/traced_lines.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;
using Node = const Expression*;
using NodeNames = std::unordered_map<Node, std::string>;

constexpr std::size_t kMostOperations = 20000;
constexpr int kLongestFormula = 16;  ///< longer ones are cut into named lines
constexpr std::size_t kMostPermuted = 4;

/// The expressions that lead to some results, equal ones once, operands before what is made of them.
class Graph {
 public:
  explicit Graph(const std::vector<Target>& targets) {
    for (const auto& [name, e] : targets) results.push_back({name, unique(e)});
    for (const Expr& e : nodes_)
      for (const Expr& operand : e->operands) ++uses_[operand.get()];
    for (const auto& [name, e] : results) ++uses_[e.get()];
    for (const Expr& e : nodes_) decide(e);
  }

  std::vector<Target> results;

  /// What has to be a line of its own before this can be written.
  std::vector<Expr> before(const Expr& top, const NodeNames& known) const {
    std::unordered_set<Node> found, seen;
    std::vector<Node> stack;
    for (const Expr& operand : top->operands) stack.push_back(operand.get());
    while (!stack.empty()) {
      const Node e = stack.back();
      stack.pop_back();
      if (known.contains(e) || !seen.insert(e).second) continue;
      if (named_.contains(e)) found.insert(e);
      for (const Expr& operand : e->operands) stack.push_back(operand.get());
    }
    std::vector<Expr> lines;
    for (const Expr& e : nodes_)
      if (found.contains(e.get())) lines.push_back(e);
    return lines;
  }

  bool is_vector(Node e) const { return vectors_.contains(e); }

 private:
  Expr unique(const Expr& top) {
    std::vector<Expr> stack{top};
    while (!stack.empty()) {
      const Expr e = stack.back();
      bool ready = true;
      for (auto operand = e->operands.rbegin(); operand != e->operands.rend(); ++operand)
        if (!known_.contains(operand->get())) {
          stack.push_back(*operand);
          ready = false;
        }
      if (!ready) continue;
      stack.pop_back();
      if (!known_.contains(e.get())) known_.emplace(e.get(), the_one(e));
    }
    return known_.at(top.get());
  }

  Expr the_one(const Expr& e) {
    auto copy = std::make_shared<Expression>(*e);
    std::string key = std::to_string(static_cast<int>(e->op)) + " " + e->name + " " +
                      (e->op == Op::number ? e->value.str() : "");
    for (Expr& operand : copy->operands) {
      operand = known_.at(operand.get());
      key += " " + std::to_string(index_.at(operand.get()));
    }
    const auto [at, is_new] = by_key_.try_emplace(key, copy);
    if (!is_new) return at->second;
    if (nodes_.size() >= kMostOperations)
      throw BadInput("the step makes more than " + std::to_string(kMostOperations) +
                     " operations; write loops as `substeps` in an .integrator file");
    index_.emplace(copy.get(), nodes_.size());
    nodes_.push_back(copy);
    return copy;
  }

  void decide(const Expr& e) {
    const bool leaf = e->operands.empty();
    bool vector = e->op == Op::force || (leaf && e->op == Op::name && e->name != "h" && e->name != "t");
    int size = leaf ? 0 : 1;
    for (const Expr& operand : e->operands) {
      if (e->op != Op::force && vectors_.contains(operand.get())) vector = true;
      if (!named_.contains(operand.get())) size += size_.at(operand.get());
    }
    size_.emplace(e.get(), size);
    if (vector) vectors_.insert(e.get());
    if (leaf) return;
    const bool cheap = !vector && size <= 2;
    // An exponent is a number and stays with its base.
    if ((uses_[e.get()] > 1 && !cheap) || size > kLongestFormula) named_.insert(e.get());
  }

  std::vector<Expr> nodes_;
  std::unordered_map<Node, Expr> known_;
  std::unordered_map<Node, std::size_t> index_;
  std::map<std::string, Expr> by_key_;
  std::unordered_map<Node, int> uses_, size_;
  std::unordered_set<Node> named_, vectors_;
};

/// The expression as one formula, in which what has a name is said by it.
Expr said(const Expr& e, const NodeNames& names, bool top = true) {
  if (const auto found = names.find(e.get()); found != names.end() && !top) return name(found->second);
  if (e->operands.empty()) return e;
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = said(operand, names, false);
  return copy;
}

bool reads(const Expr& e, const NodeNames& names, const std::set<std::string>& overwritten, bool top = true) {
  if (!top && names.contains(e.get())) return false;
  if (e->op == Op::name) return overwritten.contains(e->name);
  return std::ranges::any_of(e->operands,
                             [&](const Expr& operand) { return reads(operand, names, overwritten, false); });
}

Statement assignment(const std::string& target, Expr value) {
  Statement s;
  s.name = target;
  s.value = std::move(value);
  return s;
}

std::string unused(const std::string& stem, std::set<std::string>& taken) {
  for (int i = 1;; ++i)
    if (std::string candidate = stem + std::to_string(i); taken.insert(candidate).second) return candidate;
}

/// The lines when the targets are assigned in this order; none when one would read what is overwritten.
std::optional<std::vector<Statement>> lines_in_order(const Graph& graph, const std::vector<Target>& order,
                                                     std::set<std::string> taken) {
  std::vector<Statement> lines;
  std::set<std::string> overwritten;
  NodeNames names;
  const auto say = [&](const std::string& target, const Expr& e) {
    if (const auto found = names.find(e.get()); found != names.end())
      lines.push_back(assignment(target, name(found->second)));
    else if (reads(e, names, overwritten))
      return false;
    else
      lines.push_back(assignment(target, said(e, names)));
    return true;
  };
  for (const auto& [target, e] : order) {
    for (const Expr& line : graph.before(e, names)) {
      const char* const stem = line->op == Op::force ? "a" : graph.is_vector(line.get()) ? "u" : "s";
      const std::string local = unused(stem, taken);
      if (!say(local, line)) return std::nullopt;
      names.emplace(line.get(), local);
    }
    if (!say(target, e)) return std::nullopt;
    overwritten.insert(target);
    if (!e->operands.empty()) names.emplace(e.get(), target);
  }
  return lines;
}

}  // namespace

std::vector<Statement> traced_lines(const std::vector<Target>& targets, const std::set<std::string>& taken) {
  const Graph graph(targets);
  std::vector<Target> order;
  for (const Target& t : graph.results)
    if (t.second->op != Op::name || t.second->name != t.first) order.push_back(t);
  if (order.empty()) return {};
  std::vector<std::size_t> places(order.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  std::optional<std::vector<Statement>> best;
  do {
    std::vector<Target> permuted;
    for (const std::size_t place : places) permuted.push_back(order[place]);
    auto lines = lines_in_order(graph, permuted, taken);
    if (lines && (!best || lines->size() < best->size())) best = std::move(lines);
  } while (order.size() <= kMostPermuted && std::ranges::next_permutation(places).found);
  if (best) return *best;
  // Each but the last gets a name of its own first; nothing is read after the last.
  std::set<std::string> names = taken;
  std::vector<Target> copies = order;
  for (std::size_t i = 0; i + 1 < copies.size(); ++i) {
    copies[i].first += "_new";
    if (!names.insert(copies[i].first).second) copies[i].first = unused(copies[i].first, names);
  }
  best = lines_in_order(graph, copies, names);
  for (std::size_t i = 0; i + 1 < copies.size(); ++i)
    best->push_back(assignment(order[i].first, name(copies[i].first)));
  return *best;
}

}  // namespace shortfall
