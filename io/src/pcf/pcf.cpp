#include "dupin/io/pcf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "pcf/bores.h"
#include "pcf/nominal_pipe.h"
#include "pcf/records.h"
#include "text/byte_order_mark.h"
#include "text/lower_case.h"
#include "text/text_scanner.h"
#include "text/utf16.h"

namespace dupin {
namespace {

using pcf::Attribute;
using pcf::BoreUnit;
using pcf::HeadKind;
using pcf::Record;
using text::TextScanner;

// Beyond a hundred kilometres, and pipes thicker than a hundred metres, are no plant.
constexpr double kLargestCoordinate = 1e8, kLargestBore = 1e5;
constexpr double kInch = 25.4, kHundredth = 0.01;
constexpr std::array kUnits = std::to_array<std::pair<std::string_view, double>>(
    {{"mm", 1}, {"inch", kInch}, {"mm-hundredth", kHundredth}, {"inch-sixteenth", kInch / 16}});
constexpr const char* kUnitNames = "MM or INCH, or MM-HUNDREDTH or INCH-SIXTEENTH of these";
// In millimetres: thinner than a hair.
constexpr double kLeastBore = 0.01;
// In degrees: what rounded points explain of a difference between a bend's angle and theirs.
constexpr double kSameAngle = 1;

// Attributes that say nothing of the solid, by how they begin.
constexpr std::array kKnown = std::to_array<std::string_view>({"SKEY",
                                                               "ATTRIBUTE",
                                                               "COMPONENT-ATTRIBUTE",
                                                               "ITEM-",
                                                               "MATERIAL-",
                                                               "ANGLE",
                                                               "WEIGHT",
                                                               "FABRICATION-",
                                                               "UCI",
                                                               "UNIQUE-",
                                                               "COMPONENT-IDENTIFIER",
                                                               "MASTER-COMPONENT-IDENTIFIER",
                                                               "PIPELINE-",
                                                               "PIPING-SPEC",
                                                               "SPINDLE-",
                                                               "FLAT-DIRECTION",
                                                               "INSULATION",
                                                               "TRACING",
                                                               "CATEGORY",
                                                               "STATUS",
                                                               "TAG",
                                                               "NAME",
                                                               "DIRECTION",
                                                               "SUPPORT-",
                                                               "MESSAGE-",
                                                               "TEXT",
                                                               "CONTINUATION",
                                                               "BOLT-",
                                                               "REPEAT-",
                                                               "SPOOL-",
                                                               "REVISION",
                                                               "END-CONNECTION",
                                                               "CO-ORDS",
                                                               "TAP-CONNECTION",
                                                               "CUT-PIECE",
                                                               "QUANTITY",
                                                               "BRANCH-",
                                                               "PIPE-",
                                                               "WELD-",
                                                               "GASKET-",
                                                               "FLOW",
                                                               "LENGTH",
                                                               "DESCRIPTION",
                                                               "PROJECT-",
                                                               "AREA",
                                                               "DATE",
                                                               "ORIGINAL-",
                                                               "R2_",
                                                               "COLLAR-",
                                                               "DIMENSION",
                                                               "DRAWING-",
                                                               "MISC-",
                                                               "SPEC",
                                                               "CLASS",
                                                               "COMPONENT-",
                                                               "HEAT-",
                                                               "SHOP",
                                                               "CONNECTION-",
                                                               "REFERENCE",
                                                               "OPERATION",
                                                               "START-",
                                                               "STOP-",
                                                               "ELEVATION",
                                                               "PCF_",
                                                               "PSI_",
                                                               "SIZE",
                                                               "ITEM",
                                                               "LOCATION"});

enum class Family { straight, bend, fitting, closure, any };

Family family_of(std::string_view kind) {
  if (kind.starts_with("ELBOW") || kind.starts_with("BEND")) {
    return Family::bend;
  }
  if (kind == "CAP" || kind == "FLANGE-BLIND" || kind == "BLIND-FLANGE" || kind == "PLUG") {
    return Family::closure;
  }
  for (const std::string_view fitting : {"TEE", "OLET", "CROSS", "Y-PIECE"}) {
    if (kind.starts_with(fitting)) {
      return Family::fitting;
    }
  }
  for (const std::string_view straight : {"PIPE", "REDUCER", "FLANGE", "GASKET", "COUPLING"}) {
    if (kind.starts_with(straight)) {
      return Family::straight;
    }
  }
  return Family::any;
}

class PcfReader {
 public:
  PcfReader(std::string_view text, const std::string& source, BoreMeaning bores)
      : scanner_(text, source), source_(source), bores_(bores), records_(pcf::records(text)) {
    file_.line.source = source;
  }

