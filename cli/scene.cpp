// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene.hpp"

#include "analysis/algebra/error.hpp"

namespace shortfall::cli {

Scene scene_from(const std::string& path, const std::string& until) {
  Scene scene = read_scene(path);
  if (until.empty()) return scene;
  const PhysicalQuantity q = physical_quantity(until);
  if (q.dimension && *q.dimension != kPhysicalTime)
    throw BadInput("--until '" + until.substr(0, 40) + "' is no time");
  const Rational end = q.dimension ? scene.units.from_si(q.value, {0, 1, 0}) : q.value;
  if (end < scene.step) throw BadInput("--until '" + until.substr(0, 40) + "' is before the first frame");
  for (SceneObservable& o : scene.observables)
    if (o.at > end || o.at == scene.until) o.at = end;
  scene.until = end;
  return scene;
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < list.size();) {
    std::size_t end = list.find(',', begin);
    if (end == std::string::npos) end = list.size();
    std::string word = list.substr(begin, end - begin);
    while (word.starts_with(' ')) word.erase(0, 1);
    while (word.ends_with(' ')) word.pop_back();
    if (!word.empty()) words.push_back(std::move(word));
    begin = end + 1;
  }
  return words;
}

}  // namespace shortfall::cli
