// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_table.hpp"

#include <algorithm>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

/// The byte at which a column, counted in characters from 1, begins.
std::size_t byte_of(const std::string& line, std::uint32_t column) {
  std::size_t byte = 0;
  for (std::uint32_t c = 1; c < column && byte < line.size(); ++c) {
    ++byte;
    while (byte < line.size() && (static_cast<unsigned char>(line[byte]) & 0xC0) == 0x80) ++byte;
  }
  return byte;
}

}  // namespace

SceneText::SceneText(const std::string& text, const std::string& file) : source_(file, text) {
  try {
    root_ = toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw error(e.source().begin, std::string(e.description()));
  }
}

SyntaxError SceneText::error(const toml::source_position& at, const std::string& what) const {
  const int line = std::clamp(static_cast<int>(at.line), 1, std::max(1, source_.line_count()));
  return source_.error({line, std::max(1, static_cast<int>(at.column))}, what);
}

SyntaxError SceneText::error(const toml::node& at, const std::string& what) const {
  return error(at.source().begin, what);
}

void SceneText::check_keys(const toml::table& table, const std::string& where,
                           const std::vector<std::string>& keys) const {
  for (const auto& [key, node] : table) {
    const std::string word(key.str());
    if (std::ranges::find(keys, word) != keys.end()) continue;
    throw error(key.source().begin, "unknown key '" + word + "' in " + where + did_you_mean(word, keys) +
                                        " (there " + (keys.size() == 1 ? "is " : "are ") + comma_list(keys) +
                                        ")");
  }
}

const toml::node* SceneText::find(const toml::table& table, const std::string& key) const {
  return table.get(key);
}

const toml::node& SceneText::need(const toml::table& table, const std::string& key,
                                  const std::string& where) const {
  const toml::node* node = table.get(key);
  if (!node) throw error(table, where + " needs a key '" + key + "'");
  return *node;
}

std::string SceneText::text(const toml::node& node, const std::string& key) const {
  const auto* value = node.as_string();
  if (!value) throw error(node, key + " is a text in quotes");
  return value->get();
}

bool SceneText::truth(const toml::node& node, const std::string& key) const {
  const auto* value = node.as_boolean();
  if (!value) throw error(node, key + " is true or false");
  return value->get();
}

std::int64_t SceneText::whole(const toml::node& node, const std::string& key, std::int64_t least,
                              std::int64_t most) const {
  const auto* value = node.as_integer();
  if (!value || value->get() < least || value->get() > most)
    throw error(node,
                key + " is a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value->get();
}

std::vector<const toml::table*> SceneText::tables(const toml::table& table, const std::string& key) const {
  std::vector<const toml::table*> result;
  const toml::node* node = table.get(key);
  if (!node) return result;
  if (const toml::table* one = node->as_table())
    throw error(*one, "there can be several of '" + key + "': write [[" + key + "]]");
  for (const toml::node& entry : array(*node, key)) {
    if (!entry.is_table()) throw error(entry, "each " + key + " is a table: write [[" + key + "]]");
    result.push_back(entry.as_table());
  }
  return result;
}

const toml::array& SceneText::array(const toml::node& node, const std::string& key) const {
  if (!node.is_array()) throw error(node, key + " is a list in [ ]");
  return *node.as_array();
}

std::vector<std::string> SceneText::words(const toml::node& node, const std::string& key) const {
  std::vector<std::string> result;
  for (const toml::node& entry : array(node, key)) result.push_back(text(entry, key));
  return result;
}

/// The text of a number: toml++ itself would round it.
std::string SceneText::written(const toml::node& node) const {
  const toml::source_region& where = node.source();
  const std::string& line = source_.line(static_cast<int>(where.begin.line));
  const std::size_t begin = byte_of(line, where.begin.column), end = byte_of(line, where.end.column);
  std::string result = line.substr(begin, end - begin);
  std::erase(result, '_');
  if (result.starts_with('+')) result.erase(0, 1);
  return result;
}

PhysicalQuantity SceneText::quantity(const toml::node& node, const std::string& key) const {
  try {
    if (const auto* value = node.as_string()) return physical_quantity(value->get());
    if (const auto* value = node.as_integer()) return {Rational(value->get()), std::nullopt};
    if (node.is_floating_point()) return {Rational::parse(written(node)), std::nullopt};
  } catch (const BadInput& e) {
    throw error(node, key + ": " + e.what());
  } catch (const Undefined& e) {
    throw error(node, key + ": " + e.what());
  }
  throw error(node, key + R"( is a number, or a text such as "9.81 m/s^2")");
}

Rational SceneText::number(const toml::node& node, const std::string& key, const PhysicalDimension& dimension,
                           const UnitSystem& units) const {
  const PhysicalQuantity q = quantity(node, key);
  if (!q.dimension) return q.value;
  if (*q.dimension == dimension) return units.from_si(q.value, dimension);
  // A step of 60 Hz is one of 1/60 s.
  if (dimension == kPhysicalTime && *q.dimension == kPhysicalRate) {
    if (q.value.is_zero()) throw error(node, key + ": 0 Hz is no step");
    return units.from_si(Rational(1) / q.value, dimension);
  }
  const std::string unit = UnitSystem().unit(dimension);
  throw error(node, key + " has the dimension " + dimension.str() +
                        (unit.empty() ? " (a pure number)" : " (a unit is " + unit + ")") + ", and this is " +
                        q.dimension->str());
}

}  // namespace shortfall
