// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/signature.hpp"

#include <algorithm>

namespace shortfall {

const Signature::Slot* Signature::slot(int function, int component) const {
  for (const Slot& s : functions[function].reads)
    if (s.component == component) return &s;
  return nullptr;
}

bool Signature::operator==(const Signature& other) const {
  const auto same_slot = [](const Slot& a, const Slot& b) {
    return a.component == b.component && a.most == b.most;
  };
  return components == other.components &&
         std::ranges::equal(functions, other.functions, [&](const Function& a, const Function& b) {
           return a.name == b.name && a.component == b.component && a.most == b.most &&
                  std::ranges::equal(a.reads, b.reads, same_slot);
         });
}

Signature Signature::first_order() { return {{"y"}, {{"f", 0, {{0}}}}}; }

Signature Signature::first_order_with_time() { return {{"y", "t"}, {{"f", 0, {{0}, {1}}}, {"1", 1, {}}}}; }

Signature Signature::additive() { return {{"y"}, {{"f", 0, {{0}}}, {"g", 0, {{0}}}}}; }

Signature Signature::separable() { return {{"q", "p"}, {{"f", 0, {{1}}}, {"g", 1, {{0}}}}}; }

Signature Signature::mechanical(bool reads_velocity, bool reads_time) {
  Signature s{{"x", "v"}, {{"a", 1, {{0}}}, {"v", 0, {{1, 1}}}}};
  if (reads_velocity) s.functions[0].reads.push_back({1});
  if (reads_time) {
    s.components.push_back("t");
    s.functions[0].reads.push_back({2});
    s.functions.push_back({"1", 2, {}});
  }
  return s;
}

namespace {

/// Multisets by how many there are in them and by the sum of their orders: table[count][order].
using Multisets = std::vector<std::vector<Rational>>;

/// Lets `kinds` more trees of one order into the multisets.
void admit(Multisets& sets, const Rational& kinds, int order) {
  if (kinds.is_zero()) return;
  const int most = static_cast<int>(sets.size()) - 1, total = static_cast<int>(sets[0].size()) - 1;
  // Multisets of i out of N kinds: N (N + 1) ... (N + i - 1) / i!.
  std::vector<Rational> ways{1};
  for (int i = 1; i <= most && i * order <= total; ++i)
    ways.push_back(ways.back() * (kinds + Rational(i - 1)) / Rational(i));
  for (int count = most; count >= 0; --count)
    for (int sum = total; sum >= 0; --sum)
      for (int i = 1; i < static_cast<int>(ways.size()) && i <= count && i * order <= sum; ++i)
        sets[count][sum] += ways[i] * sets[count - i][sum - i * order];
}

}  // namespace

std::vector<Rational> tree_counts(const Signature& signature, int function, int orders) {
  const auto functions = signature.functions.size();
  std::vector<std::vector<Rational>> counts(functions, std::vector<Rational>(orders + 1));
  // For every function and slot, the multisets of children in that slot.
  std::vector<std::vector<Multisets>> children(functions);
  for (std::size_t f = 0; f < functions; ++f)
    for (const Signature::Slot& slot : signature.functions[f].reads) {
      const int most = std::min({slot.most, signature.functions[f].most, orders});
      Multisets none(most + 1, std::vector<Rational>(orders + 1));
      none[0][0] = 1;
      children[f].push_back(none);
    }
  for (int n = 1; n <= orders; ++n) {
    for (std::size_t f = 0; f < functions; ++f) {
      const int most = std::min(signature.functions[f].most, orders);
      Multisets all(most + 1, std::vector<Rational>(n));
      all[0][0] = 1;
      for (const Multisets& slot : children[f]) {
        Multisets joined(most + 1, std::vector<Rational>(n));
        for (int i = 0; i <= most; ++i)
          for (int a = 0; a < n; ++a) {
            if (all[i][a].is_zero()) continue;
            for (int j = 0; j < static_cast<int>(slot.size()) && i + j <= most; ++j)
              for (int b = 0; a + b < n; ++b)
                if (!slot[j][b].is_zero()) joined[i + j][a + b] += all[i][a] * slot[j][b];
          }
        all = std::move(joined);
      }
      for (const auto& by_order : all) counts[f][n] += by_order[n - 1];
    }
    for (std::size_t f = 0; f < functions; ++f)
      for (std::size_t s = 0; s < children[f].size(); ++s) {
        Rational kinds;
        for (std::size_t g = 0; g < functions; ++g)
          if (signature.functions[g].component == signature.functions[f].reads[s].component)
            kinds += counts[g][n];
        admit(children[f][s], kinds, n);
      }
  }
  return counts[function];
}

}  // namespace shortfall
