// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

using Kind = FloatFormat::Kind;
using Variant = FloatFormat::Variant;

struct KindName {
  Kind kind;
  const char* name;
  const char* words;
};
constexpr std::array<KindName, 8> kKinds{{{Kind::binary16, "f16", "binary16 (half)"},
                                          {Kind::bfloat16, "bf16", "bfloat16"},
                                          {Kind::binary32, "f32", "binary32 (float)"},
                                          {Kind::binary64, "f64", "binary64 (double)"},
                                          {Kind::x87, "x87", "x87 extended (80 bits)"},
                                          {Kind::binary128, "f128", "binary128"},
                                          {Kind::double_double, "dd", "double-double"},
                                          {Kind::mpfr, "mpfr", "MPFR"}}};

struct VariantName {
  Variant variant;
  const char* suffix;
  const char* words;
};
constexpr std::array<VariantName, 5> kVariants{
    {{Variant::plain, "", ""},
     {Variant::fused, "+fma", "products and sums fused"},
     {Variant::compensated, "+kahan", "compensated sums"},
     {Variant::offset, "+origin", "offsets from a binary64 origin"},
     {Variant::toward_zero, "+tozero", "rounded toward zero"}}};

const std::map<std::string, std::string, std::less<>> kOtherWords{
    {"float", "f32"},     {"double", "f64"},   {"half", "f16"},         {"quad", "f128"},
    {"binary16", "f16"},  {"binary32", "f32"}, {"binary64", "f64"},     {"binary128", "f128"},
    {"bfloat16", "bf16"}, {"f80", "x87"},      {"double-double", "dd"}, {"long-double", "x87"}};

const KindName& of(Kind kind) {
  return *std::ranges::find_if(kKinds, [&](const KindName& k) { return k.kind == kind; });
}
const VariantName& of(Variant variant) {
  return *std::ranges::find_if(kVariants, [&](const VariantName& v) { return v.variant == variant; });
}

constexpr int kMostDigits = 100'000;

int digits_of(std::string_view text, const std::string& whole) {
  int digits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
  if (error != std::errc() || end != text.data() + text.size() || digits < 2 || digits > kMostDigits)
    throw BadInput("the format '" + whole + "': mpfr takes a number of decimal digits from 2 to " +
                   std::to_string(kMostDigits) + ", such as mpfr:50");
  return digits;
}

void check_variant(const FloatFormat& f, const std::string& whole) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput("the format '" + whole + "' does not exist: " + why);
  };
  if (f.variant == Variant::offset && f.kind != Kind::binary32)
    refuse("an origin in binary64 is defined for offsets in f32");
  if (f.variant == Variant::fused && f.kind == Kind::double_double)
    refuse("double-double has no fused product");
  if (f.variant == Variant::toward_zero && (f.kind == Kind::double_double || f.kind == Kind::binary128))
    refuse("rounding toward zero is there for f16, bf16, f32, f64, x87 and mpfr");
}

}  // namespace

std::string FloatFormat::name() const {
  return std::string(of(kind).name) + (kind == Kind::mpfr ? ":" + std::to_string(digits) : "") +
         of(variant).suffix;
}

std::string FloatFormat::words() const {
  std::string text = of(kind).words;
  if (kind == Kind::mpfr) text += " with " + std::to_string(digits) + " digits";
  if (variant != Variant::plain) text += std::string(", ") + of(variant).words;
  return text;
}

BinaryFormat FloatFormat::storage() const {
  switch (kind) {
    case Kind::binary16:
      return BinaryFormat::binary16();
    case Kind::bfloat16:
      return BinaryFormat::bfloat16();
    case Kind::binary32:
      return BinaryFormat::binary32();
    case Kind::binary64:
      return BinaryFormat::binary64();
    case Kind::x87:
      return BinaryFormat::x87();
    case Kind::binary128:
      return BinaryFormat::binary128();
    case Kind::double_double:
      return {106, -1074, 1023};
    case Kind::mpfr:
      break;
  }
  // As MPFR's C++ wrapper turns digits into bits.
  return BinaryFormat::of_precision(static_cast<int>(static_cast<long>(digits) * 1000 / 301 + 2));
}

FloatFormat float_format(std::string_view name) {
  const std::string whole(name.substr(0, 60));
  FloatFormat format;
  std::string_view base = name.substr(0, name.find('+'));
  const std::string_view suffix = name.substr(base.size());
  const auto variant =
      std::ranges::find_if(kVariants, [&](const VariantName& v) { return suffix == v.suffix; });
  if (variant == kVariants.end())
    throw BadInput("the format '" + whole + "' has an unknown variant" +
                   did_you_mean(suffix, {"+fma", "+kahan", "+origin", "+tozero"}) +
                   "; there are +fma, +kahan, +origin and +tozero");
  format.variant = variant->variant;
  if (const auto other = kOtherWords.find(base); other != kOtherWords.end()) base = other->second;
  if (base.starts_with("mpfr")) {
    format.kind = Kind::mpfr;
    format.digits = digits_of(base.size() > 5 && base[4] == ':' ? base.substr(5) : "", whole);
  } else {
    const auto kind = std::ranges::find_if(kKinds, [&](const KindName& k) { return base == k.name; });
    if (kind == kKinds.end()) {
      std::vector<std::string> words;
      for (const KindName& k : kKinds) words.emplace_back(k.name);
      for (const auto& [word, meaning] : kOtherWords) words.push_back(word);
      throw BadInput("there is no format '" + whole + "'" + did_you_mean(base, words) +
                     "; there are f16, bf16, f32, f64, x87, f128, dd, mpfr:DIGITS");
    }
    format.kind = kind->kind;
  }
  check_variant(format, whole);
  return format;
}

std::vector<FloatFormat> float_formats(std::string_view names) {
  std::vector<FloatFormat> formats;
  while (true) {
    const std::size_t comma = names.find(',');
    std::string_view one = names.substr(0, comma);
    while (one.starts_with(' ')) one.remove_prefix(1);
    while (one.ends_with(' ')) one.remove_suffix(1);
    formats.push_back(float_format(one));
    if (comma == std::string_view::npos) return formats;
    names.remove_prefix(comma + 1);
  }
}

}  // namespace shortfall
