// SPDX-License-Identifier: GPL-3.0-or-later
// What runs a target where there is no libFuzzer: driver MUTATIONS FILE_OR_FOLDER... reads every file, then
// mutations of them from a fixed seed. The input at hand is written to `crash` in the current folder before
// the target sees it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/target.hpp"

namespace {

constexpr std::size_t kLongest = 100'000;

std::vector<std::string> corpus(int count, char** paths) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int i = 0; i < count; ++i) {
    if (!fs::exists(paths[i])) {
      std::fprintf(stderr, "no corpus at %s\n", paths[i]);
      std::exit(2);
    }
    if (fs::is_directory(paths[i])) {
      for (const auto& entry : fs::recursive_directory_iterator(paths[i]))
        if (entry.is_regular_file()) files.push_back(entry.path());
    } else {
      files.emplace_back(paths[i]);
    }
  }
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    if (texts.back().size() > kLongest) texts.back().resize(kLongest);
  }
  return texts;
}

class Mutation {
 public:
  explicit Mutation(const std::vector<std::string>& corpus) : corpus_(corpus) {}

  std::string operator()() {
    std::string text = corpus_[below(corpus_.size())];
    for (std::size_t i = 1 + below(4); i > 0; --i) change(text);
    if (text.size() > kLongest) text.resize(kLongest);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  void change(std::string& text) {
    using namespace std::string_view_literals;
    static constexpr std::string_view kPieces[] = {
        "(",   ")",  "[",  "]",  "{",        "}",     "^",       "*",   "/",   "-",
        ",",   ":",  "\n", "\t", "0",        "1e999", "-1e-400", "nan", "inf", "999999999999999999999",
        "1/0", "\"", "'",  "=",  "\xff\xfe", "\0"sv,  "#",       "h",   "v",   "x"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, 1 + below(8));
    switch (below(6)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, kPieces[below(std::size(kPieces))]);
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      case 3:
        text.insert(below(text.size() + 1), text.substr(at, 1 + below(60)));
        break;
      case 4: {
        const std::string& other = corpus_[below(corpus_.size())];
        text.insert(at, other.substr(below(other.size() + 1), 1 + below(80)));
        break;
      }
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(7)));
    }
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_{20'261'128};
};

void give(const std::string& text) {
  std::ofstream("crash", std::ios::binary) << text;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s MUTATIONS FILE_OR_FOLDER...\n", argv[0]);
    return 2;
  }
  const std::vector<std::string> texts = corpus(argc - 2, argv + 2);
  if (texts.empty()) {
    std::fprintf(stderr, "no corpus\n");
    return 2;
  }
  for (const std::string& text : texts) give(text);
  Mutation mutation(texts);
  const long mutations = std::atol(argv[1]);
  for (long i = 0; i < mutations; ++i) give(mutation());
  std::filesystem::remove("crash");
  std::printf("%zu files and %ld mutations\n", texts.size(), mutations);
  return 0;
}
