// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/floating/float_format.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/file_text.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/trade/scene_force_read.hpp"

namespace shortfall {

namespace {

using ObservableKind = SceneObservable::Kind;

struct ObservableEntry {
  const char* name;
  ObservableKind kind;
  std::vector<std::string> keys;
  int length, time;  ///< of its dimension; length counts where coordinates are lengths
};

const std::vector<ObservableEntry>& observables() {
  static const std::vector<ObservableEntry> table{
      {"position", ObservableKind::position, {"at"}, 1, 0},
      {"velocity", ObservableKind::velocity, {"at"}, 1, -1},
      {"peak", ObservableKind::peak, {"axis", "reading"}, 1, 0},
      {"apex-time", ObservableKind::apex_time, {"axis"}, 0, 1},
      {"event-time", ObservableKind::event_time, {"event", "count"}, 0, 1},
      {"event-place", ObservableKind::event_place, {"event", "count"}, 1, 0},
      {"period", ObservableKind::period, {"event", "count"}, 0, 1},
      {"phase", ObservableKind::phase, {"event", "count"}, 0, 0},
      {"energy-drift", ObservableKind::energy_drift, {}, 0, 0},
      {"path", ObservableKind::path, {"count"}, 1, 0},
  };
  return table;
}

class SceneReader {
 public:
  SceneReader(const std::string& text, const std::string& file)
      : text_(text, file), context_{text_, scene_, false, {}} {
    scene_.file = file;
    scene_.text = text;
    const std::size_t slash = file.find_last_of('/');
    scene_.name = slash == std::string::npos ? file : file.substr(slash + 1);
    if (scene_.name.ends_with(".toml")) scene_.name.resize(scene_.name.size() - 5);
  }

  Scene read() {
    const toml::table& root = text_.root();
    text_.check_keys(root, "a scene",
                     {"title", "dimension", "coordinates", "units", "until", "dt", "naive", "parameters",
                      "body", "force", "event", "observable", "budget"});
    if (const auto* node = text_.find(root, "title")) scene_.title = text_.text(*node, "title");
    read_units(root);
    if (const auto* node = text_.find(root, "dimension"))
      scene_.dimension = static_cast<int>(text_.whole(*node, "dimension", 1, 3));
    read_coordinates(root);
    scene_.until = positive(text_.need(root, "until", "a scene"), "until", {0, 1, 0});
    scene_.step = positive(text_.need(root, "dt", "a scene"), "dt", {0, 1, 0});
    if (scene_.step > scene_.until) throw text_.error(*root.get("dt"), "dt is longer than the scene");
    if (const auto* node = text_.find(root, "naive")) scene_.naive = integrator(*node, "naive");
    read_parameters(root);
    for (const toml::table* table : text_.tables(root, "body")) read_body(*table);
    if (scene_.bodies.empty()) throw text_.error(root, "a scene needs a [[body]]");
    for (const toml::table* table : text_.tables(root, "force"))
      scene_.forces.push_back(read_force(context_, *table));
    if (scene_.forces.empty()) throw text_.error(root, "a scene needs a [[force]]");
    unique_force_names();
    for (const toml::table* table : text_.tables(root, "event")) read_event(*table);
    for (const toml::table* table : text_.tables(root, "observable")) read_observable(*table);
    if (scene_.observables.empty())
      throw text_.error(root, "a scene needs an [[observable]] with its tolerance");
    if (const auto* node = text_.find(root, "budget")) read_budget(*node);
    return std::move(scene_);
  }

 private:
  Rational positive(const toml::node& node, const std::string& key,
                    const PhysicalDimension& dimension) const {
    Rational value = text_.number(node, key, dimension, scene_.units);
    if (value.sign() <= 0) throw text_.error(node, key + " must be greater than 0");
    return value;
  }

  std::string integrator(const toml::node& node, const std::string& key) const {
    try {
      return word_for(find_integrator(text_.text(node, key)));
    } catch (const BadInput& e) {
      throw text_.error(node, e.what());
    }
  }

