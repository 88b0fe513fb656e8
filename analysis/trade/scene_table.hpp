// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/source.hpp"
#include "analysis/trade/physical_quantity.hpp"

namespace shortfall {

/// What a scene's file says, key by key: every number exactly as it is written, every complaint with line and
/// column. A heavy header: only the files that read scenes include it.
class SceneText {
 public:
  SceneText(const std::string& text, const std::string& file);

  const toml::table& root() const { return root_; }
  SyntaxError error(const toml::node& at, const std::string& what) const;
  SyntaxError error(const toml::source_position& at, const std::string& what) const;

  /// throws  SyntaxError  at the first key that is not among these
  void check_keys(const toml::table& table, const std::string& where,
                  const std::vector<std::string>& keys) const;

  /// What stands behind a key; null when it is not there.
  const toml::node* find(const toml::table& table, const std::string& key) const;
  /// throws  SyntaxError  when it is not there
  const toml::node& need(const toml::table& table, const std::string& key, const std::string& where) const;

  std::string text(const toml::node& node, const std::string& key) const;
  bool truth(const toml::node& node, const std::string& key) const;
  std::int64_t whole(const toml::node& node, const std::string& key, std::int64_t least,
                     std::int64_t most) const;
  /// The tables of a [[key]]; none when there is no such key.
  std::vector<const toml::table*> tables(const toml::table& table, const std::string& key) const;
  const toml::array& array(const toml::node& node, const std::string& key) const;
  std::vector<std::string> words(const toml::node& node, const std::string& key) const;

  /// A number with or without a unit.
  ///
  /// throws  SyntaxError  for what is neither, or no finite number
  PhysicalQuantity quantity(const toml::node& node, const std::string& key) const;
  /// In a scene's units; of a certain dimension when a unit is written.
  Rational number(const toml::node& node, const std::string& key, const PhysicalDimension& dimension,
                  const UnitSystem& units) const;

 private:
  std::string written(const toml::node& node) const;

  Source source_;
  toml::table root_;
};

}  // namespace shortfall
