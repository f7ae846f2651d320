#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

PartStart start(const JsonNode& node, Keys keys) {
  keys.insert(keys.end(), {"from", "form"});
  const bool from_port = node.at("from").value().is_string();
  if (!from_port) {
    keys.insert(keys.end(), {"direction", "radius"});
  }
  allow_only(node, keys, with_sizes(keys));
  return from_port ? PartStart(port(node.at("from")))
                   : Place{vector(node.at("from")), vector(node.at("direction")),
                           node.at("radius").number()};
}

}  // namespace

template <>
struct PartReader<"head"> {
  static PartShape read(const JsonNode& node) {
    const std::string form = node.at("form").text();
    if (form == "ellipsoidal") {
      const PartStart from = start(node, {"depth"});
      return EllipsoidalHead{
          from, node.has("depth") ? std::optional(node.at("depth").number()) : std::nullopt};
    }
    if (form == "torispherical") {
      const PartStart from = start(node, {"crown", "knuckle"});
      return TorisphericalHead{from, HeadForm::free, node.at("crown").number(),
                               node.at("knuckle").number()};
    }
    if (form == "kloepper") {
      return TorisphericalHead{start(node, {}), HeadForm::kloepper};
    }
    if (form == "korbbogen") {
      return TorisphericalHead{start(node, {}), HeadForm::korbbogen};
    }
    node.at("form").fail(
        "must be \"ellipsoidal\", \"torispherical\", \"kloepper\" or \"korbbogen\", not \"" + form +
        "\"");
  }
};
template PartShape read_part<"head">(const JsonNode& node);

}  // namespace dupin::json
