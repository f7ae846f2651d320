#include "tiles/district_result.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <type_traits>
#include <utility>

namespace dupin::cli {
namespace {

/// Changes with whatever is kept.
constexpr std::string_view kMark = "dupin district 19\n";

/// Numbers one after the other: a structure may have bytes between them, which may be any.
template <class Item>
struct IsPlain : std::bool_constant<std::is_arithmetic_v<Item> || std::is_enum_v<Item>> {};
template <class Item, std::size_t count>
struct IsPlain<std::array<Item, count>> : IsPlain<Item> {};
template <class Item>
concept Plain = IsPlain<Item>::value;

class Writer {
 public:
  template <class... Fields>
  void operator()(const Fields&... fields) {
    (put(fields), ...);
  }
  [[nodiscard]] std::string& bytes() { return bytes_; }

 private:
  template <Plain Number>
  void put(const Number& number) {
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &number, sizeof(Number));
    bytes_.append(raw.data(), raw.size());
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
  }
  void put(const Vec3& place) { (*this)(place.x(), place.y(), place.z()); }
  template <class Item>
  void put(const std::optional<Item>& item) {
    put(std::uint8_t{item ? std::uint8_t{1} : std::uint8_t{0}});
    if (item) {
      put(*item);
    }
  }
  template <class Item>
  void put(const std::vector<Item>& items) {
    put(std::uint64_t{items.size()});
    for (const Item& item : items) {
      put(item);
    }
  }
  void put(const ThinShell& shell) { (*this)(shell.place, shell.thickness, shell.move); }
  void put(const Contact& contact) {
    (*this)(contact.kind, contact.from, contact.to, contact.names);
  }
  void put(const ContactSettlement& settled) {
    (*this)(settled.policy, settled.length, settled.contacts);
  }
  void put(const SeamSide& side) {
    (*this)(side.is_end, side.has_others, side.borders, side.end, side.near);
  }
  void put(const DistrictVoid& own) {
    (*this)(own.box.min(), own.box.max(), own.places, own.is_within);
  }
  void put(const MeshBorder& border) {
    (*this)(border.name, border.points, border.corners, border.labels);
  }
  void put(const SeamBorder& border) { (*this)(border.shell, border.points); }
  void put(const ShellReport& shell) {
    (*this)(shell.first_face, shell.triangles, shell.volume, shell.depth, shell.euler_number);
  }
  void put(const RegionVolumes& volumes) { (*this)(volumes.outer, volumes.metal, volumes.fluid); }
  void put(const PartReport& part);
  void put(const Report& report);
  void put(const RoundingReport& report);

