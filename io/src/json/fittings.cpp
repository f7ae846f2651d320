#include "json/fittings.h"

#include <array>
#include <utility>

#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

constexpr std::array<std::string_view, 2> kFittings{"tee", "valve"};
// What is said beside the key of a part and holds for what it is made of.
constexpr std::array<std::string_view, 5> kGeneral{"comment", "wall", "wall_side", "insulation",
                                                   "solid"};

// Of the keys that a pipe has, typed.
Json run(const JsonNode& fitting) {
  const JsonNode from = fitting.at("from");
  Json pipe = Json::object();
  if (from.value().is_string()) {
    (void)port(from);
    pipe["from"] = from.value();
  } else {
    (void)vector(from);
    (void)vector(fitting.at("direction"));
    pipe["from"] = from.value();
    pipe["direction"] = fitting.at("direction").value();
    pipe["radius"] = fitting.at("radius").number();
  }
  pipe["length"] = fitting.at("length").number();
  return pipe;
}

Keys run_keys(const JsonNode& fitting) {
  fitting.require_object();
  return fitting.at("from").value().is_string() ? Keys{"from", "length"}
                                                : Keys{"from", "direction", "length", "radius"};
}

void allow_also(const JsonNode& fitting, Keys keys, std::initializer_list<std::string_view> more) {
  keys.insert(keys.end(), more);
  allow_only(fitting, keys, with_sizes(keys));
}

class Fitting {
 public:
  Fitting(const JsonNode& part, std::string_view kind)
      : part_(part), kind_(kind), name_(part.at("name").text()) {
    Keys keys{"name"};
    keys.insert(keys.end(), kGeneral.begin(), kGeneral.end());
    keys.push_back(kind_);
    allow_only(part, keys);
  }

  std::vector<Member> tee() {
    const JsonNode own = part_.at("tee");
    allow_also(own, run_keys(own), {"branch", "fillet"});
    add("", "tee", {{"pipe", run(own)}}, true);
    const JsonNode branch = own.at("branch");
    const Keys keys{"at", "direction", "length", "radius", "wall", "wall_side"};
    allow_only(branch, keys, with_sizes(keys));
    (void)vector(branch.at("direction"));
    add("-branch", "tee/branch",
        {{"pipe",
          {{"on", name_},
           {"at", branch.has("at") ? branch.at("at").number() : own.at("length").number() / 2},
           {"direction", branch.at("direction").value()},
           {"length", branch.at("length").number()},
           {"radius", branch.at("radius").number()}}}},
        true);
    if (branch.has("wall")) {
      members_.back().part["wall"] = branch.at("wall").number();
    }
    if (branch.has("wall_side")) {
      members_.back().part["wall_side"] = branch.at("wall_side").text();
    }
    if (own.has("fillet")) {
      add("-fillet", "tee",
          {{"fillet",
            {{"between", {name_, name_ + "-branch"}}, {"radius", own.at("fillet").number()}}}},
          false);
    }
    return std::move(members_);
  }

  std::vector<Member> valve() {
    const JsonNode own = part_.at("valve");
    allow_also(own, run_keys(own), {"body", "stem"});
    add("", "valve", {{"pipe", run(own)}}, true);
    const double middle = own.at("length").number() / 2;
    const JsonNode body = own.at("body");
    allow_only(body, {"radius", "length"});
    add("-body", "valve/body",
        {{"flange",
          {{"on", name_},
           {"at", middle},
           {"radius", body.at("radius").number()},
           {"thickness", body.at("length").number()}}}},
        false);
    if (own.has("stem")) {
      const JsonNode stem = own.at("stem");
      allow_only(stem, {"direction", "length", "radius"});
      (void)vector(stem.at("direction"));
      add("-stem", "valve/stem",
          {{"pipe",
            {{"on", name_},
             {"at", middle},
             {"direction", stem.at("direction").value()},
             {"length", stem.at("length").number()},
             {"radius", stem.at("radius").number()}}},
           {"wall", 0}},
          false);
    }
    return std::move(members_);
  }

 private:
  void add(const std::string& suffix, const std::string& key, Json shape, bool has_walls) {
    Json result = {{"name", name_ + suffix}};
    result.update(shape);
    for (const std::string_view general : kGeneral) {
      if (has_walls && part_.has(general)) {
        result[std::string(general)] = part_.at(general).value();
      }
    }
    result["component"] = {{"name", name_}, {"kind", kind_}};
    members_.push_back({std::move(result), key});
  }

  const JsonNode& part_;
  std::string_view kind_;
  std::string name_;
  std::vector<Member> members_;
};

}  // namespace

std::span<const std::string_view> fitting_keys() { return kFittings; }

std::vector<Member> members(Json part, const std::string& source, const std::string& pointer) {
  const JsonNode node(part, source, pointer);
  node.require_object();
  if (node.has("tee")) {
    return Fitting(node, "tee").tee();
  }
  if (node.has("valve")) {
    return Fitting(node, "valve").valve();
  }
  std::vector<Member> itself(1);
  itself.front().part = std::move(part);
  return itself;
}

}  // namespace dupin::json
