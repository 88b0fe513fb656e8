// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_force_read.hpp"

#include <algorithm>
#include <functional>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/program/lexer.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

using ForceKind = SceneForce::Kind;

/// One force being read.
struct Reading {
  const SceneContext& c;
  const toml::table& table;
  SceneForce& force;
  std::string where;  ///< "the force 'drag'"

  const toml::node& need(const std::string& key) const { return c.text.need(table, key, where); }
  const toml::node* find(const std::string& key) const { return c.text.find(table, key); }
  void push(Rational value) const { force.numbers.push_back(std::move(value)); }
  void push(const std::vector<Rational>& values) const {
    force.numbers.insert(force.numbers.end(), values.begin(), values.end());
  }
  void push_vector(const std::string& key, const PhysicalDimension& d) const {
    push(c.vector(need(key), key, d));
  }
  void push_vector_or_zero(const std::string& key, const PhysicalDimension& d) const {
    if (const toml::node* node = find(key))
      push(c.vector(*node, key, d));
    else
      push(std::vector<Rational>(static_cast<std::size_t>(c.scene.dimension)));
  }
  Rational number(const std::string& key, const PhysicalDimension& d) const {
    return c.text.number(need(key), key, d, c.scene.units);
  }
  Rational positive(const std::string& key, const PhysicalDimension& d) const {
    Rational value = number(key, d);
    if (value.sign() <= 0) throw c.text.error(need(key), key + " must be greater than 0");
    return value;
  }
  /// Per unit of mass; written with kg (or N) in its unit it is divided by the mass of the body.
  Rational per_mass(const std::string& key, const PhysicalDimension& d) const {
    const toml::node& node = need(key);
    const PhysicalQuantity q = c.text.quantity(node, key);
    const PhysicalDimension with_mass = d * kPhysicalMass;
    if (q.dimension != with_mass) return c.text.number(node, key, d, c.scene.units);
    if (force.bodies.size() != 1)
      throw c.text.error(node, key + " with a mass in its unit is one body's: give the force one body");
    const Rational value = c.scene.units.from_si(q.value, with_mass);
    return value / c.scene.bodies[static_cast<std::size_t>(force.bodies[0])].mass;
  }
  std::vector<Rational> rotation(const std::string& key, const PhysicalDimension& d) const {
    const toml::node& node = need(key);
    if (c.scene.dimension == 2 && !node.is_array()) return {0, 0, c.text.number(node, key, d, c.scene.units)};
    std::vector<Rational> w;
    for (const toml::node& entry : c.text.array(node, key))
      w.push_back(c.text.number(entry, key, d, c.scene.units));
    if (w.size() != 3) throw c.text.error(node, key + " has three components, or one number in a plane");
    if (c.scene.dimension == 2 && !(w[0].is_zero() && w[1].is_zero()))
      throw c.text.error(node, key + " stands on the plane in a scene of two dimensions: [0, 0, w]");
    return w;
  }
  Expr expression(const toml::node& node, const std::string& key) const;
};

Expr Reading::expression(const toml::node& node, const std::string& key) const {
  const std::string text = c.text.text(node, key);
  const auto moved = [&](const SyntaxError& e) {
    std::string what = e.what();
    what = what.substr(std::min(what.size(), what.find(": ") + 2));
    toml::source_position at = node.source().begin;
    at.column += static_cast<toml::source_index>(std::max(0, e.column()));
    return c.text.error(at, key + ": " + what);
  };
  try {
    const Source source(key, text);
    int line = 1;
    TokenReader reader(source, tokens(source, line, 0), Functions::of_scenes, false);
    Expr result = reader.expression();
    reader.expect_end("an expression");
    std::vector<std::string> known{"t"};
    static const std::string kAxes = "xyz";
    for (int i = 0; i < c.scene.dimension; ++i) {
      known.push_back(kAxes.substr(static_cast<std::size_t>(i), 1));
      if (force.kind == ForceKind::expression) known.push_back("v" + known.back());
    }
    for (const auto& [name, value] : c.parameters) {
      result = replace(result, name, shortfall::number(value));
    }
    const std::function<void(const Expr&)> check = [&](const Expr& e) {
      if (e->op == Expression::Op::force)
        throw source.error(e->place, "a force of a scene is written out, it does not call a(x, v, t)");
      if (e->op == Expression::Op::call && !is_one_of(Functions::of_scenes, *function_named(e->name)))
        throw source.error(e->place, "the force of a scene cannot call " + e->name + "; it can call " +
                                         function_list(Functions::of_scenes));
      if (e->op == Expression::Op::name && std::ranges::find(known, e->name) == known.end()) {
        throw source.error(e->place, "unknown name '" + e->name + "'" + did_you_mean(e->name, known) +
                                         " (there are " + comma_list(known) + ", and those of [parameters])");
      }
      for (const Expr& part : e->operands) check(part);
    };
    check(result);
    return result;
  } catch (const SyntaxError& e) {
    throw moved(e);
  }
}