  PcfFile run() {
    read_units();
    for (const Record& record : records_) {
      switch (pcf::head_kind(record.head.keyword)) {
        case HeadKind::component:
          add(record);
          break;
        case HeadKind::skipped:
          ++file_.skipped[record.head.keyword];
          break;
        case HeadKind::setting:
          break;
        case HeadKind::unknown:
          note_unknown(record.head);
          break;
      }
    }
    list_unknown();
    if (file_.line.components.empty()) {
      throw Error(Errc::parse_failed, "there is no piping component in it, such as PIPE or ELBOW",
                  {}, source_);
    }
    pcf::give_meaning(file_, bore_unit_, whole_bore_, bores_, own_radii_);
    for (std::size_t i = 0; i < file_.line.components.size(); ++i) {
      if (own_radii_[i]) {
        for (PipingPort& port : file_.line.components[i].ports) {
          port.radius = own_radii_[i];
        }
      }
    }
    return std::move(file_);
  }

 private:
  void read_units() {
    millimetres_ = stated_unit("UNITS-CO-ORDS");
    bore_millimetres_ = stated_unit("UNITS-BORE");
    // Bores are names of sizes, in whole millimetres or inches.
    bore_unit_ = bore_millimetres_ == 1 || bore_millimetres_ == kHundredth ? BoreUnit::millimetre
                                                                           : BoreUnit::inch;
    whole_bore_ = bore_unit_ == BoreUnit::millimetre ? 1 : kInch;
  }

  // In millimetres: that of all lines with the keyword, which must not contradict each other.
  double stated_unit(const std::string& keyword) const {
    const Attribute* first = nullptr;
    for (const Record& record : records_) {
      const Attribute& head = record.head;
      if (head.keyword != keyword) {
        continue;
      }
      if (first != nullptr && millimetres(head) != millimetres(*first)) {
        scanner_.fail_at(head.position, "found " + keyword + " " + text::quoted(head.text) +
                                            ", but line " + std::to_string(first->line) + " says " +
                                            text::quoted(first->text) +
                                            "; expected one unit for the whole file");
      }
      first = first == nullptr ? &head : first;
    }
    if (first == nullptr) {
      throw Error(Errc::parse_failed, "the line " + keyword + " is missing; it says " + kUnitNames,
                  {}, source_);
    }
    return millimetres(*first);
  }

  // Of the unit that a line states.
  [[nodiscard]] double millimetres(const Attribute& attribute) const {
    std::string word = text::lower_case(std::string(attribute.text));
    std::ranges::replace(word, '_', '-');
    for (const auto& [name, size] : kUnits) {
      if (word == name || word == std::string(name) + "s" || word == std::string(name) + "es") {
        return size;
      }
    }
    scanner_.fail_at(attribute.position,
                     "found " + text::quoted(attribute.text) + ", expected the unit " + kUnitNames);
  }

  // A number, which is in a unit of so many millimetres.
  double number(const std::string& expected, double largest, double millimetres) {
    scanner_.skip_blanks();
    const std::size_t position = scanner_.position();
    const double value = scanner_.number(expected);
    if (!(std::abs(value) * millimetres <= largest)) {
      const double most = largest / millimetres;
      scanner_.fail_at(
          position, "found " + (value > 0 ? decimal_at_most(value) : decimal_at_least(value)) +
                        ", expected " + expected + " of at most " + decimal(most, kMessageDigits));
    }
    return value + 0.0;  // -0 is 0
  }