  void read_units(const toml::table& root) {
    const toml::node* node = text_.find(root, "units");
    if (!node) return;
    const toml::table* table = node->as_table();
    if (!table) throw text_.error(*node, R"(units is a table, such as { length = "au", time = "day" })");
    text_.check_keys(*table, "units", {"length", "time", "mass"});
    const auto word = [&](const char* key, const char* usual) {
      const toml::node* entry = text_.find(*table, key);
      return entry ? text_.text(*entry, key) : std::string(usual);
    };
    try {
      scene_.units = UnitSystem::of(word("length", "m"), word("time", "s"), word("mass", "kg"));
    } catch (const BadInput& e) {
      throw text_.error(*node, e.what());
    }
  }

  void read_coordinates(const toml::table& root) {
    const toml::node* node = text_.find(root, "coordinates");
    if (!node) return;
    const std::string word = text_.text(*node, "coordinates");
    if (word != "angles" && word != "lengths")
      throw text_.error(*node, "coordinates are \"lengths\" or \"angles\", not '" + word + "'");
    context_.angles = word == "angles";
  }

  void read_parameters(const toml::table& root) {
    const toml::node* node = text_.find(root, "parameters");
    if (!node) return;
    const toml::table* table = node->as_table();
    if (!table) throw text_.error(*node, "parameters is a table: write [parameters]");
    static const std::set<std::string> kTaken{"x", "y", "z", "vx", "vy", "vz", "t", "a"};
    for (const auto& [key, entry] : *table) {
      const std::string name(key.str());
      if (kTaken.contains(name))
        throw text_.error(key.source().begin, "'" + name + "' has a meaning already");
      const PhysicalQuantity q = text_.quantity(entry, name);
      context_.parameters.emplace(name, q.dimension ? scene_.units.from_si(q.value, *q.dimension) : q.value);
    }
  }

  void read_body(const toml::table& table) {
    text_.check_keys(table, "a body", {"name", "position", "velocity", "mass"});
    SceneBody body;
    const std::size_t number = scene_.bodies.size() + 1;
    const toml::node* name = text_.find(table, "name");
    body.name = name ? text_.text(*name, "name") : "body " + std::to_string(number);
    for (const SceneBody& other : scene_.bodies)
      if (other.name == body.name)
        throw text_.error(table, "there are two bodies called '" + body.name + "'");
    body.position =
        context_.vector(text_.need(table, "position", "a body"), "position", context_.coordinate());
    if (const auto* node = text_.find(table, "velocity"))
      body.velocity = context_.vector(*node, "velocity", context_.coordinate(-1));
    else
      body.velocity.assign(static_cast<std::size_t>(scene_.dimension), Rational(0));
    if (const auto* node = text_.find(table, "mass")) body.mass = positive(*node, "mass", {0, 0, 1});
    if (scene_.bodies.size() == 64) throw text_.error(table, "a scene has at most 64 bodies");
    scene_.bodies.push_back(std::move(body));
  }

  /// Two forces of one kind are told apart by a number.
  void unique_force_names() {
    std::set<std::string> taken;
    for (SceneForce& f : scene_.forces) {
      std::string name = f.name;
      for (int n = 2; !taken.insert(name).second; ++n) name = f.name + " " + std::to_string(n);
      f.name = name;
    }
  }

  int axis(const toml::table& table, int usual) const {
    static const std::string kAxes = "xyz";
    const toml::node* node = text_.find(table, "axis");
    if (!node) return usual;
    const std::string word = text_.text(*node, "axis");
    const std::size_t found = word.size() == 1 ? kAxes.find(word) : std::string::npos;
    if (found == std::string::npos || static_cast<int>(found) >= scene_.dimension)
      throw text_.error(*node, "axis is " +
                                   std::string(scene_.dimension == 1   ? "x"
                                               : scene_.dimension == 2 ? "x or y"
                                                                       : "x, y or z") +
                                   " here, not '" + word + "'");
    return static_cast<int>(found);
  }

  int body(const toml::table& table) const {
    const toml::node* node = text_.find(table, "body");
    return node ? context_.body_named(*node, text_.text(*node, "body")) : 0;
  }

