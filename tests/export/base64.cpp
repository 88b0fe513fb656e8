// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/base64.hpp"

#include <doctest/doctest.h>

namespace shortfall {
namespace {

TEST_CASE("base64 gives the test vectors of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe") == "//4=");
}

TEST_CASE("hexadecimal digits are read back as bytes") {
  CHECK(from_hexadecimal("89504e470D0a") == "\x89PNG\r\n");
  CHECK(from_hexadecimal("") == "");
}

}  // namespace
}  // namespace shortfall