  double positive(const Attribute& attribute, const std::string& expected, double millimetres) {
    scanner_.move_to(attribute.position);
    const double value = number(expected, kLargestBore, millimetres);
    if (!(value >= 0)) {
      scanner_.fail_at(attribute.position, "found " + decimal(value, kMessageDigits) +
                                               ", expected " + expected + " that is not negative");
    }
    return value;
  }

  Vec3 point(const Attribute& attribute) {
    scanner_.move_to(attribute.position);
    Vec3 result;
    for (double& x : result) {
      x = number("a coordinate", kLargestCoordinate, millimetres_) * millimetres_;
    }
    return result;
  }

  // The radius in the file's unit of bores stays with the port until all bores are known.
  PipingPort port(const Attribute& attribute) {
    PipingPort result{point(attribute), {}, attribute.line};
    const std::string_view next = scanner_.peek();
    const bool is_code =
        !next.empty() && ((next[0] >= 'A' && next[0] <= 'Z') || (next[0] >= 'a' && next[0] <= 'z'));
    if (!next.empty() && !is_code) {
      const std::size_t position = scanner_.position();
      const double bore = number("a bore", kLargestBore, bore_millimetres_);
      if (!(bore == 0 || bore * bore_millimetres_ >= kLeastBore)) {
        const double least = kLeastBore / bore_millimetres_;
        scanner_.fail_at(position, "found the bore " + decimal_at_least(bore) +
                                       ", expected 0 for none, or at least " +
                                       decimal(least, kMessageDigits));
      }
      if (bore > 0) {
        result.radius = bore * (bore_millimetres_ / whole_bore_) / 2;
      }
    }
    return result;
  }

  // What a component has one of, by the keywords that say it; empty of others.
  static std::string said_once(const std::string& keyword) {
    return keyword == "CENTRE-POINT"                                     ? "centre point"
           : keyword == "BEND-RADIUS"                                    ? "bend radius"
           : keyword == "R2_OUTER_DIAM" || keyword == "OUTSIDE-DIAMETER" ? "outside diameter"
           : keyword == "R2_WALL_THK" || keyword == "WALL-THICKNESS"     ? "wall thickness"
                                                                         : "";
  }

  // Two that differ; a length of 0 says nothing.
  void refuse_contradictions(const Record& record) {
    std::map<std::string, std::pair<const Attribute*, Vec3>> said;
    for (const Attribute& attribute : record.attributes) {
      const std::string what = said_once(attribute.keyword);
      if (what.empty()) {
        continue;
      }
      const bool is_point = what == "centre point";
      const double unit = what == "bend radius" ? millimetres_ : bore_millimetres_;
      const Vec3 value =
          is_point
              ? point(attribute)
              : Vec3(positive(attribute, (what.front() == 'o' ? "an " : "a ") + what, unit), 0, 0);
      if (!is_point && value.x() == 0) {
        continue;
      }
      const auto [found, is_first] = said.try_emplace(what, &attribute, value);
      const auto& [first, before] = found->second;
      if (!is_first && value != before) {
        scanner_.fail_at(attribute.position, "found " + attribute.keyword + " " +
                                                 text::quoted(attribute.text) + ", but line " +
                                                 std::to_string(first->line) + " says " +
                                                 text::quoted(first->text) + "; expected one " +
                                                 what + " for the component");
      }
    }
  }