  std::string bytes_;
};

/// Reads what Writer has written, in the same order; `is_good` turns false at the end of bytes.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class... Fields>
  void operator()(Fields&... fields) {
    (get(fields), ...);
  }
  [[nodiscard]] bool is_good() const { return is_good_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  [[nodiscard]] std::string_view take(std::uint64_t size) {
    is_good_ = is_good_ && size <= bytes_.size();
    const std::string_view taken = bytes_.substr(0, is_good_ ? size : 0);
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  template <Plain Number>
  void get(Number& number) {
    const std::string_view raw = take(sizeof(Number));
    if (is_good_) {
      std::memcpy(&number, raw.data(), sizeof(Number));
    }
  }
  void get(std::string& text) {
    std::uint64_t size = 0;
    get(size);
    text = take(size);
  }
  void get(Vec3& place) { (*this)(place.x(), place.y(), place.z()); }
  template <class Item>
  void get(std::optional<Item>& item) {
    std::uint8_t is_there = 0;
    get(is_there);
    if (is_there != 0) {
      Item value{};
      get(value);
      item = std::move(value);
    }
  }
  template <class Item>
  void get(std::vector<Item>& items) {
    std::uint64_t size = 0;
    get(size);
    items.clear();
    for (std::uint64_t i = 0; i < size && is_good_; ++i) {
      get(items.emplace_back());
    }
  }
  void get(ThinShell& shell) { (*this)(shell.place, shell.thickness, shell.move); }
  void get(Contact& contact) { (*this)(contact.kind, contact.from, contact.to, contact.names); }
  void get(ContactSettlement& settled) {
    (*this)(settled.policy, settled.length, settled.contacts);
  }
  void get(SeamSide& side) {
    (*this)(side.is_end, side.has_others, side.borders, side.end, side.near);
  }
  void get(DistrictVoid& own) { (*this)(own.box.min(), own.box.max(), own.places, own.is_within); }
  void get(MeshBorder& border) {
    (*this)(border.name, border.points, border.corners, border.labels);
  }
  void get(SeamBorder& border) { (*this)(border.shell, border.points); }
  void get(ShellReport& shell) {
    (*this)(shell.first_face, shell.triangles, shell.volume, shell.depth, shell.euler_number);
  }
  void get(RegionVolumes& volumes) { (*this)(volumes.outer, volumes.metal, volumes.fluid); }
  void get(PartReport& part);
  void get(Report& report);
  void get(RoundingReport& report);

  std::string_view bytes_;
  bool is_good_ = true;
};

/// The fields that are kept, for reading and for writing.
template <class Archive, class Part>
void visit_part(Archive& archive, Part& part) {
  archive(part.name, part.index, part.kind, part.construction, part.rejected, part.warnings,
          part.margin_lower, part.margin_upper, part.start_tangency, part.end_tangency,
          part.error_bound, part.segments, part.bands, part.triangles, part.smallest_angle,
          part.least_wall, part.is_hollow);
}

template <class Archive, class Checked>
void visit_check(Archive& archive, Checked& report) {
  archive(report.points, report.triangles, report.counts, report.shells, report.components,
          report.euler_number, report.genus, report.volume, report.area);
}

template <class Archive, class Rounding>
void visit_rounding(Archive& archive, Rounding& report) {
  archive(report.coordinates, report.origin, report.moved, report.largest_move, report.repair_reach,
          report.removed_triangles, report.removed_shells, report.filled_places, report.slit_width,
          report.snapped_places, report.thin_shells);
}

template <class Archive, class Result, class Parts, class Checked>
void visit_result(Archive& archive, Result& result, Parts& parts, Checked& report) {
  auto& built = result.built;
  archive(parts, built.runs, built.pieces, built.grid, built.region, built.volumes,
          built.insulation, report, result.output.report.rounding, result.output.report.contacts,
          result.output.report.settled, result.output.piece.names, result.output.piece.points,
          result.output.piece.triangles, result.output.piece.labels, result.output.piece.borders,
          result.output.seen, result.output.sides, result.output.voids);
}

void Writer::put(const PartReport& part) { visit_part(*this, part); }
void Writer::put(const Report& report) { visit_check(*this, report); }
void Writer::put(const RoundingReport& report) { visit_rounding(*this, report); }
void Reader::get(PartReport& part) { visit_part(*this, part); }
void Reader::get(Report& report) { visit_check(*this, report); }
void Reader::get(RoundingReport& report) { visit_rounding(*this, report); }

/// Against accidents, not against forgers: whoever can write here can write the result, too.
std::uint64_t sum_of(std::string_view bytes) { return std::hash<std::string_view>{}(bytes); }

// Of a rest that is long enough.
void take_last(std::string_view& rest, std::uint64_t& number) {
  rest.remove_suffix(sizeof(number));
  std::memcpy(&number, rest.data() + rest.size(), sizeof(number));
}

}  // namespace

// Facets, fields, how many bytes the facets are, the sum of all that, and the mark.
std::string bytes_of(const DistrictResult& result, const std::vector<std::uint32_t>& parts) {
  std::vector<PartReport> local = result.built.parts;
  for (PartReport& part : local) {
    const auto place = std::ranges::lower_bound(parts, part.index);
    part.index = static_cast<std::uint32_t>(place - parts.begin());
  }
  const Report report = result.output.report.check.value_or(Report{});
  Writer writer;
  std::string& bytes = writer.bytes();
  bytes = result.output.piece.bytes;
  visit_result(writer, result, std::as_const(local), report);
  writer(std::uint64_t{result.output.piece.bytes.size()});
  writer(sum_of(bytes));
  bytes += kMark;
  return std::move(bytes);
}

std::optional<DistrictResult> result_of(std::string bytes,
                                        const std::vector<std::uint32_t>& parts) {
  std::uint64_t facets = 0, sum = 0;
  std::string_view rest = bytes;
  if (!rest.ends_with(kMark) || rest.size() < kMark.size() + sizeof(sum) + sizeof(facets)) {
    return std::nullopt;
  }
  rest.remove_suffix(kMark.size());
  take_last(rest, sum);
  if (sum_of(rest) != sum) {
    return std::nullopt;
  }
  take_last(rest, facets);
  if (facets > rest.size()) {
    return std::nullopt;
  }
  DistrictResult result;
  Report report;
  Reader reader(rest.substr(facets));
  visit_result(reader, result, result.built.parts, report);
  if (!reader.is_good() || reader.left() > 0) {
    return std::nullopt;
  }
  bytes.resize(facets);  // most of what is kept: they stay where they are
  result.output.piece.bytes = std::move(bytes);
  for (PartReport& part : result.built.parts) {
    if (part.index >= parts.size()) {
      return std::nullopt;
    }
    part.index = parts[part.index];
  }
  result.output.report.check = std::move(report);
  return result;
}

}  // namespace dupin::cli
