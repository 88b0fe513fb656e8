// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/modified_text.hpp"

#include <algorithm>

#include "notebooks-export/series_text.hpp"

namespace shortfall {

namespace {

std::string derivative_of(const std::string& component, Style style) {
  return style == Style::latex ? "\\dot{" + component + "}" : component + "'";
}

/// x' = v + ..., for each component.
std::string equations(const ModifiedEquation& m, const SeriesSource& source, Style style) {
  std::string text;
  const std::vector<std::string> components =
      m.forces ? std::vector<std::string>{"x", "v"} : std::vector<std::string>{"y"};
  for (const std::string& component : components) {
    SumByPowers sum(source, style);
    std::string first;
    for (const FieldTerm& t : m.terms) {
      if (t.component != component) continue;
      if (first.empty() && t.power == 0)
        first = style == Style::latex ? t.latex : t.differential;
      else
        sum.add(t.power, t.coefficient, style == Style::latex ? t.latex : t.differential);
    }
    const std::string rest = sum.str("       ");
    const std::string highest = "\n       + O(" + print(power(name("h"), m.order), style) + ")";
    if (style == Style::latex)
      text += derivative_of(component, style) + " = " + first + sum.str() + " + O(" +
              print(power(name("h"), m.order), style) + ")\n";
    else
      text += "  " + derivative_of(component, style) + " = " + first + rest + highest + "\n";
  }
  return text;
}

/// V' V'' and so on in one dimension.
std::string product(const std::vector<int>& factors, Style style) {
  std::string text;
  const auto times = [&](const std::string& base, int count, bool primes) {
    if (count == 0) return;
    if (!text.empty()) text += " ";
    if (count == 1) {
      text += base;
    } else if (style == Style::latex) {
      text += (primes ? "(" + base + ")" : base) + "^{" + std::to_string(count) + "}";
    } else {
      text += (primes ? "(" + base + ")" : base) + "^" + std::to_string(count);
    }
  };
  if (!factors.empty()) times("v", factors[0], false);
  for (std::size_t k = 1; k < factors.size(); ++k)
    times(k <= 3
              ? "V" + std::string(k, '\'')
              : (style == Style::latex ? "V^{(" + std::to_string(k) + ")}" : "V^(" + std::to_string(k) + ")"),
          factors[k], true);
  return text;
}

/// Terms that are the same in one dimension, added up.
std::vector<std::pair<std::pair<int, std::vector<int>>, Fraction>> in_one_dimension(
    const ModifiedHamiltonian& h) {
  std::vector<std::pair<std::pair<int, std::vector<int>>, Fraction>> sum;
  for (const EnergyTerm& t : h.terms) {
    const std::pair key{t.power, t.in_one_dimension};
    const auto found = std::ranges::find_if(sum, [&](const auto& s) { return s.first == key; });
    if (found == sum.end())
      sum.push_back({key, t.coefficient});
    else
      found->second += t.coefficient;
  }
  std::erase_if(sum, [](const auto& s) { return s.second.is_zero(); });
  return sum;
}

}  // namespace

std::string one_dimensional_sum(const ModifiedHamiltonian& h, const SeriesSource& source, Style style,
                                const std::string& indent) {
  SumByPowers sum(source, style);
  for (const auto& [key, coefficient] : in_one_dimension(h))
    sum.add(key.first, coefficient, product(key.second, style));
  return sum.str(indent);
}

std::string hamiltonian_sum(const ModifiedHamiltonian& h, const SeriesSource& source, Style style,
                            const std::string& indent) {
  SumByPowers sum(source, style);
  for (const EnergyTerm& t : h.terms)
    sum.add(t.power, t.coefficient, style == Style::latex ? t.latex : t.contraction);
  return sum.str(indent);
}

std::string as_text(const ModifiedEquation& m, const SeriesSource& source, Style style) {
  if (style == Style::latex) return m.obstruction.empty() ? equations(m, source, style) : "";
  const std::string about = m.forces ? "x'' = " + m.forces->force : std::string("y' = f(y)");
  std::string text = m.integrator + ", for " + about + "\n";
  for (const std::string& note : m.notes) text += "  " + note + "\n";
  if (!m.obstruction.empty())
    return text + "No force, given to the step instead of a, makes it exact: " + m.obstruction +
           ".\n  With a launch and a read-out more is possible: shortfall correct " + m.integrator +
           " --force general\n";
  text += m.modifying ? "Given this instead, the step solves the equation above exactly, order by order:\n"
                      : "The step solves, order by order,\n";
  text += equations(m, source, style);
  text += "  (" + exactness_note(m.digits) + "; " + std::to_string(m.trees) + " trees up to order " +
          std::to_string(m.order) + "; checksum, the plain sum of b(t): " +
          (m.digits > 0 ? source.decimal(m.checksum, 12) + " (rounded)" : print(source.formula(m.checksum))) +
          ")\n";
  return text;
}

std::string as_text(const ModifiedHamiltonian& h, const SeriesSource& source, Style style) {
  if (style == Style::latex) {
    if (!h.exists()) return "";
    return "\\tilde H = \\tfrac12 v^2 + V" + hamiltonian_sum(h, source, style, {}) + " + O(h^{" +
           std::to_string(h.order) + "})\n";
  }
  if (!h.exists())
    return "There is no modified Hamiltonian: at h^" + std::to_string(h.obstructed_at) + ", " +
           h.obstruction + ".\n";
  const std::string highest = " + O(" + print(power(name("h"), h.order), style) + ")";
  std::string text = "For a = -V'(x), mass 1, it conserves, order by order,\n  H = " +
                     print(power(name("v"), 2) / number(2), style) + " + V" +
                     hamiltonian_sum(h, source, style, "      ") + "\n     " + highest + "\n";
  bool time = false;
  for (const EnergyTerm& t : h.terms) time = time || t.in_one_dimension.empty();
  if (!time)
    text += "In one dimension\n  H = " + print(power(name("v"), 2) / number(2), style) + " + V" +
            one_dimensional_sum(h, source, style, "      ") + "\n     " + highest + "\n";
  return text;
}

}  // namespace shortfall