  void add(const Record& record) {
    PipingComponent component;
    component.kind = record.head.keyword;
    component.line = record.head.line;
    component.name = text::lower_case(component.kind) + "-" + std::to_string(component.line);
    component.is_eccentric =
        component.kind.starts_with("REDUCER") || component.kind == "FLANGE-REDUCING-ECCENTRIC";
    std::optional<double> radius, angle;
    std::vector<PipingPort> branches;
    refuse_contradictions(record);
    for (const Attribute& attribute : record.attributes) {
      const std::string& keyword = attribute.keyword;
      if (keyword == "END-POINT") {
        component.ports.push_back(port(attribute));
      } else if (keyword.starts_with("BRANCH") && keyword.ends_with("-POINT")) {
        branches.push_back(port(attribute));
      } else if (keyword == "CENTRE-POINT") {
        component.center = point(attribute);
      } else if (keyword == "BEND-RADIUS") {
        const double bend = positive(attribute, "a bend radius", millimetres_);
        component.bend_radius =
            bend > 0 ? std::optional(bend * millimetres_) : component.bend_radius;
      } else if (keyword == "R2_OUTER_DIAM" || keyword == "OUTSIDE-DIAMETER") {
        const double diameter = positive(attribute, "an outside diameter", bore_millimetres_);
        radius = diameter > 0 ? std::optional(diameter / 2 * bore_millimetres_) : radius;
      } else if (keyword == "R2_WALL_THK" || keyword == "WALL-THICKNESS") {
        const double wall = positive(attribute, "a wall thickness", bore_millimetres_);
        component.wall = wall > 0 ? std::optional(wall * bore_millimetres_) : component.wall;
      } else if (keyword == "ANGLE") {
        angle = pcf::leading_number(attribute.text);
      } else if (!is_known(keyword)) {
        note_unknown(attribute);
      }
    }
    component.ports.insert(component.ports.end(), branches.begin(), branches.end());
    give_shape(component);
    if (component.ports.empty() && family_of(component.kind) == Family::any) {
      ++file_.skipped[component.kind];  // a balloon, or another drawing of an instrument
      file_.unknown.push_back(
          {component.line, component.name + " has no end in space; nothing is made of it"});
      return;
    }
    if (!repeats(component, radius)) {
      if (angle) {
        note_angle(component, *angle);
      }
      ++file_.kinds[component.kind];
      file_.line.components.push_back(std::move(component));
      own_radii_.push_back(radius);
    }
  }

  // Of a bend, which turns as its points do. The angle is in hundredths of a degree, but in degrees
  // of some programs.
  void note_angle(const PipingComponent& bend, double angle) {
    if (bend.shape != PipingShape::bend || bend.ports.size() < 2 || !bend.center || angle == 0) {
      return;
    }
    const Vec3 in = *bend.center - bend.ports[0].center, out = bend.ports[1].center - *bend.center;
    const double turned = std::atan2(in.cross(out).norm(), in.dot(out)) * (180 / std::numbers::pi);
    const double said = kHundredth * angle;
    if (std::min(std::abs(said - turned), std::abs(angle - turned)) > kSameAngle) {
      file_.line.notes.push_back({bend.line, bend.name + ": turns by " +
                                                 decimal(turned, kMessageDigits) +
                                                 " degrees, as its points say; its angle says " +
                                                 decimal(said, kMessageDigits)});
    }
  }

  static bool is_known(const std::string& keyword) {
    return std::ranges::any_of(kKnown,
                               [&](std::string_view known) { return keyword.starts_with(known); });
  }

  static void give_shape(PipingComponent& component) {
    const Family family = family_of(component.kind);
    const std::size_t ports = component.ports.size();
    switch (family) {
      case Family::straight:  // half couplings and reducers with a branch have a centre
        component.shape =
            component.center && ports != 2 ? PipingShape::fitting : PipingShape::straight;
        break;
      case Family::bend:
        component.shape = PipingShape::bend;
        break;
      case Family::fitting:
        component.shape = PipingShape::fitting;
        break;
      case Family::closure:
        component.shape = PipingShape::closure;
        break;
      case Family::any:
        component.shape = ports == 1                        ? PipingShape::closure
                          : ports == 2 && !component.center ? PipingShape::straight
                                                            : PipingShape::fitting;
        break;
    }
    if (component.shape == PipingShape::fitting && !component.center && ports >= 2) {
      component.center = (component.ports[0].center + component.ports[1].center) / 2;
    }
  }

