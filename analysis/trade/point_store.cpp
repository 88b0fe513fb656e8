// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/point_store.hpp"

#include <sqlite3.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/trade/outcome_text.hpp"

namespace shortfall {

namespace {

/// 64 bits of a text (FNV-1a, Fowler, Noll & Vo 1991).
std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ULL;
  }
  char digits[32];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

constexpr std::chrono::milliseconds kPatience{10'000};  ///< with another process at the store

constexpr const char* kTable =
    "CREATE TABLE IF NOT EXISTS points (key TEXT PRIMARY KEY, integrator TEXT, format TEXT, launched "
    "INTEGER, frame TEXT,"
    " substeps INTEGER, steps INTEGER, evaluations INTEGER, failed INTEGER, why TEXT, errors TEXT, "
    "nanoseconds TEXT)";

}  // namespace

struct PointStore::Database {
  sqlite3* handle = nullptr;
  std::string path;
  mutable std::mutex one_at_a_time;

  ~Database() { sqlite3_close(handle); }

  [[noreturn]] void fail(const std::string& what) const {
    throw UnreadableFile(path + ": " + what + ": " + sqlite3_errmsg(handle));
  }
  sqlite3_stmt* prepared(const char* sql) const {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(handle, sql, -1, &statement, nullptr) != SQLITE_OK)
      fail("the store cannot be used");
    return statement;
  }
  /// Where several processes make the same store, sqlite answers some of these statements with
  /// "locked" at once, without the wait of sqlite3_busy_timeout: it could be for ever.
  void run_when_free(const char* sql) const {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    int answer = SQLITE_BUSY;
    while ((answer = sqlite3_exec(handle, sql, nullptr, nullptr, nullptr)) == SQLITE_BUSY &&
           std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (answer != SQLITE_OK) fail("the store cannot be used");
  }
};

namespace {

class Prepared {
 public:
  explicit Prepared(sqlite3_stmt* statement) : statement_(statement) {}
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;
  ~Prepared() { sqlite3_finalize(statement_); }
  void text(int index, const std::string& value) {
    sqlite3_bind_text(statement_, index, value.c_str(), -1, SQLITE_TRANSIENT);
  }
  void whole(int index, std::int64_t value) { sqlite3_bind_int64(statement_, index, value); }
  int step() { return sqlite3_step(statement_); }
  std::string text_at(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_, column);
    return text ? reinterpret_cast<const char*>(text) : "";
  }
  std::int64_t whole_at(int column) const { return sqlite3_column_int64(statement_, column); }

 private:
  sqlite3_stmt* statement_;
};

}  // namespace

PointStore::PointStore(const std::string& path) : database_(std::make_unique<Database>()) {
  database_->path = path;
  if (sqlite3_open_v2(path.c_str(), &database_->handle,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX,
                      nullptr) != SQLITE_OK)
    database_->fail("the store cannot be opened");
  sqlite3_busy_timeout(database_->handle, static_cast<int>(kPatience.count()));
  database_->run_when_free("PRAGMA journal_mode = WAL");
  database_->run_when_free(kTable);
}

PointStore::~PointStore() = default;
PointStore::PointStore(PointStore&&) noexcept = default;

std::optional<SceneOutcome> PointStore::find(const std::string& key) const {
  const std::lock_guard lock(database_->one_at_a_time);
  Prepared s(database_->prepared(
      "SELECT integrator, format, launched, frame, substeps, steps, evaluations, failed, why, errors, "
      "nanoseconds"
      " FROM points WHERE key = ?"));
  s.text(1, key);
  const int found = s.step();
  if (found == SQLITE_DONE) return std::nullopt;
  if (found != SQLITE_ROW) database_->fail("the store cannot be read");
  SceneOutcome o;
  o.choice.integrator = s.text_at(0);
  o.choice.format = s.text_at(1);
  o.choice.launched = s.whole_at(2) != 0;
  o.choice.frame = Rational::parse(s.text_at(3));
  o.choice.substeps = static_cast<int>(s.whole_at(4));
  o.steps = s.whole_at(5);
  o.evaluations = s.whole_at(6);
  o.failed = s.whole_at(7) != 0;
  o.why = s.text_at(8);
  o.errors = all_bits_of(s.text_at(9));
  o.nanoseconds = bits_of(s.text_at(10));
  return o;
}

void PointStore::put(const std::string& key, const SceneOutcome& o) {
  const std::lock_guard lock(database_->one_at_a_time);
  Prepared s(
      database_->prepared("INSERT OR REPLACE INTO points VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
  s.text(1, key);
  s.text(2, o.choice.integrator);
  s.text(3, o.choice.format);
  s.whole(4, o.choice.launched);
  s.text(5, o.choice.frame.str());
  s.whole(6, o.choice.substeps);
  s.whole(7, o.steps);
  s.whole(8, o.evaluations);
  s.whole(9, o.failed);
  s.text(10, o.why);
  s.text(11, bits_text(o.errors));
  s.text(12, bits_text(o.nanoseconds));
  if (s.step() != SQLITE_DONE) database_->fail("a point cannot be written");
}

std::int64_t PointStore::size() const {
  const std::lock_guard lock(database_->one_at_a_time);
  Prepared s(database_->prepared("SELECT count(*) FROM points"));
  if (s.step() != SQLITE_ROW) database_->fail("the store cannot be read");
  return s.whole_at(0);
}

std::string point_key(const Scene& scene, const StepChoice& choice) {
  std::string parameters;
  for (const auto& [name, value] : choice.parameters) parameters += name + "=" + value.str() + ";";
  // The program itself, not its name: a file of the user's may change between two runs.
  const std::string what = scene.text + "\n" + scene.until.str() + "\n" +
                           print(find_integrator(choice.integrator)) + "\n" + parameters + choice.format +
                           "\n" + (choice.launched ? "launched" : "") + "\n" + choice.frame.str() + "/" +
                           std::to_string(choice.substeps);
  return scene.name + " " + choice.label() + " " + choice.frame.str() + " " + fingerprint(what);
}

}  // namespace shortfall