  void read_event(const toml::table& table) {
    text_.check_keys(table, "an event", {"name", "body", "axis", "of", "level", "direction", "ends"});
    SceneEvent event;
    event.name = text_.text(text_.need(table, "name", "an event"), "name");
    for (const SceneEvent& other : scene_.events)
      if (other.name == event.name)
        throw text_.error(table, "there are two events called '" + event.name + "'");
    event.body = body(table);
    event.axis = axis(table, scene_.dimension - 1);
    if (const auto* node = text_.find(table, "of")) {
      const std::string word = text_.text(*node, "of");
      if (word != "position" && word != "velocity")
        throw text_.error(*node, "of is \"position\" or \"velocity\", not '" + word + "'");
      event.of_velocity = word == "velocity";
    }
    if (const auto* node = text_.find(table, "level"))
      event.level =
          text_.number(*node, "level", context_.coordinate(event.of_velocity ? -1 : 0), scene_.units);
    if (const auto* node = text_.find(table, "direction")) {
      const std::string word = text_.text(*node, "direction");
      if (word != "up" && word != "down" && word != "both")
        throw text_.error(*node, "direction is \"up\", \"down\" or \"both\", not '" + word + "'");
      event.direction = word == "up" ? 1 : word == "down" ? -1 : 0;
    }
    if (const auto* node = text_.find(table, "ends")) event.ends = text_.truth(*node, "ends");
    scene_.events.push_back(std::move(event));
  }

  void read_observable(const toml::table& table) {
    const toml::node& kind_node = text_.need(table, "kind", "an observable");
    const std::string kind = text_.text(kind_node, "kind");
    const auto entry =
        std::ranges::find_if(observables(), [&](const ObservableEntry& e) { return kind == e.name; });
    if (entry == observables().end()) {
      std::vector<std::string> names;
      for (const ObservableEntry& e : observables()) names.emplace_back(e.name);
      throw text_.error(kind_node, "unknown observable '" + kind + "'" + did_you_mean(kind, names) +
                                       " (there are " + comma_list(names) + ")");
    }
    std::vector<std::string> keys{"kind", "name", "tolerance"};
    if (entry->kind != ObservableKind::energy_drift) keys.emplace_back("body");  // it is that of all together
    keys.insert(keys.end(), entry->keys.begin(), entry->keys.end());
    text_.check_keys(table, "an observable of kind " + kind, keys);
    SceneObservable o;
    o.kind = entry->kind;
    o.body = body(table);
    o.of_body = text_.find(table, "body") != nullptr;
    o.axis = axis(table, scene_.dimension - 1);
    o.dimension = {context_.angles ? 0 : entry->length, entry->time, 0};
    o.unit = scene_.units.unit(o.dimension);
    if ((context_.angles && entry->length != 0) || o.kind == ObservableKind::phase)
      o.unit = "rad" + (entry->time == 0 ? "" : "/" + scene_.units.time);
    o.tolerance =
        positive(text_.need(table, "tolerance", "the observable '" + kind + "'"), "tolerance", o.dimension);
    read_when(table, o, kind);
    const toml::node* name = text_.find(table, "name");
    o.name = name ? text_.text(*name, "name") : usual_name(kind, o);
    for (const SceneObservable& other : scene_.observables) {
      if (other.name != o.name) continue;
      throw text_.error(table, other.tolerance == o.tolerance
                                   ? "there are two observables called '" + o.name + "'"
                                   : "contradictory tolerances: '" + o.name + "' is asked for twice");
    }
    scene_.observables.push_back(std::move(o));
  }

  void read_when(const toml::table& table, SceneObservable& o, const std::string& kind) {
    if (const auto* node = text_.find(table, "reading")) {
      const std::string word = text_.text(*node, "reading");
      if (word != "frames" && word != "between")
        throw text_.error(*node, "reading is \"frames\" or \"between\", not '" + word + "'");
      o.at_frames = word == "frames";
    }
    if (o.kind == ObservableKind::position || o.kind == ObservableKind::velocity) {
      const toml::node* node = text_.find(table, "at");
      o.at = node ? positive(*node, "at", {0, 1, 0}) : scene_.until;
      if (node && o.at > scene_.until) throw text_.error(*node, "at is after the end of the scene (until)");
    }
    const bool by_event = o.kind == ObservableKind::event_time || o.kind == ObservableKind::event_place ||
                          o.kind == ObservableKind::period || o.kind == ObservableKind::phase;
    if (by_event) {
      const toml::node& node = text_.need(table, "event", "the observable '" + kind + "'");
      const std::string word = text_.text(node, "event");
      std::vector<std::string> names;
      for (std::size_t i = 0; i < scene_.events.size(); ++i) {
        names.push_back(scene_.events[i].name);
        if (names.back() == word) o.event = static_cast<int>(i);
      }
      if (!o.event) throw text_.error(node, "there is no event '" + word + "'" + did_you_mean(word, names));
      const int own = scene_.events[static_cast<std::size_t>(*o.event)].body;
      if (o.of_body && o.body != own)
        throw text_.error(node, "the event '" + word + "' is of the body '" +
                                    scene_.bodies[static_cast<std::size_t>(own)].name + "'");
      o.body = own;
    }
    const bool counts_periods = o.kind == ObservableKind::period || o.kind == ObservableKind::phase;
    o.count = counts_periods ? 2 : o.kind == ObservableKind::path ? 64 : 1;
    if (const auto* node = text_.find(table, "count"))
      o.count = static_cast<int>(text_.whole(*node, "count", counts_periods ? 2 : 1, 1'000'000));
  }

