// SPDX-License-Identifier: GPL-3.0-or-later
// The planted misprints are readable files, and each stands where tests/data/misprints/misprints.json says.
#include <doctest/doctest.h>

#include <charconv>

#include "analysis/program/file_text.hpp"
#include "analysis/program/json_text.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/tableau_file.hpp"

using namespace shortfall;

namespace {

const std::string kMisprints = std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/misprints/";

/// The entry that "A[3][2]" or "bhat[4]" names.
const TableauEntry& entry(const TableauFile& file, const std::string& where) {
  std::vector<std::size_t> indices;
  for (std::size_t open = where.find('['); open != std::string::npos; open = where.find('[', open + 1)) {
    std::size_t index = 0;
    std::from_chars(where.data() + open + 1, where.data() + where.size(), index);
    indices.push_back(index - 1);
  }
  const std::string key = where.substr(0, where.find('['));
  if (key == "A") return file.a.at(indices.at(0)).at(indices.at(1));
  const auto& row = key == "b"      ? file.b
                    : key == "bhat" ? file.embedded
                    : key == "bbar" ? file.b_position
                                    : file.c;
  return row.at(indices.at(0));
}

}  // namespace

TEST_CASE("every planted misprint is read, and the wrong entry is the one that is named") {
  const Source list("misprints.json", file_text(kMisprints + "misprints.json"));
  const JsonValue misprints = json_value(list);
  int tableaus = 0, integrators = 0, published = 0;
  for (const JsonValue& misprint : misprints.items) {
    const std::string name = misprint.find("file")->text;
    CAPTURE(name);
    published += misprint.find("published") != nullptr;
    if (name.ends_with(".integrator")) {
      CHECK_NOTHROW(parse_file(kMisprints + name));
      ++integrators;
      continue;
    }
    const TableauFile file = parse_tableau_file(kMisprints + name);
    CHECK(file.claims.order.has_value());
    for (const JsonValue& mend : misprint.find("mend")->items)
      if (const JsonValue* where = mend.find("entry"))
        CHECK(entry(file, where->text).text == mend.find("printed")->text);
    ++tableaus;
  }
  CHECK(tableaus >= 30);
  CHECK(integrators >= 9);
  CHECK(published >= 6);
}

TEST_CASE("the schema of tableau files names the keys that are read") {
  const Source source("schema", file_text(std::string(SHORTFALL_SOURCE_DIR) + "/share/tableau.schema.json"));
  const JsonValue schema = json_value(source);
  const JsonValue* properties = schema.find("properties");
  REQUIRE(properties);
  CHECK(properties->members.size() == tableau_keys().size());
  for (const std::string& key : tableau_keys()) {
    CAPTURE(key);
    CHECK(properties->find(key) != nullptr);
  }
}