struct KindEntry {
  const char* name;
  ForceKind kind;
  std::vector<std::string> keys;
  void (*read)(const Reading&);
};

void read_polynomial(const Reading& r) {
  int power = 0;
  for (const toml::node& entry : r.c.text.array(r.need("coefficients"), "coefficients"))
    r.push(r.c.vector(entry, "coefficients", r.c.coordinate(-2 - power++)));
  if (power == 0) throw r.c.text.error(r.need("coefficients"), "a polynomial has at least one coefficient");
}

void read_spring(const Reading& r) {
  r.push(r.per_mass("stiffness", {0, -2, 0}));
  r.push(r.find("damping") ? r.per_mass("damping", {0, -1, 0}) : Rational(0));
  r.push_vector_or_zero("anchor", r.c.coordinate());
  r.push(r.find("length") ? r.number("length", r.c.coordinate()) : Rational(0));
}

void read_link(const Reading& r) {
  const toml::node& node = r.need("between");
  const std::vector<std::string> names = r.c.text.words(node, "between");
  if (names.size() != 2 || names[0] == names[1]) throw r.c.text.error(node, "a link is between two bodies");
  r.force.bodies = {r.c.body_named(node, names[0]), r.c.body_named(node, names[1])};
  r.push(r.number("stiffness", {0, -2, 1}));
  r.push(r.find("damping") ? r.number("damping", {0, -1, 1}) : Rational(0));
  r.push(r.find("length") ? r.number("length", r.c.coordinate()) : Rational(0));
}

void read_pendulum(const Reading& r) {
  if (!r.c.angles)
    throw r.c.text.error(r.table,
                         "a pendulum's coordinate is an angle: say coordinates = \"angles\" at the top");
  r.push(r.positive("gravity", {1, -2, 0}) / r.positive("length", {1, 0, 0}));
}

void read_height(const Reading& r) {
  r.push(r.number("gravity", r.c.coordinate(-2)));
  r.push(r.positive("radius", r.c.coordinate()));
}

void read_expression(const Reading& r) {
  const toml::node& node = r.need("acceleration");
  if (!node.is_array() && r.c.scene.dimension == 1) {
    r.force.expressions.push_back(r.expression(node, "acceleration"));
    return;
  }
  for (const toml::node& entry : r.c.text.array(node, "acceleration"))
    r.force.expressions.push_back(r.expression(entry, "acceleration"));
  if (static_cast<int>(r.force.expressions.size()) != r.c.scene.dimension)
    throw r.c.text.error(node,
                         "acceleration has " + std::to_string(r.c.scene.dimension) + " components here");
}