  std::string usual_name(const std::string& kind, const SceneObservable& o) const {
    std::string name = kind;
    if (o.event)
      name = scene_.events[static_cast<std::size_t>(*o.event)].name + " " +
             (kind.starts_with("event-") ? kind.substr(6) : kind);
    if (o.kind == ObservableKind::position || o.kind == ObservableKind::velocity) {
      name += " at " + o.at.significant(6);
      if (!scene_.units.time.empty()) name += " " + scene_.units.time;
    }
    if (scene_.bodies.size() > 1 && o.kind != ObservableKind::energy_drift &&
        (o.kind != ObservableKind::path || o.of_body))
      name = scene_.bodies[static_cast<std::size_t>(o.body)].name + " " + name;
    return name;
  }

  void read_budget(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table) throw text_.error(node, "budget is a table: write [budget]");
    text_.check_keys(*table, "budget",
                     {"integrator", "parameters", "dt", "substeps", "microseconds", "formats"});
    SceneBudget& budget = scene_.budget;
    if (const auto* entry = text_.find(*table, "integrator"))
      budget.integrator = integrator(*entry, "integrator");
    if (const auto* entry = text_.find(*table, "parameters")) read_engine_parameters(*entry);
    if (const auto* entry = text_.find(*table, "dt")) {
      if (!entry->is_array())
        budget.steps.push_back(positive(*entry, "dt", {0, 1, 0}));
      else
        for (const toml::node& one : text_.array(*entry, "dt"))
          budget.steps.push_back(positive(one, "dt", {0, 1, 0}));
    }
    if (const auto* entry = text_.find(*table, "substeps"))
      budget.most_substeps = static_cast<int>(text_.whole(*entry, "substeps", 1, 10'000));
    if (const auto* entry = text_.find(*table, "microseconds")) {
      const PhysicalQuantity q = text_.quantity(*entry, "microseconds");
      if (q.dimension || q.value.sign() <= 0)
        throw text_.error(*entry, "microseconds is a bare number greater than 0: what one frame may take");
      budget.microseconds = q.value;
    }
    if (const auto* entry = text_.find(*table, "formats")) {
      budget.formats = text_.words(*entry, "formats");
      for (const std::string& f : budget.formats) try {
          float_format(f);
        } catch (const BadInput& e) {
          throw text_.error(*entry, e.what());
        }
    }
  }

  void read_engine_parameters(const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table || scene_.budget.integrator.empty())
      throw text_.error(node, R"(parameters are those of the budget's integrator: { c = "0.1" })");
    for (const auto& [key, entry] : *table) {
      const PhysicalQuantity q = text_.quantity(entry, std::string(key.str()));
      scene_.budget.parameters[std::string(key.str())] =
          q.dimension ? scene_.units.from_si(q.value, *q.dimension) : q.value;
    }
    try {
      lower(find_integrator(scene_.budget.integrator), scene_.budget.parameters);
    } catch (const BadInput& e) {
      throw text_.error(node, e.what());
    }
  }

  Scene scene_;
  SceneText text_;
  SceneContext context_;
};

}  // namespace

Scene scene_of(const std::string& text, const std::string& file) { return SceneReader(text, file).read(); }

Scene read_scene(const std::string& path) { return scene_of(file_text(path), path); }

}  // namespace shortfall
