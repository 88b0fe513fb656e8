// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/version.hpp"

#include <algorithm>
#include <charconv>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr std::size_t kLongestShownVersion = 40;

bool describes(const Program& program, const std::string& software, const std::vector<int>& wanted) {
  return std::ranges::any_of(versions(program), [&](const SoftwareVersion& v) {
    return v.software == software && agree(v.numbers, wanted);
  });
}

/// "PhysX 5.6.1 (physx, physx-tgs-external-forces)" for each version of a piece of software.
std::string known(const std::string& software, const std::vector<Program>& catalogue) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const Program& p : catalogue)
    for (const SoftwareVersion& v : versions(p)) {
      if (v.software != software) continue;
      const auto same = std::ranges::find(found, v.text, &std::pair<std::string, std::string>::first);
      if (same == found.end())
        found.emplace_back(v.text, p.name);
      else
        same->second += ", " + p.name;
    }
  std::string text;
  for (const auto& [version, names] : found)
    text += (text.empty() ? "" : " and ") + version + " (" + names + ")";
  return text;
}

}  // namespace

std::optional<std::vector<int>> version_numbers(std::string_view text) {
  if (text.starts_with('v') || text.starts_with('V')) text.remove_prefix(1);
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    int number = 0;
    const auto [stopped, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || *at == '-') return std::nullopt;
    numbers.push_back(number);
    if (stopped == end) return numbers;
    if (*stopped != '.') return std::nullopt;
    at = stopped + 1;
  }
}

bool agree(const std::vector<int>& a, const std::vector<int>& b) {
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), b.size())),
                    b.begin());
}

std::vector<SoftwareVersion> versions(const Program& program) {
  std::vector<SoftwareVersion> result;
  for (const std::string& source : program.sources) {
    const std::string text = source.substr(0, source.find(','));
    const std::string_view main = std::string_view(text).substr(0, text.find(" ("));  // without the package
    const std::size_t blank = main.rfind(' ');
    if (blank == std::string_view::npos || blank == 0) continue;
    if (auto numbers = version_numbers(main.substr(blank + 1)))
      result.push_back({std::string(main.substr(0, blank)), std::move(*numbers), text});
  }
  return result;
}

Program of_version(const Program& named, const std::string& version, const std::vector<Program>& catalogue) {
  const auto wanted = version_numbers(version);
  if (!wanted)
    throw BadInput("'" + version.substr(0, kLongestShownVersion) + "' after the @ is no version; write " +
                   named.name + "@ and numbers with points between them, such as 1.2");
  const std::vector<SoftwareVersion> own = versions(named);
  if (own.empty())
    throw BadInput(named.name + " has no versions: it was read in no engine's source; write " + named.name +
                   " alone");
  std::vector<const Program*> others;
  for (const SoftwareVersion& v : own) {
    if (agree(v.numbers, *wanted)) return named;
    for (const Program& p : catalogue)
      if (describes(p, v.software, *wanted)) others.push_back(&p);
  }
  if (others.size() == 1) return *others.front();
  throw BadInput("version " + version.substr(0, kLongestShownVersion) + " of " + own.front().software +
                 " is not known: the catalogue has " + known(own.front().software, catalogue) +
                 "; other versions may step differently");
}

}  // namespace shortfall