const std::vector<KindEntry>& kinds() {
  static const std::vector<KindEntry> table{
      {"constant",
       ForceKind::constant,
       {"acceleration"},
       [](const Reading& r) { r.push_vector("acceleration", r.c.coordinate(-2)); }},
      {"polynomial", ForceKind::polynomial, {"coefficients"}, read_polynomial},
      {"linear-drag",
       ForceKind::linear_drag,
       {"rate", "wind"},
       [](const Reading& r) {
         r.push(r.per_mass("rate", {0, -1, 0}));
         r.push_vector_or_zero("wind", r.c.coordinate(-1));
       }},
      {"quadratic-drag",
       ForceKind::quadratic_drag,
       {"coefficient", "wind"},
       [](const Reading& r) {
         r.push(r.per_mass("coefficient", {r.c.angles ? 0 : -1, 0, 0}));
         r.push_vector_or_zero("wind", r.c.coordinate(-1));
       }},
      {"spring", ForceKind::spring, {"stiffness", "damping", "anchor", "length"}, read_spring},
      {"link", ForceKind::link, {"between", "stiffness", "damping", "length"}, read_link},
      {"pendulum", ForceKind::pendulum, {"gravity", "length"}, read_pendulum},
      {"kepler",
       ForceKind::kepler,
       {"mu", "centre"},
       [](const Reading& r) {
         r.push(r.number("mu", {3, -2, 0}));
         r.push_vector_or_zero("centre", r.c.coordinate());
       }},
      {"n-body",
       ForceKind::n_body,
       {"G"},
       [](const Reading& r) {
         r.push(r.number("G", {3, -2, -1}));
       }},
      {"height-gravity", ForceKind::height, {"gravity", "radius"}, read_height},
      {"lorentz",
       ForceKind::lorentz,
       {"electric", "magnetic"},
       [](const Reading& r) {
         if (r.c.scene.dimension == 1)
           throw r.c.text.error(r.table, "a magnetic force needs a plane or space");
         r.push_vector_or_zero("electric", r.c.coordinate(-2));
         r.push(r.rotation("magnetic", {0, -1, 0}));
       }},
      {"coriolis",
       ForceKind::coriolis,
       {"rotation", "centrifugal"},
       [](const Reading& r) {
         if (r.c.scene.dimension == 1)
           throw r.c.text.error(r.table, "a Coriolis force needs a plane or space");
         r.push(r.rotation("rotation", {0, -1, 0}));
         const toml::node* node = r.find("centrifugal");
         r.push(Rational(node && !r.c.text.truth(*node, "centrifugal") ? 0 : 1));
       }},
      {"expression", ForceKind::expression, {"acceleration"}, read_expression},
      {"potential",
       ForceKind::potential,
       {"potential"},
       [](const Reading& r) {
         r.force.expressions.push_back(r.expression(r.need("potential"), "potential"));
       }},
  };
  return table;
}

}  // namespace

int SceneContext::body_named(const toml::node& at, const std::string& name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == name) return static_cast<int>(i);
    names.push_back(scene.bodies[i].name);
  }
  throw text.error(at, "there is no body '" + name + "'" + did_you_mean(name, names));
}

std::vector<Rational> SceneContext::vector(const toml::node& node, const std::string& key,
                                           const PhysicalDimension& dimension) const {
  if (!node.is_array() && scene.dimension == 1) return {text.number(node, key, dimension, scene.units)};
  std::vector<Rational> result;
  for (const toml::node& entry : text.array(node, key))
    result.push_back(text.number(entry, key, dimension, scene.units));
  if (static_cast<int>(result.size()) != scene.dimension)
    throw text.error(node, key + " has " + std::to_string(scene.dimension) +
                               (scene.dimension == 1 ? " component" : " components") + " here, not " +
                               std::to_string(result.size()));
  return result;
}

SceneForce read_force(const SceneContext& context, const toml::table& table) {
  const SceneText& text = context.text;
  const toml::node& kind_node = text.need(table, "kind", "a force");
  const std::string kind = text.text(kind_node, "kind");
  const auto entry = std::ranges::find_if(kinds(), [&](const KindEntry& k) { return kind == k.name; });
  if (entry == kinds().end()) {
    std::vector<std::string> names;
    for (const KindEntry& k : kinds()) names.emplace_back(k.name);
    throw text.error(kind_node, "unknown force '" + kind + "'" + did_you_mean(kind, names) + " (there are " +
                                    comma_list(names) + ")");
  }
  std::vector<std::string> keys{"kind", "name", "held", "by_engine"};
  if (entry->kind != ForceKind::link && entry->kind != ForceKind::n_body) keys.emplace_back("bodies");
  keys.insert(keys.end(), entry->keys.begin(), entry->keys.end());
  text.check_keys(table, "a force of kind " + kind, keys);
  SceneForce force;
  force.kind = entry->kind;
  const toml::node* name = text.find(table, "name");
  force.name = name ? text.text(*name, "name") : kind;
  if (const toml::node* held = text.find(table, "held")) force.held = text.truth(*held, "held");
  if (const toml::node* engine = text.find(table, "by_engine"))
    force.by_engine = text.truth(*engine, "by_engine");
  if (const toml::node* bodies = text.find(table, "bodies"))
    for (const std::string& body : text.words(*bodies, "bodies"))
      force.bodies.push_back(context.body_named(*bodies, body));
  else
    for (std::size_t i = 0; i < context.scene.bodies.size(); ++i) force.bodies.push_back(static_cast<int>(i));
  entry->read({context, table, force, "the force '" + force.name + "'"});
  return force;
}

}  // namespace shortfall