  // The same kind between the same points, in whatever order; where they are one, with the same
  // bores: steps from bore to bore may follow each other.
  bool repeats(const PipingComponent& component, const std::optional<double>& own_radius) {
    std::vector<std::array<double, 3>> points;
    points.reserve(component.ports.size());
    for (const PipingPort& port : component.ports) {
      points.push_back({port.center.x(), port.center.y(), port.center.z()});
    }
    std::ranges::sort(points);
    if (points.size() > 1 && points.front() == points.back()) {
      std::vector<std::array<double, 3>> bores;
      for (const PipingPort& port : component.ports) {
        bores.push_back({port.radius.value_or(0), 0, 0});
      }
      std::ranges::sort(bores);
      points.insert(points.end(), bores.begin(), bores.end());
    }
    const auto [found, is_new] =
        places_.try_emplace({component.kind, std::move(points)}, file_.line.components.size());
    if (is_new || component.ports.empty()) {
      return false;
    }
    const PipingComponent& other = file_.line.components[found->second];
    std::string others;  // what it has others of
    const auto differs = [&](bool is_other, const std::string& what) {
      others += is_other ? (others.empty() ? "another " : " and another ") + what : "";
    };
    differs(bores_at_points(component) != bores_at_points(other) ||
                own_radius != own_radii_[found->second],
            "bore");
    differs(component.wall != other.wall, "wall");
    differs(component.center != other.center, "centre point");
    differs(component.bend_radius != other.bend_radius, "bend radius");
    const std::string there = "the one at line " + std::to_string(other.line);
    file_.line.notes.push_back(
        {component.line,
         component.name + (others.empty() ? ": repeats " + there + "; it is left out"
                                          : ": lies between the same points as " + there +
                                                ", and has " + others + "; it is left out")});
    return true;
  }

  // With the points that they are at, in order.
  static std::vector<std::array<double, 4>> bores_at_points(const PipingComponent& component) {
    std::vector<std::array<double, 4>> result;
    for (const PipingPort& port : component.ports) {
      result.push_back(
          {port.center.x(), port.center.y(), port.center.z(), port.radius.value_or(0)});
    }
    std::ranges::sort(result);
    return result;
  }

  // Each keyword once, where it occurs first.
  void note_unknown(const Attribute& attribute) {
    auto& [line, count] = unknown_[attribute.keyword];
    line = count++ == 0 ? attribute.line : line;
  }

  void list_unknown() {
    for (const auto& [keyword, found] : unknown_) {
      const auto& [line, count] = found;
      file_.unknown.push_back(
          {line, text::quoted(keyword) + " is not understood" +
                     (count > 1 ? ", here and on " + std::to_string(count - 1) +
                                      (count > 2 ? " other lines" : " other line")
                                : "")});
    }
    std::ranges::stable_sort(file_.unknown, {}, &SourceNote::line);
  }

  TextScanner scanner_;
  std::string source_;
  BoreMeaning bores_;
  std::vector<Record> records_;
  PcfFile file_;
  std::vector<std::optional<double>> own_radii_;
  std::map<std::pair<std::string, std::vector<std::array<double, 3>>>, std::size_t> places_;
  std::map<std::string, std::pair<std::size_t, std::size_t>> unknown_;  // line, count
  double millimetres_ = 1, bore_millimetres_ = 1;
  double whole_bore_ = 1;  // of the unit that names of sizes are in
  BoreUnit bore_unit_ = BoreUnit::millimetre;
};

}  // namespace

std::size_t PcfReport::findings() const {
  return std::size_t(std::ranges::count_if(network.notes, &SourceNote::is_refusal)) +
         std::size_t(std::ranges::count(network.joints, JointState::apart, &PipingJoint::state)) +
         (is_strict ? file.unknown.size() : 0);
}

bool is_pcf_file(const std::filesystem::path& file) {
  return text::lower_case(file.extension().string()) == ".pcf";
}

bool is_pcf_text(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n", text::byte_order_mark(text));
  return first != std::string_view::npos && text[first] != '{' &&
         std::ranges::any_of(pcf::records(text), [](const Record& record) {
           return record.head.keyword.starts_with("UNITS-");
         });
}

PcfFile parse_pcf(std::string_view text, const std::string& source, BoreMeaning bores) {
  const UsualArithmetic usual;
  text::refuse_utf16(text, source);
  return PcfReader(text, source, bores).run();
}

}  // namespace dupin
