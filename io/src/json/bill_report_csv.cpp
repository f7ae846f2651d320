#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "dupin/io/bill_report.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

// One line of cells, separated by commas.
class Line {
 public:
  Line& text(std::string_view value) {
    begin();
    text_ += '"';
    // Spreadsheets take what begins so for a formula, quoted or not, and run it.
    text_ += value.find_first_of("=+-@\t\r\n") == 0 ? "'" : "";
    for (const char c : value) {
      text_.append(c == '"' ? 2 : 1, c);
    }
    text_ += '"';
    return *this;
  }
  Line& number(const std::optional<double>& value) {
    begin();
    if (value) {
      append_decimal(text_, *value);
    }
    return *this;
  }
  Line& moments(const std::optional<SolidMoments>& solid) {
    const Eigen::Matrix3d tensor = solid ? inertia(*solid) : Eigen::Matrix3d::Zero().eval();
    const auto cell = [&](double value) { number(solid ? std::optional(value) : std::nullopt); };
    for (int i = 0; i < 3; ++i) {
      cell(solid ? solid->centroid[i] : 0);
    }
    for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
      cell(tensor(i, j));
    }
    return *this;
  }
  [[nodiscard]] std::string end() const { return text_ + "\r\n"; }

 private:
  void begin() {
    if (begun_) {
      text_ += ',';
    }
    begun_ = true;
  }

  std::string text_;
  bool begun_ = false;
};

struct Column {
  std::string_view name;
  int power = 0;  // of the unit; 0: a plain number or text
};

constexpr std::array kColumns = std::to_array<Column>({{"name"},
                                                       {"kind"},
                                                       {"component"},
                                                       {"component_kind"},
                                                       {"line"},
                                                       {"size"},
                                                       {"wall", 1},
                                                       {"length", 1},
                                                       {"bend_radius", 1},
                                                       {"bend_angle_rad"},
                                                       {"area", 2},
                                                       {"outer_volume", 3},
                                                       {"metal_volume", 3},
                                                       {"fluid_volume", 3},
                                                       {"metal_mass_kg"},
                                                       {"center_x", 1},
                                                       {"center_y", 1},
                                                       {"center_z", 1},
                                                       {"inertia_xx", 5},
                                                       {"inertia_yy", 5},
                                                       {"inertia_zz", 5},
                                                       {"inertia_xy", 5},
                                                       {"inertia_xz", 5},
                                                       {"inertia_yz", 5},
                                                       {"remarks"}});

std::string head(Unit unit) {
  Line line;
  for (const auto& [name, power] : kColumns) {
    std::string cell(name);
    if (power > 0) {
      cell.append("_").append(symbol(unit)).append(power > 1 ? std::to_string(power) : "");
    }
    line.text(cell);
  }
  return line.end();
}

std::optional<double> volume(const std::optional<SolidMoments>& solid) {
  return solid ? std::optional(solid->volume) : std::nullopt;
}

std::string cells(const BillRow& row, std::optional<double> wall, const BillReport& report,
                  const BillOrigin& from) {
  Line line;
  line.text(row.name).text(row.kind).text(from.component).text(from.kind);
  line.number(from.line > 0 ? std::optional(double(from.line)) : std::nullopt);
  line.text(size_text(row.sizes, report.bill.unit)).number(wall).number(row.length);
  line.number(row.bend_radius).number(row.bend_angle).number(row.area).number(volume(row.outer));
  line.number(volume(row.metal)).number(volume(row.fluid));
  line.number(row.metal ? mass(report, row.metal->volume) : std::nullopt).moments(row.metal);
  std::string remarks;
  for (const std::string& remark : row.remarks) {
    remarks.append(remarks.empty() ? "" : "; ").append(remark);
  }
  return line.text(remarks).end();
}

BillRow sum_of(const BillOfMaterials& bill) {
  const BillTotals sum = totals(bill);
  BillRow row;
  row.name = "sum";
  const auto is_any = [&](const auto& measure) {
    return std::ranges::any_of(bill.rows, [&](const BillRow& of) { return bool(of.*measure); });
  };
  // What no row has is not summed up to 0.
  row.area = is_any(&BillRow::area) ? std::optional(sum.area) : std::nullopt;
  row.outer = is_any(&BillRow::outer) ? std::optional(sum.outer) : std::nullopt;
  row.metal = is_any(&BillRow::metal) ? std::optional(sum.metal) : std::nullopt;
  row.fluid = is_any(&BillRow::fluid) ? std::optional(sum.fluid) : std::nullopt;
  row.remarks.emplace_back("over all rows: what lies in two parts counts twice");
  if (sum.without_volume > 0) {
    row.remarks.push_back("rows without a metal volume: " + std::to_string(sum.without_volume));
  }
  return row;
}

}  // namespace

std::string to_csv(const BillReport& report) {
  const UsualArithmetic usual;
  std::string result = head(report.bill.unit);
  for (const BillRow& row : report.bill.rows) {
    result += cells(row, row.wall, report, origin(report, row));
  }
  return result + cells(sum_of(report.bill), std::nullopt, report, {});
}

}  // namespace dupin
