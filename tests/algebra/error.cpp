// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/error.hpp"

#include <doctest/doctest.h>

#include <type_traits>

using namespace shortfall;

TEST_CASE("a syntax error says file, line, column and what is wrong") {
  const SyntaxError e("wrong.integrator", 3, 12, "cannot add vector [L] and vector [L T^-1]");
  CHECK(std::string(e.what()) == "wrong.integrator:3:12: cannot add vector [L] and vector [L T^-1]");
  CHECK(e.file() == "wrong.integrator");
  CHECK(e.line() == 3);
  CHECK(e.column() == 12);
  CHECK(e.context().empty());
}

TEST_CASE("the caret stands below the culprit") {
  CHECK(SyntaxError("f", 1, 1, "w", "2h").context() == "2h\n^");
  CHECK(SyntaxError("f", 1, 2, "w", "2h").context() == "2h\n ^");
}

TEST_CASE("the caret counts characters, not bytes") {
  CHECK(SyntaxError("f", 1, 5, "w", "Störm x").context() == "Störm x\n    ^");
  CHECK(SyntaxError("f", 1, 4, "w", "Störm x").context() == "Störm x\n   ^");
}

TEST_CASE("the caret keeps tabs, so that it lines up whatever their width") {
  CHECK(SyntaxError("f", 1, 4, "w", "\tx\ty").context() == "\tx\ty\n\t \t^");
}

TEST_CASE("the caret may stand one past the end of the line and no further") {
  CHECK(SyntaxError("f", 1, 4, "w", "x =").context() == "x =\n   ^");
  CHECK(SyntaxError("f", 1, 40, "w", "x =").context() == "x =\n   ^");
  CHECK(SyntaxError("f", 1, 4, "w", "x =\r\n").context() == "x =\n   ^");
}

TEST_CASE("every kind of error is an Error") {
  CHECK(std::is_base_of_v<Error, Undefined>);
  CHECK(std::is_base_of_v<Error, Unable>);
  CHECK(std::is_base_of_v<Error, BadInput>);
  CHECK(std::is_base_of_v<Error, SyntaxError>);
}
